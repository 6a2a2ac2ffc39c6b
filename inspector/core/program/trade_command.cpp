// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/trade_command.h"

#include "core/program/csv_writer.h"
#include "core/program/ending.h"
#include "core/program/failure.h"
#include "core/program/long_work.h"
#include "core/program/outputs.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/setup/tables.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_svg.h"
#include "core/trade/trade_table.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

TradePlan tradePlanOf(const Options &options) {
    QString error;
    TradePlan plan;
    plan.registry = options.registry;
    plan.scene = loadScene(options.level.path, &error);
    if (!plan.scene) throw Failure{2, error};
    // The values of the command line; steppers' own values are initial here, where all steppers run.
    Parameters parameters;
    if (!setParameters(options, parameters, &error)) throw Failure{2, error};
    plan.inputs = parameters.inputs();
    const TradeOptions &wish = options.trade;
    plan.stepSizes = wish.stepSizes;
    plan.withOrientation = wish.withOrientation;
    plan.unknowns = wish.unknowns;
    plan.share = wish.share;
    plan.horizon = wish.seconds.value_or(kTradeHorizon);
    const double duration = options.duration.value_or(std::max(kTradeDuration, wish.seconds.value_or(0.0)));
    const bool isGiven = wish.schedule != TradeOptions().schedule;
    if (!makeSchedules(wish.schedule, duration, plan, &error))
        throw Failure{2, (isGiven ? QStringLiteral("--schedule: ") : QStringLiteral("--trade: ")) + error};
    return plan;
}

struct Measured {
    TradePlan plan;
    TradeResult result;
};

Measured measure(const Options &options, QTextStream *progress) {
    QString error;
    LongWork work(progress, QStringLiteral("schedules"));
    TradePlan plan = tradePlanOf(options);
    TradeListener listener;
    listener.progressed = [&work](double share, const QString &what) { work.progressed(share, what); };
    std::optional<TradeResult> result = measureTrade(plan, listener, work.stop(), &error);
    if (endingSignal()) throw Failure{statusAfter(endingSignal()), QStringLiteral("--trade: ended before its end")};
    if (!result) throw Failure{2, error};
    return {std::move(plan), *std::move(result)};
}

void writeFile(const QString &option, const QString &path, const QByteArray &bytes) {
    QString error;
    const auto file = OutputFile::open(path, Existing::Replace, {}, &error);
    if (file && file->write(bytes) == bytes.size() && file->finish()) return;
    throw Failure{1, option + QStringLiteral(": ") + (file ? file->problem() : error)};
}

void writeFiles(const Options &options, const TradePlan &plan, const TradeResult &result,
                const TradePictureWriter &writePicture) {
    const QString option = QStringLiteral("--plot");
    const uint32_t model = plan.inputs.params.model;
    const QString &plot = options.trade.plot;
    QString error;
    if (!isStandardOutput(options.csv) &&
        !writeTable(options.csv, tradeCsv(result.points), tradeSettings(options, plan), &error))
        throw Failure{1, QStringLiteral("--csv: ") + error};
    if (plot.isEmpty()) return;
    const ChartDescription chart = describeChart(plan, result, model, shownSchedule(result));
    if (plot.endsWith(QLatin1String(".svg"))) return writeFile(option, plot, tradeSvg(chart));
    if (!writePicture(chart, plot, &error)) throw Failure{1, option + QStringLiteral(": ") + error};
}

QString nameOf(const TradePoint &point) {
    return QStringLiteral("--stepper %1 --dt %2")
        .arg(QString::fromUtf8(point.stepper))
        .arg(point.dt, 0, 'g', QLocale::FloatingPointShortest);
}

QString whyOf(const TradePoint &point, double seconds, double radius) {
    const double error = errorUntil(point, seconds);
    return QStringLiteral("error %1 mm = %2 R in %3 s, %4 ns a step, %5 µs a simulated second")
        .arg(error * radius * 1e3, 0, 'g', 3)
        .arg(error, 0, 'g', 3)
        .arg(seconds, 0, 'g', 4)
        .arg(point.cost.perStep * 1e9, 0, 'g', 3)
        .arg(point.cost.perSecond * 1e6, 0, 'g', 3);
}

} // namespace

QByteArray tradeSettings(const Options &options, const TradePlan &plan) {
    QByteArray text = settingsHead(options);
    for (const TiltSchedule &schedule : plan.schedules)
        text += "schedule " + oneLine(schedule.name).toUtf8() + ", " + exactText(schedule.duration) + " s\n";
    text += "steps";
    for (const double dt : plan.stepSizes) text += " " + exactText(dt);
    text += " s\nunknown " + (plan.unknowns.empty() ? QByteArray("none") : unknownsText(plan.unknowns).toUtf8());
    text += "\nshare " + exactText(plan.share) + "\nhorizon " + exactText(plan.horizon) + " s\n";
    text += QByteArray("orientation ") + (plan.withOrientation ? "on" : "off") + "\n";
    Parameters parameters;
    parameters.set(options.settings);
    return text + parameterLines(parameters);
}

