// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/replay_command.h"

#include "core/program/csv_writer.h"
#include "core/program/ending.h"
#include "core/program/outputs.h"
#include "core/program/run_settings.h"
#include "core/recording/replay.h"
#include "core/setup/lines.h"

#include <optional>

namespace inspector {

namespace {

/// The stream of the table.
enum class Place { Nowhere, Output, File };

Place placeOfTable(const Options &options) {
    if (options.csv.isEmpty()) return options.check ? Place::Nowhere : Place::Output;
    return isStandardOutput(options.csv) ? Place::Output : Place::File;
}

} // namespace

int runReplay(const Options &options, QIODevice &out, QTextStream &messages) {
    const auto refuse = [&](const QString &line) {
        report(messages, line);
        return 2;
    };
    QString error;
    const auto recording = openRecording(options.replay, options.registry, options.levels, &error);
    if (!recording) return refuse(QStringLiteral("--replay: ") + error);
    const Place place = placeOfTable(options);
    const QString remark = QStringLiteral("of %1\n").arg(quoted(options.replay));
    const QByteArray settings = recordingSettings(*recording) + remark.toUtf8();
    const std::unique_ptr<OutputFile> file = place == Place::File ? openTable(options.csv, settings, &error) : nullptr;
    if (place == Place::File && !file) return refuse(QStringLiteral("--csv: ") + error);

    std::optional<CsvWriter> writer;
    if (place != Place::Nowhere) writer.emplace(file ? *file : out, tableShape(options));
    const ReplayOutcome outcome = replay(recording, [&](const Engine &now) {
        if (writer) writer->write(now.sample());
        return (!writer || writer->isGood()) && endingSignal() == 0;
    });
    if (endingSignal()) return statusAfter(endingSignal());
    const bool isWritten = file ? file->finish() : !writer || writer->isGood();
    if (file && !isWritten) report(messages, QStringLiteral("--csv: ") + file->problem());
    if (!isWritten) return 1; // the comparison is incomplete
    const QString line = oneLine(verdict(*recording, outcome)) + QLatin1Char('\n');
    if (options.check && place != Place::Output)
        out.write(line.toUtf8());
    else
        messages << line;
    return outcome.difference ? 1 : 0;
}

} // namespace inspector
