// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses among measured points. All functions take points of one model: how accurate a model is, is a separate
// question (TradeError::model).
#pragma once

#include "core/trade/trade.h"

#include <span>

namespace inspector {

/// The largest position error up to a time, radii; of a point on its worst schedule.
double errorUntil(const TradeError &error, double time);
double errorUntil(const TradePoint &point, double time);

/// The cheapest per simulated second that keeps the position error at or below `radii` for `seconds` (both inclusive).
std::optional<size_t> cheapestUnder(std::span<const TradePoint> points, double radii, double seconds);

/// The most accurate that takes at most `nanoseconds` of CPU time per step; of equally accurate ones the cheapest per
/// simulated second.
std::optional<size_t> mostAccurateWithin(std::span<const TradePoint> points, double nanoseconds);

} // namespace inspector
