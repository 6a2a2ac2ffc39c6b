// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace inspector {

/// The quantile of values in ascending order (at least one), with linear interpolation. share: 0 (the first) .. 1 (the
/// last).
double quantile(const std::vector<double> &sorted, double share);

} // namespace inspector
