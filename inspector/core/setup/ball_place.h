// SPDX-License-Identifier: GPL-3.0-or-later
// Positions where the user may put the ball.
#pragma once

#include <physics/physics.h>

namespace inspector {

/// The position nearest to `wanted` where the ball overlaps no wall and lies on the floor below; over a hole in the
/// floor it lies on the rim of the hole. If there is neither, the ball stays in the air.
phys_vec3 freePlace(const phys_scene *scene, const phys_vec3 &wanted);

/// Depth of the ball's overlap with walls and floor, m; 0 if there is none. Considers at most 64 boxes.
double overlapOf(const phys_scene *scene, const phys_vec3 &centre);

/// Whether a box touches the ball from below.
bool isCarried(const phys_scene *scene, const phys_vec3 &centre);

/// Height of the floor on which the ball lies at its start, or onto which it falls from there, m; a radius below its
/// centre if nothing is there.
double startingFloor(const phys_scene *scene);

/// Whether a box lies below the ball's centre, at any depth.
bool hasFloorBelow(const phys_scene *scene, const phys_vec3 &centre);

/// The spin with which a ball on the floor rolls at this velocity.
phys_vec3 rollingSpin(const phys_vec3 &velocity, double radius);

} // namespace inspector
