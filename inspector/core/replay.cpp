// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay.h"

#include "csv_writer.h"
#include "recorder.h"
#include "tables.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace inspector {

namespace {

QString hexadecimal(uint64_t hash) { return QStringLiteral("%1").arg(hash, 16, 16, QLatin1Char('0')); }

// Where the file could be on this machine.
QStringList placesOf(const QString &path, const QString &recording, const std::vector<Level> &levels) {
    const QString name = QFileInfo(path).fileName();
    QStringList places{path, QFileInfo(recording).dir().filePath(name)};
    for (const Level &level : levels)
        if (QFileInfo(level.path).fileName() == name) places += level.path;
    return places;
}

// The maze with the recorded bytes. Nothing and one line in `error` if there is none.
QString findMaze(const MazeSource &maze, const QString &recording, const std::vector<Level> &levels, QString *error) {
    QString found;
    for (const QString &place : placesOf(maze.path, recording, levels)) {
        QFile file(place);
        if (!file.open(QIODevice::ReadOnly)) continue;
        const uint64_t hash = hashOf(file.readAll());
        if (hash == maze.hash) return place;
        if (found.isEmpty())
            found = QStringLiteral("expected a maze file with the hash %1, found '%2' with %3")
                        .arg(hexadecimal(maze.hash), place, hexadecimal(hash));
    }
    *error = found.isEmpty() ? QStringLiteral("expected the maze file '%1' there, beside the recording or among the "
                                              "levels, found none")
                                   .arg(maze.path)
                             : found;
    return {};
}

class Replay {
public:
    Replay(const Recording &recording, const Registry &registry, const std::vector<Level> &levels)
        : m_recording(recording)
        , m_registry(registry)
        , m_levels(levels) {}

    ReplayOutcome run(const std::function<bool(const Engine &)> &visit) {
        for (const Stretch &stretch : m_recording.stretches)
            if (!setUp(stretch) || !play(stretch, visit)) break;
        return std::move(m_outcome);
    }

private:
    // False: the replay can't go on, and m_outcome says why.
    bool setUp(const Stretch &stretch);
    bool openMaze(const MazeSource &maze, QString *error);
    bool play(const Stretch &stretch, const std::function<bool(const Engine &)> &visit);
    void playFailure(const Stretch &stretch);
    void compare(const phys_state &before, const QString &expected, const QString &found);

