// SPDX-License-Identifier: MIT
#include "scene/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace phys {

Grid::Cells Grid::cellsOf(const Vec2 &low, const Vec2 &high) const {
    const auto cell = [this](double coordinate, double origin, double count) {
        // Not negative after the clamp, so the conversion rounds down.
        return static_cast<uint32_t>(std::clamp((coordinate - origin) * m_perCell, 0.0, count - 1.0));
    };
    return {cell(low.x, m_x0, m_columns), cell(low.y, m_y0, m_rows), cell(high.x, m_x0, m_columns),
            cell(high.y, m_y0, m_rows)};
}

Grid::Cells Grid::cellsOf(const phys_box &box) const {
    return cellsOf({box.min.x - m_reach, box.min.y - m_reach}, {box.max.x + m_reach, box.max.y + m_reach});
}

void Grid::build(std::span<const phys_box> boxes, double reach, double cellSize) {
    *this = Grid{};
    if (boxes.empty()) return;
    // One rounding step more than the reach, so that rounding loses no box exactly at reach.
    m_reach = reach * (1.0 + 1e-9);
    chooseCells(boxes, cellSize);
    fill(boxes);
}

/// The finest cells that the budget allows, cellSize times a power of two. A single cell always fits.
void Grid::chooseCells(std::span<const phys_box> boxes, double cellSize) {
    Vec2 low{INFINITY}, high{-INFINITY};
    for (const phys_box &box : boxes) {
        low = {std::min(low.x, box.min.x), std::min(low.y, box.min.y)};
        high = {std::max(high.x, box.max.x), std::max(high.y, box.max.y)};
    }
    low -= m_reach;
    high += m_reach;
    const auto most = mostEntries(boxes.size());
    layOut(low, high, cellSize);
    while (entryCount(boxes, most) > most) {
        cellSize *= 2.0;
        layOut(low, high, cellSize);
    }
}

void Grid::layOut(const Vec2 &low, const Vec2 &high, double cellSize) {
    m_x0 = low.x;
    m_y0 = low.y;
    m_perCell = 1.0 / cellSize;
    m_columns = std::floor((high.x - low.x) * m_perCell) + 1.0;
    m_rows = std::floor((high.y - low.y) * m_perCell) + 1.0;
}

/// Cells plus list entries; counting stops at more than `most`.
uint64_t Grid::entryCount(std::span<const phys_box> boxes, uint64_t most) const {
    // As doubles, because for a tiny ball a huge board has more cells than an integer can count.
    if (m_columns * m_rows > static_cast<double>(most)) return most + 1;
    auto count = static_cast<uint64_t>(m_columns * m_rows);
    for (size_t i = 0; i < boxes.size() && count <= most; ++i) count += cellsOf(boxes[i]).count();
    return count;
}

/// Counting sort by cell: count, sum up, fill. Filling in the boxes' order keeps each list ascending. Counts are stored
/// two places further on; filling moves each list's end to one place further on, where the next list begins.
void Grid::fill(std::span<const phys_box> boxes) {
    m_columnCount = static_cast<ptrdiff_t>(m_columns);
    const size_t cellCount = m_columnCount * static_cast<ptrdiff_t>(m_rows);
    const auto visitCells = [this](const Cells &cells, auto visit) {
        for (size_t row = cells.row0; row <= cells.row1; ++row) {
            for (size_t column = cells.column0; column <= cells.column1; ++column) visit(row * m_columnCount + column);
        }
    };
    m_first.assign(cellCount + 2, 0); // 32 bits are enough for the entries that the budget allows
    m_boxCells.reserve(boxes.size());
    for (const phys_box &box : boxes) {
        visitCells(m_boxCells.emplace_back(cellsOf(box)), [this](size_t cell) { ++m_first[cell + 2]; });
    }
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_items.resize(m_first.back());
    for (uint32_t index = 0; index < boxes.size(); ++index) {
        visitCells(m_boxCells[index], [&](size_t cell) { m_items[m_first[cell + 1]++] = index; });
    }
    m_first.pop_back();
}

Grid::Square Grid::squareOf(size_t cell) const {
    const double size = 1.0 / m_perCell;
    const Vec2 low{m_x0 + static_cast<double>(cell % m_columnCount) * size,
                   m_y0 + static_cast<double>(cell / m_columnCount) * size};
    return {low, low + size};
}

uint32_t Grid::overlapping(const Vec2 &low, const Vec2 &high, std::span<uint32_t> out) const {
    uint32_t count = 0;
    visitOverlapping(low, high, [&](uint32_t box) {
        if (count < out.size()) out[count] = box;
        ++count;
    });
    std::sort(out.begin(), out.begin() + std::min<size_t>(count, out.size()));
    return count;
}

} // namespace phys
