// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace inspector::gl {

// Board frame to world for a board tilted about `pivot` (m), angles in radians. Positive tilt_x lets the +x side sink,
// positive tilt_y the +y side, so that gravity in the board frame is g (sin tx, cos tx sin ty, -cos tx cos ty).
glm::dmat4 boardToWorld(double tilt_x, double tilt_y, const glm::dvec3 &pivot);

} // namespace inspector::gl
