// SPDX-License-Identifier: GPL-3.0-or-later
// Where the user may put the ball.
#pragma once

#include <physics/physics.h>

namespace inspector {

/// The position nearest to `wanted` where the ball overlaps no wall, on the floor below; over a hole through the floor
/// on the hole's rim, and in the air if there is neither.
phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted);

/// How deep a ball here is in a wall or the floor, m; 0: in none. Of 64 boxes at most.
double overlapOf(const phys_scene *scene, const phys_vec3 &centre);

/// Whether a box lies under the ball's centre, however deep.
bool hasFloorBelow(const phys_scene *scene, const phys_vec3 &centre);

/// The spin with which a ball on the floor rolls at this velocity.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius);

} // namespace inspector
