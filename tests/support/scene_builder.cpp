// SPDX-License-Identifier: MIT
#include "scene_builder.h"

namespace support {

SceneBuilder &SceneBuilder::ball(double radius) {
    m_radius = radius;
    m_start.z = radius;
    return *this;
}

SceneBuilder &SceneBuilder::floor(double x0, double y0, double x1, double y1) {
    return box({{x0, y0, -m_radius}, {x1, y1, 0.0}});
}

SceneBuilder &SceneBuilder::wall(double x0, double y0, double x1, double y1) {
    return box({{x0, y0, 0.0}, {x1, y1, 4.0 * m_radius}});
}

SceneBuilder &SceneBuilder::box(const phys_box &box) {
    m_boxes.push_back(box);
    return *this;
}

SceneBuilder &SceneBuilder::start(double x, double y) { return start({x, y, m_radius}); }

SceneBuilder &SceneBuilder::start(const phys_vec3 &centre) {
    m_start = centre;
    return *this;
}

ScenePtr SceneBuilder::build(phys_error *error) const {
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.box_count = static_cast<uint32_t>(m_boxes.size());
    desc.boxes = m_boxes.data();
    desc.radius = m_radius;
    desc.start = m_start;
    phys_scene *scene = nullptr;
    phys_scene_create(&desc, &scene, error);
    return ScenePtr(scene);
}

SceneBuilder openFloor(double halfWidth) { return SceneBuilder().floor(-halfWidth, -halfWidth, halfWidth, halfWidth); }

SceneBuilder squareRoom(double width) {
    const double thick = width / 8.0;
    return SceneBuilder()
        .floor(-thick, -thick, width + thick, width + thick)
        .wall(-thick, -thick, width + thick, 0.0)
        .wall(-thick, width, width + thick, width + thick)
        .wall(-thick, 0.0, 0.0, width)
        .wall(width, 0.0, width + thick, width)
        .start(width / 2.0, width / 2.0);
}

} // namespace support
