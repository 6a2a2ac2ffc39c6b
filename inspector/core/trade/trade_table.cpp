// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_table.h"

#include "core/schedule/trade_reference.h"
#include "core/setup/tables.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

using Figure = std::optional<double>;

Figure ifCompared(const TradePoint &point, double value) { return point.isValid ? Figure(value) : std::nullopt; }
Figure ifTimed(const TradePoint &point, double value) { return point.cost.repeats > 0 ? Figure(value) : std::nullopt; }

QByteArray exactly(double value) { return QByteArray::number(value, 'g', QLocale::FloatingPointShortest); }

QString padded(const QString &text, int width) { return text.rightJustified(width); }

QStringList cellsOf(const TradePoint &point) {
    QStringList cells{QString::fromUtf8(point.stepper), stepSizeText(point.dt), modelName(point.model)};
    for (const TradeColumn &column : tradeColumns()) cells += figureText(column, point);
    return cells;
}

QString spanLine(uint32_t model, const TradeSpan &span) {
    const QString name = modelName(model);
    if (span.compared <= 0.0) return QStringLiteral("%1: no reference").arg(name);
    const QString until = QStringLiteral("%1: compared up to %2 s").arg(name).arg(span.compared, 0, 'f', 2);
    if (span.isSensitive)
        return until +
               QStringLiteral(", the horizon: a push of %1 radii every %2 s moves the ball by over %3 R after it")
                   .arg(TradeReference::kPush)
                   .arg(kScheduleHold)
                   .arg(TradeReference::kVisible);
    return until + (span.endReason.isEmpty() ? QStringLiteral(", the whole schedule; no horizon before its end")
                                             : QStringLiteral(": ") + span.endReason);
}

QString impactsText(const TradeSpan &span, double horizon) {
    const QString counts = QStringLiteral("%1 impacts in %2 s, %3 in %4 s")
                               .arg(span.early)
                               .arg(horizon)
                               .arg(span.impacts)
                               .arg(span.end, 0, 'g', 4);
    if (span.impacts == 0) return counts + QStringLiteral("; it meets no wall: says nothing of runs that do");
    return span.early > 0
               ? counts
               : counts + QStringLiteral("; it meets no wall in %1 s: says nothing of runs that do").arg(horizon);
}

/// How far ahead the ball is predictable.
QString knowableText(const TradeSpan &span) {
    const auto text = [&](const char *cause, const std::optional<double> &time) {
        return time ? QStringLiteral("%1 moves the ball by a radius after %2 s").arg(cause).arg(*time, 0, 'f', 2)
                    : QStringLiteral("%1 doesn't within %2 s").arg(cause).arg(span.end, 0, 'f', 2);
    };
    const std::optional<double> rounding = span.knowable < span.end ? std::optional(span.knowable) : std::nullopt;
    if (span.band.isEmpty()) return text("rounding", rounding);
    return text("what isn't known", span.band.timeUntil(1.0)) + QStringLiteral(", ") + text("rounding", rounding);
}

QString bandText(const TradePlan &plan, const Band &band) {
    const double radius = phys_scene_radius(plan.scene.get());
    QString text =
        QStringLiteral("not known after %1 s: the ball is off by %2 mm, half the boards below and half above")
            .arg(plan.horizon)
            .arg(band.middleAt(plan.horizon) * radius * 1e3, 0, 'g', 3);
    if (band.refused > 0)
        text += QStringLiteral("; exact can't step %1 of %2 boards").arg(band.refused).arg(band.refused + band.balls);
    return text;
}

} // namespace

const std::vector<TradeColumn> &tradeColumns() {
    using P = const TradePoint &;
    constexpr double kDegrees = 57.29577951308232;
    static const std::vector<TradeColumn> columns{
        {"position_largest [R]", "max error", "R",
         "largest position error against exact in the whole comparison, on the worst schedule, in radii", 1.0,
         [](P p) { return ifCompared(p, p.error.positionLargest); }, "in all"},
        {"share_of_unknown [%]", "of unknown", "%",
         "largest position error within the horizon, on the worst schedule, as a share of how far the ball is off "
         "because the board isn't "
         "known exactly",
         100.0, [](P p) { return p.isValid ? p.share : std::nullopt; }, "in %1 s"},
        {"position_final [R]", "end error", "R", "position error at the end of the comparison, in radii", 1.0,
         [](P p) { return ifCompared(p, p.error.positionFinal); }},
        {"velocity_largest [m/s]", "velocity", "m/s",
         "largest velocity error; large for a moment when a bounce comes early or late", 1.0,
         [](P p) { return ifCompared(p, p.error.velocityLargest); }},
        {"orientation_largest [deg]", "turn", "deg", "largest error of the orientation; none: it isn't computed",
         kDegrees, [](P p) { return p.isValid ? p.error.orientationLargest : std::nullopt; }},
        {"energy_drift [J/kg]", "energy", "J/kg", "energy made (> 0) or lost (< 0) by the scheme itself", 1.0,
         [](P p) { return ifCompared(p, p.error.energyDrift); }},
        {"penetration_largest [R]", "overlap", "R", "deepest overlap with a box, in radii", 1.0,
         [](P p) { return ifCompared(p, p.error.penetrationLargest); }},
        {"time_until_wrong [s]", "right for", "s", "when the position error first passes 0.1 R; none: never", 1.0,
         [](P p) { return p.isValid ? p.error.timeUntilWrong : std::nullopt; }},
        {"wrong_impacts", "wrong hits", "", "impacts on walls that are missing, invented or out of order", 1.0,
         [](P p) { return ifCompared(p, p.error.wrongImpacts); }},
        {"model_error [R]", "model", "R",
         "largest distance between the rolling and the rigid model, both exact: what the simpler model costs", 1.0,
         [](P p) { return p.isValid ? p.error.model : std::nullopt; }},
        {"steps", "steps", "", "of the whole schedule", 1.0,
         [](P p) { return p.steps > 0 ? Figure(double(p.steps)) : std::nullopt; }},
        {"cpu_per_step [ns]", "CPU per step", "ns", "CPU time of a step, median of the repeats", 1e9,
         [](P p) { return ifTimed(p, p.cost.perStep); }},
        {"cpu_per_second [us]", "CPU per s", "us", "CPU time of a simulated second, median of the repeats", 1e6,
         [](P p) { return ifTimed(p, p.cost.perSecond); }},
        {"cpu_spread [%]", "spread", "%", "between the quartiles of the repeats, share of the median", 100.0,
         [](P p) { return ifTimed(p, p.cost.spread); }},
        {"repeats", "repeats", "", "of the timing", 1.0, [](P p) { return Figure(p.cost.repeats); }},
    };
    return columns;
}

