// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/board_pose.h"

#include <cmath>

#include <glm/ext/matrix_transform.hpp>

namespace inspector::gl {

glm::dmat4 boardToWorld(double tiltX, double tiltY, const glm::dvec3 &pivot) {
    const glm::dmat4 identity(1.0);
    const double slopeX = std::tan(tiltX);
    const double slopeY = std::tan(tiltY);
    const double slope = std::hypot(slopeX, slopeY);
    if (slope == 0.0) return identity;
    // The axis is the horizontal line of the slope.
    const glm::dvec3 axis(-slopeY / slope, slopeX / slope, 0.0);
    return glm::translate(identity, pivot) * glm::rotate(identity, std::atan(slope), axis) *
           glm::translate(identity, -pivot);
}

glm::dvec3 boardPivot(const Bounds &bounds) { return {bounds.centre().x, bounds.centre().y, 0.0}; }

} // namespace inspector::gl
