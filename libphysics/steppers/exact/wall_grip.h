// SPDX-License-Identifier: MIT
// Which contacts of a ball at a wall roll and which slip, and in which direction it goes: model.md 6.5.
#pragma once

#include "wall_motion.h"

namespace phys {

/// Completes a law whose grips follow from the slips alone. What rolls but would need more than its friction starts to
/// slip; the axis along is turned into the direction of motion: true if that meant to turn it round. resistance: mu_r
/// gn of a ball that rolls on the floor.
bool settleGrips(WallLaw &law, WallState &now, double resistance);

/// Whether what should be > 0 isn't, or ceases to be so now. size: of the numbers it is the difference of, model.md 8.
bool isSpent(const Taylor &force, double size);

} // namespace phys
