// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as a chart for a page of paper: cost against error, both logarithmic, a curve per stepper.
#pragma once

#include "core/trade/trade.h"

namespace inspector {

// Colour and mark of a stepper's curve, by its place among the steppers of a result; "#rrggbb".
const char *curveColour(size_t place);

// Errors below this are drawn at it, radii: rounding, and the exact stepper's zero, has no logarithm.
inline constexpr double kSmallestDrawnError = 1e-13;

// The points of one model. An SVG document.
QByteArray tradeSvg(const TradePlan &plan, const TradeResult &result, uint32_t model);

} // namespace inspector
