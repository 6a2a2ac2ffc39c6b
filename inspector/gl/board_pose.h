// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace inspector::gl {

/// The transform from the board frame to the world for a board tilted about `pivot` (m). The angles, rad in (-pi/2,
/// pi/2), are the slopes along x and y as phys_gravity_from_tilt takes them: positive lowers the +x or +y side, and
/// straight down is (tan tilt_x, tan tilt_y, -1) in the board frame. Of all poses with that slope it is the one without
/// twist.
glm::dmat4 boardToWorld(double tiltX, double tiltY, const glm::dvec3 &pivot);

/// The point about which a board tilts: the middle of its floor.
glm::dvec3 boardPivot(const Bounds &bounds);

} // namespace inspector::gl
