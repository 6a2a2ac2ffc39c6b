// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pilot/way_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

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

/// A cell that is to be gone on from, at what its way out costs. Ties are broken by cell index, so that the path is the
/// same on every machine.
struct Entry {
    double cost;
    Cell cell;

    friend bool operator>(const Entry &a, const Entry &b) {
        return a.cost > b.cost || (a.cost == b.cost && a.cell > b.cell);
    }
};

} // namespace

WayOut::WayOut(const FreeSpace &space)
    : m_space(space)
    , m_next(size_t(space.cellCount()), FreeSpace::kNowhere) {
    search();
}

/// For each cell; 0 where the ball can't be.
std::vector<double> WayOut::prices() const {
    std::vector<double> prices(size_t(m_space.cellCount()));
    for (Cell cell = 0; cell < m_space.cellCount(); ++cell) {
        if (!m_space.isFree(cell)) continue;
        const double room = std::min(1.0, m_space.clearance(cell) / (kComfortableClearance * m_space.radius()));
        prices[size_t(cell)] = 1.0 + (kWallPrice - 1.0) * (1.0 - room) * (1.0 - room);
    }
    return prices;
}

template<typename Visit>
void WayOut::visitNeighbours(Cell cell, const Visit &visit) const {
    const int column = cell % m_space.columns();
    const int row = cell / m_space.columns();
    for (const Neighbour &step : kNeighbours) {
        const int c = column + step.column;
        const int r = row + step.row;
        if (c < 0 || r < 0 || c >= m_space.columns() || r >= m_space.rows()) continue;
        visit(r * m_space.columns() + c, step.distance);
    }
}

/// Dijkstra's algorithm, started from those free cells outside of the maze that border on others.
void WayOut::search() {
    const std::vector<double> prices = this->prices();
    std::vector<double> costs(prices.size(), std::numeric_limits<double>::infinity());
    for (Cell cell = 0; cell < m_space.cellCount(); ++cell)
        if (prices[size_t(cell)] == 0.0 || m_space.isOutside(cell)) costs[size_t(cell)] = 0.0; // none is improved
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (Cell cell = 0; cell < m_space.cellCount(); ++cell) {
        if (prices[size_t(cell)] == 0.0 || costs[size_t(cell)] > 0.0) continue;
        bool isBorder = false;
        visitNeighbours(cell, [&](Cell other, double) { isBorder = isBorder || costs[size_t(other)] > 0.0; });
        if (isBorder) open.push({0.0, cell});
    }
    while (!open.empty()) {
        const auto [cost, cell] = open.top();
        open.pop();
        if (cost > costs[size_t(cell)]) continue;
        visitNeighbours(cell, [&, cost = cost, cell = cell](Cell other, double distance) {
            if (costs[size_t(other)] <= cost) return;
            const double through = cost + distance * 0.5 * (prices[size_t(cell)] + prices[size_t(other)]);
            if (through >= costs[size_t(other)]) return;
            costs[size_t(other)] = through;
            m_next[size_t(other)] = cell;
            open.push({through, other});
        });
    }
}

bool WayOut::exists(Cell from) const {
    return from != FreeSpace::kNowhere && (m_space.isOutside(from) || m_next[size_t(from)] != FreeSpace::kNowhere);
}

} // namespace inspector
