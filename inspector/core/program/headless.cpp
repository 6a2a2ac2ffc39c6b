// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/headless.h"

#include "core/engine/ghost_engine.h"
#include "core/pilot/autopilot.h"
#include "core/program/csv_writer.h"
#include "core/program/ending.h"
#include "core/program/failure.h"
#include "core/program/fit_command.h"
#include "core/program/outputs.h"
#include "core/program/replay_command.h"
#include "core/recording/recorder.h"
#include "core/setup/lines.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace inspector {

namespace {

constexpr double kDefaultDuration = 60.0;    ///< s, simulated
constexpr double kAutopilotDuration = 600.0; ///< s, simulated
constexpr double kDurationRounding = 1e-12;  ///< share of a duration

QString outcomeLine(const Level &level, const Outcome &outcome) {
    const QString name = QStringLiteral("level %1 ").arg(oneLine(level.name));
    if (!outcome.error.isEmpty()) return name + QStringLiteral("failed: ") + outcome.error;
    const QString fault = outcome.startFault.isEmpty() ? QString() : QStringLiteral("; ") + outcome.startFault;
    return name + QStringLiteral("%1 %2 s (simulated), %3 steps, %4 steps/s%5")
                      .arg(outcome.isWon() ? QStringLiteral("won in") : QStringLiteral("not won after"))
                      .arg(outcome.left ? outcome.left->time : outcome.time, 0, 'f', 2)
                      .arg(outcome.steps)
                      .arg(outcome.stepsPerSecond(), 0, 'f', 0)
                      .arg(fault);
}

double durationOf(const Options &options) {
    return options.duration.value_or(options.autopilot ? kAutopilotDuration : kDefaultDuration);
}

/// Whole steps: the last one reaches the duration, s, up to the rounding of both.
double stepCount(double duration, double dt) { return std::ceil(duration / dt * (1.0 - kDurationRounding)); }

int playAllLevels(const Options &options, QIODevice &out) {
    int won = 0;
    for (const Level &level : options.levels) {
        Outcome outcome;
        if (const std::unique_ptr<Engine> engine = makeEngine(options, level, &outcome.error))
            outcome = play(*engine, {durationOf(options), false}, [](const Engine &) { return endingSignal() == 0; });
        if (endingSignal()) return statusAfter(endingSignal());
        won += outcome.isWon() ? 1 : 0;
        if (out.write(outcomeLine(level, outcome).toUtf8() + '\n') < 0) return 1;
    }
    return won == int(options.levels.size()) ? 0 : 1;
}

std::unique_ptr<Recorder> makeRecorder(const Options &options) {
    if (options.record.isEmpty()) return nullptr;
    auto recorder = std::make_unique<Recorder>(options.record);
    recorder->setOrigin(originOf(options.registry, options.stepper, options.level.path));
    return recorder;
}

/// Returns false, with one line, if the recording is incomplete.
bool endRecording(Recorder *recorder, const Engine &engine, const Outcome &outcome, QTextStream &messages) {
    if (!recorder) return true;
    if (!outcome.error.isEmpty()) recorder->noteFailure(engine, outcome.error);
    recorder->close();
    if (!recorder->isGood()) report(messages, recorder->error());
    return recorder->isGood();
}

/// The ghost of a run, if the options ask for one, and its summary.
class ComparedBall {
public:
    /// Throws Failure if it can't be made.
    ComparedBall(const Options &options, const Engine &engine) {
        if (!options.comparison) return;
        m_id = QString::fromUtf8(options.comparison->stepper);
        auto setup = makeGhostSetup(options.registry, *options.comparison, engine.scene(), &m_refusal);
        if (!setup) throw Failure{2, QStringLiteral("--compare: ") + m_refusal};
        if (!options.comparisonSettings.empty()) setup->own = ghostsInputs(options, nullptr);
        m_ghost.emplace(engine, *setup, options.stepper);
    }

    /// Called after a step of the engine.
    void follow(const Engine &engine, Sample &sample) {
        if (!m_ghost || !m_ghost->follow(engine, &m_refusal)) return;
        m_ghost->addTo(sample);
        m_largest = std::max(m_largest, m_ghost->deviation().distance);
    }

