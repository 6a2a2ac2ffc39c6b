// SPDX-License-Identifier: GPL-3.0-or-later
// Where the user may put the ball.
#pragma once

#include <physics/physics.h>

namespace inspector {

/// The position nearest to `wanted` where the ball overlaps no wall, on the floor below; in the air if there is none.
phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted);

/// The spin with which a ball on the floor rolls at this velocity.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius);

} // namespace inspector
