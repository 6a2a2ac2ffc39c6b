// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a board that a fit can look for, as rows: everything about one of them is in its row.
#pragma once

#include "core/track/ball_model.h"

#include <functional>
#include <optional>
#include <vector>

namespace inspector {

struct FitQuantity {
    QString id;            // rolling_friction
    QString label;         // for people: Rolling friction
    QString unit;          // for people; "" if it has none
    double perUnit;        // SI in one unit of people
    double lower, upper;   // SI, what it may be
    double increment;      // SI, of the difference quotient: changes positions by less than they are measured to
    double priorDeviation; // SI, how far off what is set may be: a standard deviation
    std::vector<double> initialGuesses; // SI, other places to start from
    bool isRigidOnly;                   // has no effect in the rolling model
    std::function<double &(BoardParameters &)> of;
};

// In the order in which to show them. Lengths, of the frame, are measured in the size of the scene, m.
std::vector<FitQuantity> fitQuantities();

// Ids or groups of them, separated by commas: rolling_friction, restitution_wall, ..., tilt (both offsets), delay,
// frame (all four). In the order of fitQuantities(). Nothing and one line in `error` if one isn't known.
std::optional<std::vector<FitQuantity>> parseFitQuantities(const QString &words, QString *error);

// What a fit looks for unless asked otherwise: in the rigid model also what it alone has.
const QString &usualFitQuantities();

} // namespace inspector
