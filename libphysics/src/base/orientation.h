// SPDX-License-Identifier: MIT
// Rotation of the ball, for drawing only.
#pragma once

#include "base/vec.h"

namespace phys {

/// Turns the unit quaternion (x y z w) by the rotation vector `turn` (rad, board frame). Uses + - x / sqrt only.
void rotate(double (&orientation)[4], const Vec3 &turn);

} // namespace phys
