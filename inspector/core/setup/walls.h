// SPDX-License-Identifier: GPL-3.0-or-later
// The walls around a ball, which it can hit from the side.
#pragma once

#include <physics/physics.h>

#include <optional>

namespace inspector {

/// The wall with the smallest gap (the most negative one if some overlap), at most `reach` away (m, >= 0); nothing if
/// there is none. centre: of the ball, m. A wall is a box that rises above the ball's lowest point, such as a low kerb
/// or the side of a pit; the floor under the ball, and tiles flush with it, are not walls. Any thread.
std::optional<phys_contact> nearestWall(const phys_scene *scene, const phys_vec3 &centre, double reach);

/// Moves a ball that overlaps a wall sideways until it touches it. radius, centre: of the ball, m.
void pushOut(const phys_contact &wall, double radius, phys_vec3 &centre);

} // namespace inspector
