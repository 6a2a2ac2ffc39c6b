// SPDX-License-Identifier: MIT
#include "walls.h"

#include <algorithm>
#include <cmath>

namespace soak {

namespace {

/// The range of t in [0, 1] for which from + t (to - from) lies strictly between low and high; empty if first >= last.
void clip(double from, double to, double low, double high, double &first, double &last) {
    const double way = to - from;
    if (way == 0.0) {
        if (from <= low || from >= high) last = first;
        return;
    }
    const double atLow = (low - from) / way;
    const double atHigh = (high - from) / way;
    first = std::max(first, std::min(atLow, atHigh));
    last = std::min(last, std::max(atLow, atHigh));
}

bool crosses(const phys_box &box, const phys_vec3 &from, const phys_vec3 &to) {
    double first = 0.0;
    double last = 1.0;
    clip(from.x, to.x, box.min.x, box.max.x, first, last);
    clip(from.y, to.y, box.min.y, box.max.y, first, last);
    clip(from.z, to.z, box.min.z, box.max.z, first, last);
    return first < last;
}

double distance(const phys_box &box, const phys_vec3 &p) {
    const double dx = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
    const double dy = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
    const double dz = std::max({box.min.z - p.z, 0.0, p.z - box.max.z});
    return std::sqrt(dx * dx + dy * dy + dz * dz);
}

} // namespace

Walls::Walls(const std::vector<phys_box> &boxes, double radius, double startHeight)
    : m_radius(radius)
    , m_cell(2.0 * radius) {
    for (const phys_box &box : boxes) {
        if (box.max.z > startHeight) m_walls.push_back(box);
    }
    if (m_walls.empty()) return;
    const double margin = 4.0 * radius; // a ball further out touches nothing
    double x1 = m_walls[0].max.x;
    double y1 = m_walls[0].max.y;
    m_x0 = m_walls[0].min.x;
    m_y0 = m_walls[0].min.y;
    for (const phys_box &box : m_walls) {
        m_x0 = std::min(m_x0, box.min.x);
        m_y0 = std::min(m_y0, box.min.y);
        x1 = std::max(x1, box.max.x);
        y1 = std::max(y1, box.max.y);
    }
    m_x0 -= margin;
    m_y0 -= margin;
    m_columns = static_cast<size_t>((x1 + margin - m_x0) / m_cell) + 1;
    m_rows = static_cast<size_t>((y1 + margin - m_y0) / m_cell) + 1;
    m_cells.resize(m_columns * m_rows);
    for (const phys_box &box : m_walls) {
        const auto column = [&](double x) { return static_cast<size_t>((x - m_x0) / m_cell); };
        const auto row = [&](double y) { return static_cast<size_t>((y - m_y0) / m_cell); };
        for (size_t j = row(box.min.y - 2.0 * radius); j <= row(box.max.y + 2.0 * radius); ++j) {
            for (size_t i = column(box.min.x - 2.0 * radius); i <= column(box.max.x + 2.0 * radius); ++i) {
                m_cells[j * m_columns + i].push_back(&box);
            }
        }
    }
}

const std::vector<const phys_box *> &Walls::near(const phys_vec3 &centre) const {
    const double column = (centre.x - m_x0) / m_cell;
    const double row = (centre.y - m_y0) / m_cell;
    const bool inside =
        column >= 0.0 && row >= 0.0 && column < static_cast<double>(m_columns) && row < static_cast<double>(m_rows);
    return inside ? m_cells[static_cast<size_t>(row) * m_columns + static_cast<size_t>(column)] : m_none;
}

double Walls::depthAt(const phys_vec3 &centre) const {
    double nearest = m_radius;
    for (const phys_box *box : near(centre)) nearest = std::min(nearest, distance(*box, centre));
    return m_radius - nearest;
}

bool Walls::areCrossed(const phys_vec3 &from, const phys_vec3 &to) const {
    const auto isCrossed = [&](const phys_box &box) { return crosses(box, from, to); };
    // The cell lists all walls that a path of up to two radii can reach.
    const bool isShort = std::hypot(to.x - from.x, to.y - from.y) <= 2.0 * m_radius;
    if (!isShort) return std::any_of(m_walls.begin(), m_walls.end(), isCrossed);
    const auto &walls = near(from);
    return std::any_of(walls.begin(), walls.end(), [&](const phys_box *box) { return isCrossed(*box); });
}

} // namespace soak