    const Recording &m_recording;
    const Registry &m_registry;
    const std::vector<Level> &m_levels;
    Conditions m_conditions;
    Scene m_scene;
    std::unique_ptr<Engine> m_engine;
    ReplayOutcome m_outcome;
};

bool Replay::openMaze(const MazeSource &maze, QString *error) {
    const QString path = findMaze(maze, m_recording.file, m_levels, error);
    if (path.isEmpty()) return false;
    m_scene = loadScene(path, error);
    return m_scene != nullptr;
}

bool Replay::setUp(const Stretch &stretch) {
    const Conditions &now = stretch.conditions;
    const auto refuse = [&](int line, const QString &reason) {
        m_outcome.error = QStringLiteral("%1:%2: %3").arg(m_recording.file).arg(line).arg(reason);
        return false;
    };
    QString error;
    const bool isNewMaze = !m_engine || !(m_conditions.maze == now.maze);
    if (isNewMaze && !openMaze(now.maze, &error)) return refuse(stretch.mazeLine, error);
    if (isNewMaze || !(m_conditions.stepper == now.stepper)) {
        const Stepper stepper = makeStepper(m_registry, now.stepper.id, m_scene, &error);
        if (!stepper) return refuse(stretch.stepperLine, error);
        if (isNewMaze)
            m_engine = std::make_unique<Engine>(m_scene, stepper);
        else
            m_engine->setStepper(stepper);
    }
    m_conditions = now;
    m_engine->setDt(now.dt);
    m_engine->setInputs(now.inputs);
    if (stretch.from) m_engine->setState(*stretch.from);
    return true;
}

bool Replay::play(const Stretch &stretch, const std::function<bool(const Engine &)> &visit) {
    for (const uint64_t expected : stretch.hashes) {
        QString error;
        const phys_state before = m_engine->state();
        if (!m_engine->step(&error)) {
            compare(before, hexadecimal(expected), error);
            return false;
        }
        compare(before, hexadecimal(expected), hexadecimal(phys_state_hash(&m_engine->state())));
        ++m_outcome.steps;
        if (!visit(*m_engine)) return false;
    }
    if (!stretch.failure.isEmpty()) playFailure(stretch);
    return true;
}

// A failed step left the state as it was, and the run went on from there.
void Replay::playFailure(const Stretch &stretch) {
    QString error;
    const phys_state before = m_engine->state();
    const bool hasStepped = m_engine->step(&error);
    compare(before, stretch.failure, hasStepped ? hexadecimal(phys_state_hash(&m_engine->state())) : error);
    if (hasStepped) m_engine->setState(before);
}

void Replay::compare(const phys_state &before, const QString &expected, const QString &found) {
    if (m_outcome.difference || expected == found) return;
    m_outcome.difference = {m_outcome.steps + 1, before.step + 1, before.time, expected, found};
}

// The versions that aren't those of the recording; each begins with a separator.
QString otherVersions(const Recording &recording, const Registry &registry) {
    QStringList others;
    const QString library = QString::fromUtf8(phys_version());
    if (recording.library != library)
        others += QStringLiteral("libphysics was %1, is %2").arg(recording.library, library);
    for (const Stretch &stretch : recording.stretches) {
        const StepperSource &stepper = stretch.conditions.stepper;
        phys_stepper_info info;
        if (phys_registry_find(registry.get(), stepper.id.constData(), &info, nullptr) != PHYS_OK) continue;
        const QString version = QString::fromUtf8(info.version);
        const QString was = QString::fromUtf8(stepper.version);
        if (was != version)
            others +=
                QStringLiteral("stepper %1 was version %2, is %3").arg(QString::fromUtf8(stepper.id), was, version);
    }
    others.removeDuplicates();
    return others.isEmpty() ? QString() : QStringLiteral("; ") + others.join(QStringLiteral("; "));
}

// What the table's first lines say: as the recording began.
Options tableOptions(const Options &options, const Recording &recording) {
    Options result = options;
    if (recording.stretches.empty()) return result;
    const Conditions &first = recording.stretches.front().conditions;
    const Inputs &inputs = first.inputs;
    result.level = levelOfFile(first.maze.path);
    result.stepper = first.stepper.id;
    result.dt = first.dt;
    result.settings = {{QStringLiteral("tilt_x"), degrees(inputs.tilt.x)},
                       {QStringLiteral("tilt_y"), degrees(inputs.tilt.y)},
                       {QStringLiteral("gravity"), inputs.gravity}};
    phys_stepper_info info;
    if (phys_registry_find(options.registry.get(), first.stepper.id.constData(), &info, nullptr) != PHYS_OK)
        return result;
    for (const phys_param_row *row : recordedRows(info))
        result.settings.push_back({QString::fromUtf8(row->id), phys_param_get(&inputs.params, row)});
    return result;
}

// Where the table goes; null if nowhere. `file` is opened if it is needed.
QIODevice *openTable(const Options &options, QFile &file, QIODevice &out, QString *error) {
    if (options.csv.isEmpty()) return options.check ? nullptr : &out;
    file.setFileName(options.csv);
    if (file.open(QIODevice::WriteOnly | QIODevice::Truncate)) return &file;
    *error = QStringLiteral("--csv: can't write '%1': %2").arg(options.csv, file.errorString());
    return nullptr;
}

} // namespace

ReplayOutcome replay(const Recording &recording, const Registry &registry, const std::vector<Level> &levels,
                     const std::function<bool(const Engine &)> &visit) {
    return Replay(recording, registry, levels).run(visit);
}

QString verdict(const Recording &recording, const Registry &registry, const ReplayOutcome &outcome) {
    const QString cut = recording.isWhole ? QString() : QStringLiteral(" (the recording is cut off after them)");
    if (!outcome.difference) return QStringLiteral("same: %1 steps").arg(outcome.steps) + cut;
    const Difference &difference = *outcome.difference;
    return QStringLiteral("differs: step %1 of the recording, step %2 since the start, from %3 s on: expected %4, "
                          "found %5")
               .arg(difference.number)
               .arg(difference.step)
               .arg(QString::fromUtf8(exactText(difference.time)), difference.expected, difference.found) +
           otherVersions(recording, registry);
}

int runReplay(const Options &options, QIODevice &out, QTextStream &messages) {
    const auto refuse = [&](const QString &line) {
        messages << "physics-inspector: " << line << '\n';
        return 2;
    };
    QString error;
    const std::optional<Recording> recording = readRecording(options.replay, options.registry, &error);
    if (!recording) return refuse(QStringLiteral("--replay: ") + error);
    QFile file;
    QIODevice *table = openTable(options, file, out, &error);
    if (!error.isEmpty()) return refuse(error);

    std::optional<CsvWriter> writer;
    if (table) writer.emplace(*table, tableOptions(options, *recording));
    const ReplayOutcome outcome = replay(*recording, options.registry, options.levels, [&](const Engine &now) {
        if (writer) writer->write(now.sample());
        return !writer || writer->isGood();
    });
    if (!outcome.error.isEmpty()) return refuse(QStringLiteral("--replay: ") + outcome.error);
    const QString line = verdict(*recording, options.registry, outcome) + QLatin1Char('\n');
    if (options.check)
        out.write(line.toUtf8());
    else
        messages << line;
    if (writer && (!writer->isGood() || (file.isOpen() && !file.flush()))) {
        messages << "physics-inspector: the table can't be written: " << table->errorString() << '\n';
        return 1;
    }
    return outcome.difference ? 1 : 0;
}

} // namespace inspector
