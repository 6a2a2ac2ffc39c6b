// SPDX-License-Identifier: MIT
#include "scene/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace phys {

namespace {

/// More cells than this in one direction only cost memory: a step of the ball is smaller than a cell anyway.
constexpr double kMostCells = 1024.0;

} // namespace

Grid::Cells Grid::cellsOf(const Vec2 &low, const Vec2 &high) const {
    const auto cell = [this](double coordinate, double origin, double count) {
        // Not negative after the clamp: the conversion rounds down.
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
    // A rounding step more than the reach, so that a box exactly at reach is never lost to rounding.
    m_reach = reach * (1.0 + 1e-9);

    Vec2 low{INFINITY}, high{-INFINITY};
    for (const phys_box &box : boxes) {
        low = {std::min(low.x, box.min.x), std::min(low.y, box.min.y)};
        high = {std::max(high.x, box.max.x), std::max(high.y, box.max.y)};
    }
    low -= m_reach;
    high += m_reach;
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double size = std::max(cellSize, extent / kMostCells);
    m_x0 = low.x;
    m_y0 = low.y;
    m_perCell = 1.0 / size;
    m_columns = std::floor((high.x - low.x) * m_perCell) + 1.0;
    m_rows = std::floor((high.y - low.y) * m_perCell) + 1.0;
    m_columnCount = static_cast<int64_t>(m_columns);

    // Counting sort by cell: count, sum up, fill; filling in order of the boxes keeps each list ascending.
    const size_t cellCount = m_columnCount * static_cast<int64_t>(m_rows);
    m_first.assign(cellCount + 1, 0);
    m_boxCells.reserve(boxes.size());
    for (const phys_box &box : boxes) {
        const Cells cells = m_boxCells.emplace_back(cellsOf(box));
        for (int64_t row = cells.row0; row <= cells.row1; ++row) {
            for (int64_t column = cells.column0; column <= cells.column1; ++column) {
                ++m_first[row * m_columnCount + column + 1];
            }
        }
    }
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_items.resize(m_first.back());
    std::vector<uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (uint32_t index = 0; index < boxes.size(); ++index) {
        const Cells &cells = m_boxCells[index];
        for (int64_t row = cells.row0; row <= cells.row1; ++row) {
            for (int64_t column = cells.column0; column <= cells.column1; ++column) {
                m_items[next[row * m_columnCount + column]++] = index;
            }
        }
    }
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
