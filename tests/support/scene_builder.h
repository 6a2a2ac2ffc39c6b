// SPDX-License-Identifier: MIT
// Builds the scene of a test from a short description.
#pragma once

#include "handles.h"

#include <vector>

namespace support {

/// Floors have their top at z = 0; walls stand on them, 4 R high. All lengths in m.
class SceneBuilder {
public:
    SceneBuilder &ball(double radius);
    SceneBuilder &floor(double x0, double y0, double x1, double y1);
    SceneBuilder &wall(double x0, double y0, double x1, double y1);
    SceneBuilder &box(const phys_box &box);
    SceneBuilder &start(double x, double y); ///< on the floor
    SceneBuilder &start(const phys_vec3 &centre);

    double radius() const { return m_radius; }
    phys_vec3 start() const { return m_start; }
    const std::vector<phys_box> &boxes() const { return m_boxes; }

    /// NULL if the library refuses the scene; `error` (or NULL) then gets the reason.
    ScenePtr build(phys_error *error = nullptr) const;

private:
    double m_radius = 0.0625;
    phys_vec3 m_start{0.0, 0.0, 0.0625};
    std::vector<phys_box> m_boxes;
};

/// A floor of this half-width around the origin, no walls, the ball in its middle.
SceneBuilder openFloor(double halfWidth = 100.0);

/// A square floor with its lower corner in the origin and four flush walls around it.
SceneBuilder squareRoom(double width);

} // namespace support
