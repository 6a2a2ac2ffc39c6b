// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/headless.h"

#include "core/engine/companion.h"
#include "core/pilot/autopilot.h"
#include "core/program/csv_writer.h"
#include "core/program/replay_command.h"
#include "core/recording/recorder.h"

#include <QFile>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace inspector {

namespace {

constexpr double kDefaultDuration = 60.0;    // s, simulated
constexpr double kAutopilotDuration = 600.0; // s, simulated

QString outcomeLine(const Level &level, const Outcome &outcome) {
    const QString name = QStringLiteral("level %1 ").arg(level.name);
    if (!outcome.error.isEmpty()) return name + QStringLiteral("failed: ") + outcome.error;
    return name + QStringLiteral("%1 %2 s (simulated), %3 steps, %4 steps/s")
                      .arg(outcome.isOut ? QStringLiteral("won in") : QStringLiteral("not won after"))
                      .arg(outcome.time, 0, 'f', 2)
                      .arg(outcome.steps)
                      .arg(outcome.stepsPerSecond(), 0, 'f', 0);
}

double durationOf(const Options &options) {
    return options.duration.value_or(options.autopilot ? kAutopilotDuration : kDefaultDuration);
}

int playAllLevels(const Options &options, QIODevice &out, QTextStream &messages) {
    int won = 0;
    for (const Level &level : options.levels) {
        QString error;
        const std::unique_ptr<Engine> engine = makeEngine(options, level, &error);
        if (!engine) {
            messages << "physics-inspector: " << error << '\n';
            return 2;
        }
        const Outcome outcome = play(*engine, {durationOf(options), false}, [](const Engine &) { return true; });
        won += outcome.isOut ? 1 : 0;
        out.write(outcomeLine(level, outcome).toUtf8() + '\n');
    }
    return won == int(options.levels.size()) ? 0 : 1;
}

bool openTable(const Options &options, QFile &file, QTextStream &messages) {
    if (options.csv.isEmpty()) return true;
    file.setFileName(options.csv);
    if (file.open(QIODevice::WriteOnly | QIODevice::Truncate)) return true;
    messages << "physics-inspector: --csv: can't write '" << options.csv << "': " << file.errorString() << '\n';
    return false;
}

std::unique_ptr<Recorder> makeRecorder(const Options &options) {
    if (options.record.isEmpty()) return nullptr;
    auto recorder = std::make_unique<Recorder>(options.record);
    recorder->setOrigin(originOf(options.registry, options.stepper, options.level.path));
    return recorder;
}

// False, and one line, if the recording isn't all there.
bool endRecording(Recorder *recorder, const Engine &engine, const Outcome &outcome, QTextStream &messages) {
    if (!recorder) return true;
    if (!outcome.error.isEmpty()) recorder->noteFailure(engine, outcome.error);
    recorder->close();
    if (!recorder->isGood()) messages << "physics-inspector: " << recorder->error() << '\n';
    return recorder->isGood();
}

// The second ball of a run, if the options ask for one, and what is said of it at the end.
class ComparedBall {
public:
    // False, and one line, if it can't be made.
    bool open(const Options &options, const Engine &engine, QTextStream &messages) {
        if (!options.comparison) return true;
        m_id = QString::fromUtf8(options.comparison->stepper);
        const auto means = makeMeans(options.registry, *options.comparison, engine.scene(), &m_refusal);
        if (means) m_companion.emplace(engine, *means, options.stepper);
        if (!means) messages << "physics-inspector: --compare: " << m_refusal << '\n';
        return means.has_value();
    }

    // After a step of the engine.
    void follow(const Engine &engine, Sample &sample) {
        if (!m_companion || !m_companion->follow(engine, &m_refusal)) return;
        m_companion->addTo(sample);
        m_largest = std::max(m_largest, m_companion->deviation().distance);
    }

