// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_answer.h"

#include <algorithm>
#include <tuple>

namespace inspector {

namespace {

/// The index with the smallest key among the wanted ones; the first of equals.
template<typename Wanted, typename Key>
std::optional<size_t> least(std::span<const TradePoint> points, Wanted wanted, Key key) {
    std::optional<size_t> best;
    for (size_t i = 0; i < points.size(); ++i)
        if (wanted(points[i]) && (!best || key(points[i]) < key(points[*best]))) best = i;
    return best;
}

} // namespace

double errorUntil(const TradePoint &point, double time) { return errorUntil(point.error, time); }

double errorUntil(const TradeError &error, double time) {
    const std::vector<ErrorRecord> &growth = error.growth;
    const auto after = std::upper_bound(growth.begin(), growth.end(), time,
                                        [](double limit, const ErrorRecord &record) { return limit < record.time; });
    return after == growth.begin() ? 0.0 : std::prev(after)->error;
}

std::optional<size_t> cheapestUnder(std::span<const TradePoint> points, double radii, double seconds) {
    return least(
        points, [&](const TradePoint &point) { return errorUntil(point, seconds) <= radii; },
        [](const TradePoint &point) { return point.cost.perSecond; });
}

std::optional<size_t> mostAccurateWithin(std::span<const TradePoint> points, double nanoseconds) {
    return least(
        points, [&](const TradePoint &point) { return point.cost.perStep <= nanoseconds * 1e-9; },
        [](const TradePoint &point) { return std::tuple(point.error.positionLargest, point.cost.perSecond); });
}

} // namespace inspector
