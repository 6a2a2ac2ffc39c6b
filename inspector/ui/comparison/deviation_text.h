// SPDX-License-Identifier: GPL-3.0-or-later
// Deviations as display text.
#pragma once

#include <QString>

namespace inspector::ui {

/// 0.1234 mm = 0.0206 R
QString distanceText(double distance, double radius); ///< m
/// +1.234 mm/s
QString speedDifferenceText(double speed); ///< m/s
/// -0.01234 mJ/kg
QString energyDifferenceText(double energy); ///< J/kg

} // namespace inspector::ui