    /// Prints the summary. False if the ghost failed before the end.
    bool tell(QTextStream &messages) const {
        if (!m_ghost) return true;
        messages << QStringLiteral("distance to %1: %2 mm at the end, at most %3 mm\n")
                        .arg(m_id)
                        .arg(m_ghost->deviation().distance * 1e3, 0, 'g', 4)
                        .arg(m_largest * 1e3, 0, 'g', 4);
        if (m_refusal.isEmpty()) return true;
        report(messages, QStringLiteral("--compare: at %1 s: %2").arg(m_ghost->state().time).arg(m_refusal));
        return false;
    }

private:
    QString m_id;
    std::optional<GhostEngine> m_ghost;
    double m_largest = 0.0; ///< distance, m
    QString m_refusal;
};

/// An engine that has a step to make. Throws Failure.
std::unique_ptr<Engine> openEngine(const Options &options) {
    QString error;
    std::unique_ptr<Engine> engine = makeEngine(options, options.level, &error);
    if (!engine) throw Failure{2, error};
    if (stepCount(durationOf(options), engine->dt()) < 1.0)
        throw Failure{1, QStringLiteral("no step in %1 s: nothing to write").arg(durationOf(options))};
    return engine;
}

/// The file for the table; nullptr: standard output. Throws Failure.
std::unique_ptr<OutputFile> openTableFile(const Options &options) {
    if (isStandardOutput(options.csv)) return nullptr;
    QString error;
    std::unique_ptr<OutputFile> file = openTable(options.csv, tableSettings(options), &error);
    if (!file) throw Failure{2, QStringLiteral("--csv: ") + error};
    return file;
}

/// Runs one level's ball and writes its table. Returns the exit status, or throws Failure if it can't begin.
int runBall(const Options &options, QIODevice &out, QTextStream &messages) {
    const std::unique_ptr<Engine> engine = openEngine(options);
    ComparedBall other(options, *engine);
    const std::unique_ptr<OutputFile> file = openTableFile(options);
    const std::unique_ptr<Recorder> recorder = makeRecorder(options);
    CsvWriter writer(file ? *file : out, tableShape(options));
    const Limits limits{durationOf(options), options.duration.has_value()};
    const Outcome outcome = play(*engine, limits, [&](const Engine &now) {
        Sample sample = now.sample();
        other.follow(now, sample);
        writer.write(sample);
        if (recorder) recorder->note(now);
        return writer.isGood() && endingSignal() == 0;
    });
    const bool isRecorded = endRecording(recorder.get(), *engine, outcome, messages);
    const bool isWhole = writer.isGood(); // otherwise the run ended early, as where a pipe was closed
    if (isWhole) messages << outcomeLine(options.level, outcome) << '\n';
    if (isWhole && outcome.steps > 0 && outcome.steps < options.csvEvery)
        report(messages,
               QStringLiteral("--csv-every: the table has no row, as the run ends at step %1").arg(outcome.steps));
    const bool isCompared = !isWhole || other.tell(messages);
    const bool isWritten = file ? file->finish() : isWhole;
    if (file && !isWritten) report(messages, QStringLiteral("--csv: ") + file->problem());
    if (endingSignal()) return statusAfter(endingSignal());
    const bool hadToWin = options.autopilot && !options.duration;
    const bool hasFailed = !outcome.error.isEmpty() || (hadToWin && !outcome.isWon());
    return hasFailed || !isWritten || !isRecorded || !isCompared ? 1 : 0;
}

} // namespace

std::unique_ptr<Engine> makeEngine(const Options &options, const Level &level, QString *error) {
    const Scene scene = loadScene(level.path, error);
    if (!scene) return nullptr;
    const Stepper stepper = makeStepper(options.registry, options.stepper, scene, error);
    if (!stepper) return nullptr;

    Parameters parameters;
    if (!setParameters(options, parameters, error)) return nullptr;

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
    outcome.startFault = startFault(engine.scene().get(), engine.state().position);
    const auto begin = std::chrono::steady_clock::now();
    const double count = stepCount(limits.duration, engine.dt());
    while (double(outcome.steps) < count && !(outcome.left && !limits.goesOn)) {
        if (!engine.step(&outcome.error)) break;
        ++outcome.steps;
        const BoardSide side = boardSide(engine.scene().get(), engine.state().position);
        if (!outcome.left && side != BoardSide::Within) outcome.left = {engine.state().time, side};
        if (!visit(engine)) break;
    }
    outcome.time = engine.state().time;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
}

int runHeadless(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress) {
    if (options.action == Options::Action::PlayAllLevels) return playAllLevels(options, out);
    if (options.action == Options::Action::Replay) return runReplay(options, out, messages);
    if (options.action == Options::Action::Fit) return runFit(options, out, messages, progress);
    try {
        return runBall(options, out, messages);
    } catch (const Failure &failure) {
        report(messages, failure.line);
        return failure.status;
    }
}

} // namespace inspector
