// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a chart (known elsewhere as a work-precision diagram), described independently of its renderers: cost
// against error, both logarithmic, one curve per stepper, and the uncertainty of the board as a band.
#pragma once

#include "core/trade/trade.h"

namespace inspector {

/// Smaller errors, such as rounding errors and the exact stepper's zero, are drawn at this one, radii.
inline constexpr double kSmallestDrawnError = 1e-13;

struct ChartPoint {
    size_t index; ///< in the result's points
    double cost;  ///< µs of CPU time a simulated second
    double error; ///< radii
};

/// The points that no other point beats in both cost and error, from cheap to accurate; of equal points the first.
std::vector<ChartPoint> paretoFront(std::vector<ChartPoint> points);

struct ChartCurve {
    QByteArray stepper;
    QString name;       ///< in the legend; at first the id
    const char *colour; ///< #rrggbb
    std::vector<ChartPoint> points;
};

/// In radii.
struct ChartBand {
    double low, middle, high;
    double limit; ///< smaller errors are good enough
    QString middleText, limitText;
};

struct ChartDescription {
    QString title;
    QString costLabel = QStringLiteral("CPU per simulated second [µs]");
    QString errorLabel = QStringLiteral("largest error [radii]");
    std::vector<ChartCurve> curves; ///< for every stepper, so that colours don't change while results arrive
    std::vector<ChartPoint> front;  ///< the Pareto front, from cheap to accurate
    std::optional<ChartBand> band;
    std::optional<ChartPoint> goodEnough;

    std::vector<ChartPoint> points() const; ///< of all curves
};

/// Describes the errors on one schedule: up to the plan's horizon if there is a band, otherwise up to the end of the
/// comparison. schedule: an index into the result's.
ChartDescription describeChart(const TradePlan &plan, const TradeResult &result, uint32_t model, size_t schedule);

/// The schedule that a picture shows: the last one, which has the most impacts.
size_t shownSchedule(const TradeResult &result);

} // namespace inspector
