// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that can be fitted, one row each with everything about it.
#pragma once

#include "core/track/ball_model.h"

#include <functional>
#include <optional>
#include <vector>

namespace inspector {

struct FitQuantity {
    QString id;            ///< rolling_friction
    QString label;         ///< for display: Rolling friction
    QString unit;          ///< of its values here and in files; "" if it has none
    double perUnit;        ///< SI units in one display unit
    double lower, upper;   ///< SI, bounds
    double increment;      ///< SI, for finite differences: changes positions by less than the measurement noise
    double priorDeviation; ///< SI, standard deviation of the prior around the value that is set
    std::vector<double> initialGuesses; ///< SI, further starting values
    bool isRigidOnly;                   ///< has no effect in the rolling model
    std::function<double &(BoardParameters &)> of;
};

/// In display order. The lengths of the frame are assumed to be of the order of the scene's size, m.
std::vector<FitQuantity> fitQuantities();

/// Parses ids or groups of them, separated by commas: rolling_friction, restitution_wall, ..., tilt (both offsets),
/// delay, frame (all four). The result is in the order of fitQuantities(). Returns nothing, with one line in `error`,
/// if one isn't known.
std::optional<std::vector<FitQuantity>> parseFitQuantities(const QString &words, QString *error);

/// The quantities fitted by default, including those that only the rigid model has.
const QString &usualFitQuantities();

} // namespace inspector
