// SPDX-License-Identifier: MIT
// A uniform grid over the board, which finds the boxes that a ball can touch from its centre's position.
#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace phys {

class Grid {
public:
    /// Each cell lists the boxes within `reach` (m) of it, seen from above. Cells are cellSize m wide, or 2, 4, 8, ...
    /// times as wide if necessary to keep cells and lists together within mostEntries(boxes.size()).
    void build(std::span<const phys_box> boxes, double reach, double cellSize);

    static constexpr size_t kNoCell = SIZE_MAX;
    /// The cell of a centre at (x, y), or kNoCell outside of the grid.
    size_t cellAt(double x, double y) const {
        const double column = (x - m_x0) * m_perCell;
        const double row = (y - m_y0) * m_perCell;
        // Negated so that a NaN has no cell either.
        if (!(column >= 0.0 && column < m_columns && row >= 0.0 && row < m_rows)) return kNoCell;
        return static_cast<ptrdiff_t>(row) * m_columnCount + static_cast<ptrdiff_t>(column);
    }

    /// The position of a cell, m.
    struct Square {
        Vec2 low, high;
    };
    Square squareOf(size_t cell) const;

    /// Boxes within reach of any centre in a cell: a superset, ascending.
    std::span<const uint32_t> nearCell(size_t cell) const {
        return {m_items.data() + m_first[cell], m_first[cell + 1] - m_first[cell]};
    }

    /// Boxes within reach of a centre at (x, y): a superset, ascending.
    std::span<const uint32_t> near(double x, double y) const {
        const size_t cell = cellAt(x, y);
        return cell == kNoCell ? std::span<const uint32_t>() : nearCell(cell);
    }

    /// Boxes within reach of any centre in the rectangle: a superset, ascending, without duplicates. Returns their
    /// number; writes only the first out.size() of them.
    uint32_t overlapping(const Vec2 &low, const Vec2 &high, std::span<uint32_t> out) const;

    /// Calls visit(box) for the boxes that `overlapping` returns, without duplicates, in no particular order.
    template<class Visit>
    void visitOverlapping(const Vec2 &low, const Vec2 &high, Visit visit) const;

    /// Largest number of cells and list entries for this many boxes: a grid is never larger than a small one or 64
    /// bytes per box.
    static constexpr uint64_t mostEntries(uint64_t boxes) { return 65'536 + 16 * boxes; }

private:
    struct Cells {
        uint32_t column0, row0, column1, row1; // both ends included

        uint64_t count() const { return uint64_t{column1 - column0 + 1} * (row1 - row0 + 1); }
    };
    void chooseCells(std::span<const phys_box> boxes, double cellSize);
    void layOut(const Vec2 &low, const Vec2 &high, double cellSize);
    uint64_t entryCount(std::span<const phys_box> boxes, uint64_t most) const;
    void fill(std::span<const phys_box> boxes);
    Cells cellsOf(const Vec2 &low, const Vec2 &high) const;
    Cells cellsOf(const phys_box &box) const;

    double m_x0 = 0.0, m_y0 = 0.0, m_perCell = 0.0;
    double m_columns = 0.0, m_rows = 0.0; // as doubles, for the comparison in the hot path
    ptrdiff_t m_columnCount = 0;
    double m_reach = 0.0;
    std::vector<uint32_t> m_first, m_items; // the lists, one after another, and where each cell's list begins
    std::vector<Cells> m_boxCells;
};

template<class Visit>
void Grid::visitOverlapping(const Vec2 &low, const Vec2 &high, Visit visit) const {
    if (m_items.empty()) return;
    const Cells query = cellsOf(low, high);
    if (query.count() > m_boxCells.size()) { // testing all boxes is cheaper then
        for (uint32_t box = 0; box < m_boxCells.size(); ++box) {
            const Cells &own = m_boxCells[box];
            const bool overlaps = own.column0 <= query.column1 && query.column0 <= own.column1 &&
                                  own.row0 <= query.row1 && query.row0 <= own.row1;
            if (overlaps) visit(box);
        }
        return;
    }
    for (uint32_t row = query.row0; row <= query.row1; ++row) {
        for (uint32_t column = query.column0; column <= query.column1; ++column) {
            const size_t cell = row * m_columnCount + column;
            for (uint32_t item = m_first[cell]; item < m_first[cell + 1]; ++item) {
                const uint32_t box = m_items[item];
                // A box in several cells of the query is visited in the first of them only.
                const Cells &own = m_boxCells[box];
                if (row == std::max(query.row0, own.row0) && column == std::max(query.column0, own.column0)) visit(box);
            }
        }
    }
}

} // namespace phys
