// SPDX-License-Identifier: GPL-3.0-or-later
// Where a hand may put the ball.
#pragma once

#include <physics/physics.h>

namespace inspector {

// The place next to `wanted` where the ball touches no wall, on the floor below; in the air where there is none.
phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted);

// The spin with which a ball on the floor rolls at this velocity.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius);

} // namespace inspector
