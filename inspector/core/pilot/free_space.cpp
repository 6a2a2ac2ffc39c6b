// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/free_space.h"

#include "base/elementary.h"
#include "core/setup/ball_place.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kCellsPerRadius = 4.0;
constexpr double kMostCells = 1e6;
constexpr double kFarClearance = 2.0;          ///< radii; a larger clearance makes no difference
constexpr double kReach = 1.0 + kFarClearance; ///< radii, from the ball's centre to a wall that matters
constexpr double kMostVisits = 3e8;            ///< cell visits for all boxes: some seconds

} // namespace

FreeSpace::FreeSpace(const phys_scene *scene)
    : m_radius(phys_scene_radius(scene))
    , m_floor(startingFloor(scene)) {
    phys_scene_bounds(scene, &m_bounds);
    layGrid();

    double visits = 0.0;
    const phys_box *boxes = phys_scene_boxes(scene);
    const uint32_t count = phys_scene_box_count(scene);
    for (uint32_t i = 0; i < count; ++i) visits += cellsAround(boxes[i], kReach * m_radius);
    m_isMarked = visits <= kMostVisits;
    if (m_isMarked)
        markBoxes({boxes, count});
    else
        m_clearance.assign(m_clearance.size(), -1.0F);
}

/// What is level with the floor under the ball's start (to a thousandth of its radius) is floor; everything else that
/// the ball can touch is wall. At the border the floor may end up to a radius earlier: the ball that falls over its
/// edge is out before it is below.
void FreeSpace::markBoxes(std::span<const phys_box> boxes) {
    std::vector<bool> hasFloor(m_clearance.size(), false);
    for (const phys_box &box : boxes) {
        if (std::abs(box.max.z - m_floor) <= 1e-3 * m_radius)
            visitAround(box, m_radius, [&](Cell cell, double gap) {
                if (gap <= 0.0 || (gap <= m_radius && depthOf(cell) <= m_radius)) hasFloor[size_t(cell)] = true;
            });
        else
            markWall(box);
    }
    for (Cell cell = 0; cell < cellCount(); ++cell)
        if (!hasFloor[size_t(cell)] && !isOutside(cell)) m_clearance[size_t(cell)] = -1.0F;
}

void FreeSpace::layGrid() {
    double margin = 3.0 * m_radius;
    double width = m_bounds.max.x - m_bounds.min.x + 2.0 * margin;
    double height = m_bounds.max.y - m_bounds.min.y + 2.0 * margin;
    // At most kMostCells per side and, apart from those at the border, in total.
    m_spacing = std::max({m_radius / kCellsPerRadius, std::sqrt(width) * std::sqrt(height / kMostCells),
                          width / kMostCells, height / kMostCells});
    // The centre of at least one cell lies outside on each side, or no way would lead there.
    const double wider = std::max(margin, 0.75 * m_spacing) - margin;
    margin += wider;
    width += 2.0 * wider;
    height += 2.0 * wider;
    m_origin = {m_bounds.min.x - margin, m_bounds.min.y - margin};
    m_columns = int(std::ceil(width / m_spacing));
    m_rows = int(std::ceil(height / m_spacing));
    m_clearance.assign(size_t(cellCount()), float(kFarClearance * m_radius));
}

FreeSpace::Cell FreeSpace::cellAt(Point point) const {
    const double column = std::floor((point.x - m_origin.x) / m_spacing);
    const double row = std::floor((point.y - m_origin.y) / m_spacing);
    if (!(column >= 0.0 && row >= 0.0 && column < m_columns && row < m_rows)) return kNowhere;
    return Cell(row) * m_columns + Cell(column);
}

Point FreeSpace::centre(Cell cell) const {
    const Cell column = cell % m_columns;
    const Cell row = cell / m_columns;
    return {m_origin.x + (column + 0.5) * m_spacing, m_origin.y + (row + 0.5) * m_spacing};
}

double FreeSpace::depthOf(Cell cell) const {
    const Point p = centre(cell);
    return std::min({p.x - m_bounds.min.x, m_bounds.max.x - p.x, p.y - m_bounds.min.y, m_bounds.max.y - p.y});
}

FreeSpace::Range FreeSpace::columnsAround(const phys_box &box, double reach) const {
    const auto column = [&](double x) { return std::clamp(int((x - m_origin.x) / m_spacing), 0, m_columns - 1); };
    return {column(box.min.x - reach), column(box.max.x + reach)};
}

FreeSpace::Range FreeSpace::rowsAround(const phys_box &box, double reach) const {
    const auto row = [&](double y) { return std::clamp(int((y - m_origin.y) / m_spacing), 0, m_rows - 1); };
    return {row(box.min.y - reach), row(box.max.y + reach)};
}

double FreeSpace::cellsAround(const phys_box &box, double reach) const {
    const Range columns = columnsAround(box, reach);
    const Range rows = rowsAround(box, reach);
    return double(columns.last - columns.first + 1) * double(rows.last - rows.first + 1);
}

/// Calls `visit` for all cells within `reach` of the box seen from above, with the distance of their centres from it.
template<typename Visit>
void FreeSpace::visitAround(const phys_box &box, double reach, const Visit &visit) const {
    const Range columns = columnsAround(box, reach);
    const Range rows = rowsAround(box, reach);
    for (int r = rows.first; r <= rows.last; ++r) {
        for (int c = columns.first; c <= columns.last; ++c) {
            const Cell cell = r * m_columns + c;
            const Point p = centre(cell);
            const double dx = std::max({box.min.x - p.x, p.x - box.max.x, 0.0});
            const double dy = std::max({box.min.y - p.y, p.y - box.max.y, 0.0});
            visit(cell, phys::elementary::hypot(dx, dy));
        }
    }
}

/// Lowers the clearance of all cells near the box. It is the distance in space at the height of the rolling ball, so
/// that a low kerb counts by its edge.
void FreeSpace::markWall(const phys_box &box) {
    const double centre = m_floor + m_radius;
    const double dz = std::max({box.min.z - centre, centre - box.max.z, 0.0});
    visitAround(box, kReach * m_radius, [&](Cell cell, double gap) {
        float &clearance = m_clearance[size_t(cell)];
        clearance = std::min(clearance, float(phys::elementary::hypot(gap, dz) - m_radius));
    });
}

FreeSpace::Cell FreeSpace::nearestFree(Point point) const {
    const Cell here = cellAt(point);
    if (isFree(here)) return here;
    Cell best = kNowhere;
    double bestDistance = m_radius;
    const int reach = int(std::ceil(m_radius / m_spacing));
    for (int dr = -reach; dr <= reach; ++dr) {
        for (int dc = -reach; dc <= reach; ++dc) {
            const Cell cell = cellAt({point.x + dc * m_spacing, point.y + dr * m_spacing});
            if (!isFree(cell)) continue;
            const double distance = phys::elementary::hypot(centre(cell).x - point.x, centre(cell).y - point.y);
            if (distance >= bestDistance) continue;
            best = cell;
            bestDistance = distance;
        }
    }
    return best;
}

bool FreeSpace::isClear(Point from, Point to, double clearance) const {
    const double length = phys::elementary::hypot(to.x - from.x, to.y - from.y);
    const int count = int(std::ceil(length / (0.5 * m_spacing)));
    for (int i = 1; i <= count; ++i) {
        const double t = double(i) / count;
        const Cell cell = cellAt({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        if (cell == kNowhere || this->clearance(cell) < clearance) return false;
    }
    return true;
}

} // namespace inspector
