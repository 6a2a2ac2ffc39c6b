// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_chart.h"

#include "core/setup/tables.h"
#include "core/trade/trade_answer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inspector {

namespace {

/// By position in the result's steppers; distinguishable by colour-blind people (Okabe and Ito).
const char *colourOf(size_t place) {
    static constexpr std::array<const char *, 7> kColours{"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                                          "#56b4e9", "#000000", "#e69f00"};
    return kColours[place % kColours.size()];
}

bool isDrawn(const TradePoint &point) { return point.isValid && point.cost.repeats > 0; }

ChartPoint chartPoint(const TradeResult &result, size_t index, size_t schedule, double until) {
    const TradePoint &point = result.points[index];
    return {index, std::max(point.cost.perSecond * 1e6, 1e-6),
            std::max(errorUntil(point.errors[schedule], until), kSmallestDrawnError)};
}

std::vector<ChartCurve> curvesOf(const TradeResult &result, uint32_t model, size_t schedule, double until) {
    std::vector<ChartCurve> curves;
    for (size_t i = 0; i < result.points.size(); ++i) {
        const TradePoint &point = result.points[i];
        if (point.model != model) continue;
        if (curves.empty() || curves.back().stepper != point.stepper)
            curves.push_back({point.stepper, QString::fromUtf8(point.stepper), colourOf(curves.size()), {}});
        if (isDrawn(point)) curves.back().points.push_back(chartPoint(result, i, schedule, until));
    }
    return curves;
}

/// The value at exactly this time.
double at(const std::vector<double> &times, const std::vector<double> &values, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9);
    return values[size_t(std::max<std::ptrdiff_t>(after - times.begin() - 1, 0))];
}

ChartBand bandAt(const Band &band, double time, double share, double radius) {
    ChartBand result{at(band.times, band.low, time),
                     at(band.times, band.middle, time),
                     at(band.times, band.high, time),
                     0.0,
                     {},
                     {}};
    result.limit = share * result.middle;
    result.middleText = QStringLiteral("not known: %1 mm").arg(result.middle * radius * 1e3, 0, 'g', 2);
    result.limitText = QStringLiteral("good enough: %1 mm").arg(result.limit * radius * 1e3, 0, 'g', 2);
    return result;
}

} // namespace

std::vector<ChartPoint> ChartDescription::points() const {
    std::vector<ChartPoint> all;
    for (const ChartCurve &curve : curves) all.insert(all.end(), curve.points.begin(), curve.points.end());
    return all;
}

std::vector<ChartPoint> paretoFront(std::vector<ChartPoint> points) {
    std::stable_sort(points.begin(), points.end(), [](const ChartPoint &a, const ChartPoint &b) {
        return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
    });
    double best = std::numeric_limits<double>::infinity();
    std::erase_if(points, [&](const ChartPoint &point) {
        if (!(point.error < best)) return true;
        best = point.error;
        return false;
    });
    return points;
}

size_t shownSchedule(const TradeResult &result) { return result.spans.empty() ? 0 : result.spans.size() - 1; }

ChartDescription describeChart(const TradePlan &plan, const TradeResult &result, uint32_t model, size_t schedule) {
    const TradeSpan &span = result.spans[schedule][model];
    const double until = span.band.isEmpty() ? span.compared : std::min(plan.horizon, span.compared);
    ChartDescription chart;
    chart.title = QStringLiteral("errors up to %1 s on schedule %2 (impacts: %3), %4 model")
                      .arg(until, 0, 'f', 2)
                      .arg(plan.schedules[schedule].name)
                      .arg(span.band.isEmpty() ? span.impacts : span.early)
                      .arg(modelName(model));
    chart.curves = curvesOf(result, model, schedule, until);
    chart.front = paretoFront(chart.points());
    if (span.band.isEmpty()) return chart;
    chart.band = bandAt(span.band, until, plan.share, phys_scene_radius(plan.scene.get()));
    if (result.goodEnough) chart.goodEnough = chartPoint(result, result.goodEnough->point, schedule, until);
    return chart;
}

} // namespace inspector
