// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a chart (elsewhere called a work-precision diagram), described for whoever draws it: cost against error,
// both logarithmic, a curve per stepper, and what isn't known as a band across.
#pragma once

#include "core/trade/trade.h"

namespace inspector {

// Errors below this are drawn at it, radii: rounding, and the exact stepper's zero, has no logarithm.
inline constexpr double kSmallestDrawnError = 1e-13;

struct ChartPoint {
    size_t index; // in the result's points
    double cost;  // µs of CPU time a simulated second
    double error; // radii
};

struct ChartCurve {
    QByteArray stepper;
    const char *colour; // #rrggbb
    std::vector<ChartPoint> points;
};

// In radii.
struct ChartBand {
    double low, middle, high;
    double limit; // errors below are good enough
    QString middleText, limitText;
};

struct ChartDescription {
    QString title, costLabel, errorLabel;
    std::vector<ChartCurve> curves; // of every stepper, so that colours stay while results come in
    std::vector<ChartPoint> front;  // what no other point beats, from cheap to accurate
    std::optional<ChartBand> band;
    std::optional<ChartPoint> goodEnough;

    std::vector<ChartPoint> points() const; // of all curves
};

// Errors on one schedule: up to the plan's horizon if there is a band, otherwise as far as they are compared. schedule:
// one that the result has.
ChartDescription describeChart(const TradePlan &plan, const TradeResult &result, uint32_t model, size_t schedule);

// Which schedule a picture shows: the last one, where most happens.
size_t shownSchedule(const TradeResult &result);

} // namespace inspector
