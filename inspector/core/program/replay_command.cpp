// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/replay_command.h"

#include "core/program/csv_writer.h"
#include "core/recording/replay.h"

#include <QFile>

#include <optional>

namespace inspector {

namespace {

// What the table's first lines say: as the recording began.
Options tableOptions(const Options &options, const Recording &recording) {
    Options result = options;
    if (recording.stretches.empty()) return result;
    const Conditions &first = recording.stretches.front().conditions;
    result.level = levelOfFile(first.maze.path);
    result.stepper = first.stepper.id;
    result.dt = first.dt;
    result.settings = settingsOf(first, options.registry);
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

int runReplay(const Options &options, QIODevice &out, QTextStream &messages) {
    const auto refuse = [&](const QString &line) {
        messages << "physics-inspector: " << line << '\n';
        return 2;
    };
    QString error;
    const auto recording = openRecording(options.replay, options.registry, options.levels, &error);
    if (!recording) return refuse(QStringLiteral("--replay: ") + error);
    QFile file;
    QIODevice *table = openTable(options, file, out, &error);
    if (!error.isEmpty()) return refuse(error);

    std::optional<CsvWriter> writer;
    if (table) writer.emplace(*table, tableOptions(options, recording->recording()));
    const ReplayOutcome outcome = replay(recording, [&](const Engine &now) {
        if (writer) writer->write(now.sample());
        return !writer || writer->isGood();
    });
    const QString line = verdict(*recording, outcome) + QLatin1Char('\n');
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
