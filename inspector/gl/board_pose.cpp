// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/board_pose.h"

#include <glm/ext/matrix_transform.hpp>

namespace inspector::gl {

glm::dmat4 boardToWorld(double tilt_x, double tilt_y, const glm::dvec3 &pivot) {
    const glm::dmat4 identity(1.0);
    return glm::translate(identity, pivot) * glm::rotate(identity, tilt_x, glm::dvec3(0.0, 1.0, 0.0)) *
           glm::rotate(identity, -tilt_y, glm::dvec3(1.0, 0.0, 0.0)) * glm::translate(identity, -pivot);
}

} // namespace inspector::gl
