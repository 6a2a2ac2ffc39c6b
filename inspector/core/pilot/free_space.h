// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ball's centre can be while it rolls on the floor: a grid of clearances, made from the scene's boxes.
#pragma once

#include <physics/physics.h>

#include <cstdint>
#include <span>
#include <vector>

namespace inspector {

struct Point {
    double x = 0.0; ///< m
    double y = 0.0;
};

class FreeSpace {
public:
    explicit FreeSpace(const phys_scene *scene);

    using Cell = int32_t; ///< index of a cell, row by row; kNowhere outside of the grid
    static constexpr Cell kNowhere = -1;

    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    Cell cellCount() const { return m_columns * m_rows; }
    double spacing() const { return m_spacing; } ///< m
    double radius() const { return m_radius; }   ///< of the ball, m

    Cell cellAt(Point point) const;
    Point centre(Cell cell) const;
    /// Clearance between the ball's surface and the nearest wall, m, at most 2 radii; zero or less where the ball can't
    /// be.
    double clearance(Cell cell) const { return m_clearance[size_t(cell)]; }
    /// False if the boxes cover the grid so densely that marking them would take minutes; then no cell is free.
    bool isMarked() const { return m_isMarked; }
    /// False if the maze is so large that cells are wider than the ball's radius: passages may be missed then.
    bool isFine() const { return m_spacing <= m_radius; }
    bool isFree(Cell cell) const { return cell != kNowhere && clearance(cell) > 0.0; }
    /// Whether the cell is beyond the bounds of all boxes, where the ball has left the maze.
    bool isOutside(Cell cell) const { return depthOf(cell) < 0.0; }
    /// The free cell nearest to a point, within a ball's radius; kNowhere if there is none.
    Cell nearestFree(Point point) const;
    /// Whether the straight line keeps at least this clearance, m.
    bool isClear(Point from, Point to, double clearance) const;

private:
    double depthOf(Cell cell) const; ///< inside the bounds of all boxes, m; negative outside
    void layGrid();
    void markBoxes(std::span<const phys_box> boxes);
    struct Range {
        int first, last; ///< columns or rows, both included
    };
    Range columnsAround(const phys_box &box, double reach) const;
    Range rowsAround(const phys_box &box, double reach) const;
    double cellsAround(const phys_box &box, double reach) const;
    template<typename Visit>
    void visitAround(const phys_box &box, double reach, const Visit &visit) const;
    void markWall(const phys_box &box);

    double m_radius;
    double m_floor;
    phys_box m_bounds{};
    double m_spacing = 0.0;
    Point m_origin; ///< corner of the first cell
    int m_columns = 0;
    int m_rows = 0;
    std::vector<float> m_clearance;
    bool m_isMarked = false;
};

} // namespace inspector