    // False if it wasn't there to the end.
    bool tell(QTextStream &messages) const {
        if (!m_companion) return true;
        messages << QStringLiteral("distance to %1: %2 mm at the end, at most %3 mm\n")
                        .arg(m_id)
                        .arg(m_companion->deviation().distance * 1e3, 0, 'g', 4)
                        .arg(m_largest * 1e3, 0, 'g', 4);
        if (m_refusal.isEmpty()) return true;
        messages << "physics-inspector: --compare: at " << m_companion->state().time << " s: " << m_refusal << '\n';
        return false;
    }

private:
    QString m_id;
    std::optional<Companion> m_companion;
    double m_largest = 0.0; // distance, m
    QString m_refusal;
};

} // namespace

std::unique_ptr<Engine> makeEngine(const Options &options, const Level &level, QString *error) {
    const Scene scene = loadScene(level.path, error);
    if (!scene) return nullptr;
    const Stepper stepper = makeStepper(options.registry, options.stepper, scene, error);
    if (!stepper) return nullptr;

    Parameters parameters;
    phys_stepper_info info;
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, nullptr) == PHYS_OK)
        parameters.setStepper(info);
    if (!parameters.set(options.settings, error)) return nullptr;

    auto engine = std::make_unique<Engine>(scene, stepper);
    engine->setDt(options.dt);
    engine->setInputs(parameters.inputs());
    if (!options.autopilot) return engine;
    const std::shared_ptr<const Autopilot> pilot = Autopilot::create(scene.get(), error);
    if (!pilot) return nullptr;
    engine->setPilot(pilot);
    return engine;
}

Outcome play(Engine &engine, const Limits &limits, const std::function<bool(const Engine &)> &visit) {
    Outcome outcome;
    const auto begin = std::chrono::steady_clock::now();
    // Counted in whole steps: the last one reaches the duration, but for rounding.
    const double count = std::ceil(limits.duration / engine.dt() - 1e-6);
    while (double(outcome.steps) < count && !(outcome.isOut && !limits.goesOn)) {
        if (!engine.step(&outcome.error)) break;
        ++outcome.steps;
        outcome.isOut = outcome.isOut || (engine.state().flags & PHYS_OUT) != 0;
        if (!visit(engine)) break;
    }
    outcome.time = engine.state().time;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
}

int runHeadless(const Options &options, QIODevice &out, QTextStream &messages) {
    if (options.action == Options::Action::PlayAllLevels) return playAllLevels(options, out, messages);
    if (options.action == Options::Action::Replay) return runReplay(options, out, messages);
    QString error;
    const std::unique_ptr<Engine> engine = makeEngine(options, options.level, &error);
    if (!engine) {
        messages << "physics-inspector: " << error << '\n';
        return 2;
    }
    ComparedBall other;
    if (!other.open(options, *engine, messages)) return 2;
    QFile file;
    if (!openTable(options, file, messages)) return 2;
    QIODevice &table = options.csv.isEmpty() ? out : file;

    const std::unique_ptr<Recorder> recorder = makeRecorder(options);
    CsvWriter writer(table, options);
    const Limits limits{durationOf(options), options.duration.has_value()};
    const Outcome outcome = play(*engine, limits, [&](const Engine &now) {
        Sample sample = now.sample();
        other.follow(now, sample);
        writer.write(sample);
        if (recorder) recorder->note(now);
        return writer.isGood();
    });
    const bool isRecorded = endRecording(recorder.get(), *engine, outcome, messages);
    messages << outcomeLine(options.level, outcome) << '\n';
    const bool isCompared = other.tell(messages);
    if (!writer.isGood() || !(options.csv.isEmpty() || file.flush())) {
        messages << "physics-inspector: the table can't be written: " << table.errorString() << '\n';
        return 1;
    }
    const bool hadToWin = options.autopilot && !options.duration;
    return !outcome.error.isEmpty() || !isRecorded || !isCompared || (hadToWin && !outcome.isOut) ? 1 : 0;
}

} // namespace inspector
