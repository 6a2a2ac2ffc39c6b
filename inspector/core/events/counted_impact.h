// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace inspector {

// m/s along the normal. Slower impacts are those of a ball that leans on a wall, which discrete steppers report in
// every step: the trade doesn't compare them, the list of events folds them together.
inline constexpr double kCountedImpact = 0.05;

} // namespace inspector
