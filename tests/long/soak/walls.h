// SPDX-License-Identifier: MIT
// The maze as the soak test sees it: every box, found by a grid of its own, with geometry that shares nothing with the
// library.
#pragma once

#include <physics/physics.h>

#include <vector>

namespace soak {

class Walls {
public:
    /// boxes: of the scene; those that end below the ball's centre at the start are floor and left out.
    Walls(const std::vector<phys_box> &boxes, double radius, double startHeight);

    /// The ball's depth in the wall that it overlaps most, m; 0 if it overlaps none.
    double depthAt(const phys_vec3 &centre) const;

    /// Whether the centre's path from one position to another runs through the inside of a wall.
    bool areCrossed(const phys_vec3 &from, const phys_vec3 &to) const;

private:
    const std::vector<const phys_box *> &near(const phys_vec3 &centre) const;

    std::vector<phys_box> m_walls;
    double m_radius;
    double m_cell, m_x0 = 0.0, m_y0 = 0.0;
    size_t m_columns = 0, m_rows = 0;
    std::vector<std::vector<const phys_box *>> m_cells; ///< walls within two radii of a cell
    std::vector<const phys_box *> m_none;
};

} // namespace soak
