// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/fit_command.h"

#include "core/program/csv_writer.h"
#include "core/program/ending.h"
#include "core/program/failure.h"
#include "core/program/long_work.h"
#include "core/program/outputs.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"
#include "core/track/fit_report.h"
#include "core/track/track_reader.h"

#include <algorithm>

namespace inspector {

namespace {

FitPlan fitPlanOf(const Options &options) {
    QString error;
    FitPlan plan;
    plan.registry = options.registry;
    plan.scene = loadScene(options.level.path, &error);
    if (!plan.scene) throw Failure{2, error};
    std::optional<Track> track = readTrackFile(options.fit.track, options.fit.units, &error);
    if (!track) throw Failure{2, QStringLiteral("--fit: ") + error};
    plan.track = std::move(*track);
    Parameters parameters;
    if (!parameters.set(options.settings, &error)) throw Failure{2, error};
    const Inputs inputs = parameters.inputs();
    plan.begin = {inputs.params, inputs.gravity, {}, 0.0, options.fit.frame};
    plan.quantities = options.fit.quantities;
    const auto isModel = [](const Setting &setting) { return setting.id == QLatin1String("model"); };
    if (std::any_of(options.settings.begin(), options.settings.end(), isModel)) plan.model = inputs.params.model;
    return plan;
}

TrackFit measure(const FitPlan &plan, QTextStream *progress) {
    QString error;
    LongWork work(progress, QStringLiteral("start of the track"));
    const FitProgress listener = [&work](double share, const QString &what) { work.progressed(share, what); };
    std::optional<TrackFit> fit = fitTrack(plan, listener, work.stop(), &error);
    if (endingSignal()) throw Failure{statusAfter(endingSignal()), QStringLiteral("--fit: ended before its end")};
    if (!fit) throw Failure{2, QStringLiteral("--fit: ") + error};
    return std::move(*fit);
}

/// The tilt's offset and delay that were set: the command line can't do that.
QByteArray typedLines(BoardParameters begin) {
    QByteArray text;
    for (const FitQuantity &quantity : fitQuantities()) {
        const bool isTyped = quantity.id.startsWith(QLatin1String("tilt")) || quantity.id == QLatin1String("delay");
        const double value = isTyped ? quantity.of(begin) / quantity.perUnit : 0.0;
        if (value != 0.0)
            text += (quantity.id + QLatin1Char(' ')).toUtf8() + exactText(value) + " " + quantity.unit.toUtf8() + "\n";
    }
    return text;
}

} // namespace

QByteArray fitSettings(const Options &options, const FitPlan &plan, const QStringList &report) {
    const TrackFrame &frame = plan.begin.frame;
    QStringList ids;
    for (const FitQuantity &quantity : plan.quantities) ids += quantity.id;
    Parameters parameters;
    parameters.set(options.settings);
    QByteArray text = settingsHead(options) + "track " + oneLine(options.fit.track).toUtf8() + "\n";
    if (!options.fit.unitWords.isEmpty()) text += "track-units " + oneLine(options.fit.unitWords).toUtf8() + "\n";
    text += "track-frame " + exactText(frame.x * 1e3) + "," + exactText(frame.y * 1e3) + "," +
            exactText(degrees(frame.angle)) + "," + exactText(frame.scale) + "\n";
    text +=
        typedLines(plan.begin) + "fit-for " + ids.join(QLatin1Char(',')).toUtf8() + "\n" + parameterLines(parameters);
    for (const QString &line : report) text += oneLine(line).toUtf8() + "\n";
    return text;
}

int runFit(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress) {
    try {
        const FitPlan plan = fitPlanOf(options);
        const TrackFit fit = measure(plan, progress);
        // With --csv - the table occupies standard output, so that the report goes to messages.
        const bool isCsv = options.csv == QLatin1String("-");
        QTextStream standard(&out);
        QTextStream &text = isCsv ? messages : standard;
        const QStringList report = fitReport(plan, fit) + QStringList(QStringLiteral("options: ") + fitOptions(fit));
        text << "level " << oneLine(options.level.name) << '\n';
        for (const QString &line : report) text << oneLine(line) << '\n';
        text.flush();
        if (isCsv) out.write(fitCsv(fit.best()));
        QString error;
        if (!isStandardOutput(options.csv) &&
            !writeTable(options.csv, fitCsv(fit.best()), fitSettings(options, plan, report), &error))
            throw Failure{1, QStringLiteral("--csv: ") + error};
        return fit.isExplained() ? 0 : 1;
    } catch (const Failure &failure) {
        report(messages, failure.line);
        return failure.status;
    }
}

} // namespace inspector