Recommendation recommend(const TradeResult &result, uint32_t model, const TradeOptions &wish, double radius) {
    const std::vector<TradePoint> points = result.valid(model);
    const double compared = result.compared(model);
    const double seconds = std::min(wish.seconds.value_or(compared), compared);
    const std::optional<size_t> best = wish.within ? mostAccurateWithin(points, *wish.within)
                                                   : cheapestUnder(points, wish.under.inRadii(radius), seconds);
    QString limit;
    if (wish.seconds && *wish.seconds > compared)
        limit = QStringLiteral(" (%1 s were asked for; beyond %2 s there is nothing to compare with)")
                    .arg(*wish.seconds)
                    .arg(compared);
    if (best)
        return {points[*best],
                nameOf(points[*best]) + QStringLiteral("  # ") + whyOf(points[*best], seconds, radius) + limit,
                seconds};
    if (wish.within) return {std::nullopt, QStringLiteral("none: no step takes %1 ns or less").arg(*wish.within)};
    return {std::nullopt, QStringLiteral("none: nothing keeps the error at or under %1 R for %2 s")
                                  .arg(wish.under.inRadii(radius), 0, 'g', 3)
                                  .arg(seconds) +
                              limit};
}

QString passedOverText(const GoodEnough &answer, const QString &name) {
    const PassedOver &cheapest = answer.passedOver.front();
    const QString fault = cheapest.share ? QStringLiteral("is off by %1 %").arg(*cheapest.share * 100.0, 0, 'g', 2)
                                         : QStringLiteral("fails");
    const QString text = QStringLiteral("; cheaper %1 %2 on an unseen schedule").arg(name, fault);
    const size_t others = answer.passedOver.size() - 1;
    return others == 0 ? text : text + QStringLiteral(", and %1 more likewise").arg(others);
}

QString shortSchedulesText(const TradePlan &plan) {
    if (plan.askedHorizon <= plan.horizon) return {};
    return QStringLiteral("; %1 s were asked for, the schedules end after %2 s")
        .arg(plan.askedHorizon)
        .arg(plan.horizon, 0, 'g', 3);
}

Recommendation recommendForUnknowns(const TradePlan &plan, const TradeResult &result) {
    if (!result.goodEnough)
        return {std::nullopt, QStringLiteral("none: every error reaches %1 % of what isn't known after %2 s")
                                      .arg(plan.share * 100.0)
                                      .arg(plan.horizon) +
                                  shortSchedulesText(plan)};
    const TradePoint &point = result.points[result.goodEnough->point];
    const std::vector<PassedOver> &cheaper = result.goodEnough->passedOver;
    const QString passedOver =
        cheaper.empty() ? QString() : passedOverText(*result.goodEnough, nameOf(result.points[cheaper[0].point]));
    return {point, nameOf(point) +
                       QStringLiteral("  # error at most %1 % of what isn't known, in %2 s on %3 schedules; "
                                      "%4 ns a step, %5 µs a simulated second")
                           .arg(result.goodEnough->largest * 100.0, 0, 'g', 2)
                           .arg(plan.horizon)
                           .arg(result.goodEnough->validations + int(plan.schedules.size()))
                           .arg(point.cost.perStep * 1e9, 0, 'g', 3)
                           .arg(point.cost.perSecond * 1e6, 0, 'g', 3) +
                       passedOver + shortSchedulesText(plan)};
}

int runTrade(const Options &options, const TradeStreams &streams, const TradePictureWriter &writePicture) {
    try {
        const auto [plan, result] = measure(options, streams.progress);
        // With --csv - the table occupies standard output, so that the report goes to messages.
        const bool isCsv = options.csv == QLatin1String("-");
        QTextStream &text = isCsv ? streams.messages : streams.out;
        if (isCsv) streams.out << tradeCsv(result.points);
        text << "level " << oneLine(options.level.name) << '\n'
             << tradeSummary(plan, result).join(QLatin1Char('\n')) << "\n\n"
             << tradeText(plan, result) << '\n';
        writeFiles(options, plan, result, writePicture);
        const double radius = phys_scene_radius(plan.scene.get());
        const Recommendation answer = recommend(result, plan.inputs.params.model, options.trade, radius);
        if (!plan.unknowns.empty())
            text << "good enough for what is known: " << recommendForUnknowns(plan, result).line << '\n';
        text << "recommended: " << answer.line << '\n';
        return answer.point ? 0 : 1;
    } catch (const Failure &failure) {
        report(streams.messages, failure.line);
        return failure.status;
    }
}

} // namespace inspector
