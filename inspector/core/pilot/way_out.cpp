// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/way_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace inspector {

using Cell = FreeSpace::Cell;

namespace {

/// Cost factor of a metre right next to a wall, so that the path keeps to the middle of the corridors.
constexpr double kWallPrice = 6.0;
constexpr double kComfortableClearance = 1.5; ///< radii

struct Neighbour {
    int column, row;
    double distance; ///< cells
};

constexpr double kDiagonal = 1.4142135623730951;
constexpr std::array<Neighbour, 8> kNeighbours{{{-1, 0, 1.0},
                                                {1, 0, 1.0},
                                                {0, -1, 1.0},
                                                {0, 1, 1.0},
                                                {-1, -1, kDiagonal},
                                                {1, -1, kDiagonal},
                                                {-1, 1, kDiagonal},
                                                {1, 1, kDiagonal}}};

} // namespace

WayOut::WayOut(const FreeSpace &space)
    : m_space(space)
    , m_next(size_t(space.cellCount()), FreeSpace::kNowhere) {
    search();
}

double WayOut::price(Cell cell) const {
    const double room = std::min(1.0, m_space.clearance(cell) / (kComfortableClearance * m_space.radius()));
    return 1.0 + (kWallPrice - 1.0) * (1.0 - room) * (1.0 - room);
}

/// Dijkstra's algorithm, started from all free cells outside of the maze. Ties are broken by cell index, so that the
/// path is the same on every machine.
void WayOut::search() {
    using Entry = std::pair<double, Cell>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<double> costs(size_t(m_space.cellCount()), std::numeric_limits<double>::infinity());
    for (Cell cell = 0; cell < m_space.cellCount(); ++cell) {
        if (!m_space.isFree(cell) || !m_space.isOutside(cell)) continue;
        costs[size_t(cell)] = 0.0;
        open.emplace(0.0, cell);
    }
    while (!open.empty()) {
        const auto [cost, cell] = open.top();
        open.pop();
        if (cost > costs[size_t(cell)]) continue;
        const int column = cell % m_space.columns();
        const int row = cell / m_space.columns();
        for (const Neighbour &step : kNeighbours) {
            const int c = column + step.column;
            const int r = row + step.row;
            if (c < 0 || r < 0 || c >= m_space.columns() || r >= m_space.rows()) continue;
            const Cell other = r * m_space.columns() + c;
            if (!m_space.isFree(other)) continue;
            const double through = cost + step.distance * 0.5 * (price(cell) + price(other));
            if (through >= costs[size_t(other)]) continue;
            costs[size_t(other)] = through;
            m_next[size_t(other)] = cell;
            open.emplace(through, other);
        }
    }
}

bool WayOut::exists(Cell from) const {
    return from != FreeSpace::kNowhere && (m_space.isOutside(from) || m_next[size_t(from)] != FreeSpace::kNowhere);
}

} // namespace inspector
