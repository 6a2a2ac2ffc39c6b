// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh.h"

#include <glm/common.hpp>

namespace inspector::gl {

Bounds Mesh::bounds() const {
    if (vertices.empty()) return {{-0.1, -0.1, 0.0}, {0.1, 0.1, 0.02}};
    glm::vec3 minimum = vertices.front().position;
    glm::vec3 maximum = minimum;
    for (const Vertex &vertex : vertices) {
        minimum = glm::min(minimum, vertex.position);
        maximum = glm::max(maximum, vertex.position);
    }
    return {minimum, maximum};
}

} // namespace inspector::gl