QString figureText(const TradeColumn &column, const TradePoint &point) {
    const std::optional<double> value = column.value(point);
    if (!value) return QStringLiteral("–");
    const double figure = *value * column.scale;
    const bool isWhole = !column.unit[0] || figure == 0.0 || (std::abs(figure) >= 1e3 && std::abs(figure) < 1e7);
    return isWhole ? QString::number(figure, 'f', 0) : QString::number(figure, 'g', 3);
}

QStringList tradeSummary(const TradePlan &plan, const TradeResult &result) {
    QStringList lines;
    const uint32_t model = plan.inputs.params.model;
    if (!plan.unknowns.empty()) lines += QStringLiteral("unknown: ") + unknownsText(plan.unknowns);
    for (size_t i = 0; i < result.spans.size(); ++i) {
        const auto &spans = result.spans[i];
        const TradeSpan &span = spans[model];
        lines += QStringLiteral("schedule %1, %2 s: %3")
                     .arg(plan.schedules[i].name)
                     .arg(plan.schedules[i].duration, 0, 'g', 6)
                     .arg(impactsText(span, plan.horizon));
        for (const uint32_t each : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID})
            lines += QStringLiteral("  ") + spanLine(each, spans[each]);
        if (span.compared > 0.0) lines += QStringLiteral("  ") + knowableText(span);
        if (!span.band.isEmpty()) lines += QStringLiteral("  ") + bandText(plan, span.band);
    }
    return lines;
}

QString spanAndUnit(const TradeColumn &column, const QString &unit, double horizon) {
    QStringList words;
    if (column.span[0]) words += QString::fromUtf8(column.span).replace(QLatin1String("%1"), QString::number(horizon));
    if (!unit.isEmpty()) words += QLatin1Char('[') + unit + QLatin1Char(']');
    return words.join(QLatin1Char(' '));
}

QString tradeText(const TradePlan &plan, const TradeResult &result) {
    QStringList header{QStringLiteral("stepper"), QStringLiteral("dt"), QStringLiteral("model")};
    for (const TradeColumn &column : tradeColumns())
        header +=
            QStringLiteral("%1 %2")
                .arg(QString::fromUtf8(column.label), spanAndUnit(column, QString::fromUtf8(column.unit), plan.horizon))
                .trimmed();
    std::vector<QStringList> rows{header};
    for (const TradePoint &point : result.points) rows.push_back(cellsOf(point));
    std::vector<int> widths(size_t(header.size()), 0);
    for (const QStringList &row : rows)
        for (size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], int(row[qsizetype(i)].size()));

    QString text;
    for (size_t r = 0; r < rows.size(); ++r) {
        QString line = rows[r][0].leftJustified(widths[0]);
        for (size_t i = 1; i < widths.size(); ++i)
            line += QStringLiteral("  ") + padded(rows[r][qsizetype(i)], widths[i]);
        if (r > 0 && !result.points[r - 1].note.isEmpty()) line += QStringLiteral("  ") + result.points[r - 1].note;
        text += line + QLatin1Char('\n');
    }
    return text;
}

QByteArray tradeCsvHeader(char separator) {
    QByteArrayList names{"stepper", "dt [s]", "model"};
    for (const TradeColumn &column : tradeColumns()) names += column.id;
    return (names << "note").join(separator) + '\n';
}

QByteArray tradeCsv(const std::vector<TradePoint> &points, char separator) {
    QByteArray csv = tradeCsvHeader(separator);
    for (const TradePoint &point : points) {
        QByteArrayList fields{point.stepper, exactly(point.dt), modelName(point.model).toUtf8()};
        for (const TradeColumn &column : tradeColumns()) {
            const std::optional<double> value = column.value(point);
            fields += value ? exactly(*value * column.scale) : QByteArray();
        }
        const QByteArray note = point.note.toUtf8();
        fields += note.isEmpty() ? QByteArray() : '"' + QByteArray(note).replace('"', "\"\"") + '"';
        csv += fields.join(separator) + '\n';
    }
    return csv;
}

} // namespace inspector
