// SPDX-License-Identifier: MIT
#include "generator/cell_maze.h"

#include <algorithm>

namespace mazes {

Cell neighbour(Cell cell, Side side) {
    switch (side) {
    case Side::East:
        return {cell.x + 1, cell.y};
    case Side::North:
        return {cell.x, cell.y + 1};
    case Side::West:
        return {cell.x - 1, cell.y};
    case Side::South:
        return {cell.x, cell.y - 1};
    }
    return cell;
}

CellMaze::CellMaze(int width, int height)
    : m_width(width)
    , m_height(height)
    , m_openEast(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    , m_openNorth(m_openEast.size()) {}

std::size_t CellMaze::indexOf(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(cell.x);
}

Cell CellMaze::cellAt(std::size_t index) const {
    const auto width = static_cast<std::size_t>(m_width);
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

bool CellMaze::isOpen(CellSide wall) const {
    const Cell beyond = neighbour(wall.cell, wall.side);
    if (!contains(wall.cell) || !contains(beyond)) return false;
    switch (wall.side) {
    case Side::East:
        return m_openEast[indexOf(wall.cell)];
    case Side::North:
        return m_openNorth[indexOf(wall.cell)];
    case Side::West:
        return m_openEast[indexOf(beyond)];
    case Side::South:
        return m_openNorth[indexOf(beyond)];
    }
    return false;
}

void CellMaze::open(CellSide wall) {
    const Cell beyond = neighbour(wall.cell, wall.side);
    switch (wall.side) {
    case Side::East:
        m_openEast[indexOf(wall.cell)] = true;
        break;
    case Side::North:
        m_openNorth[indexOf(wall.cell)] = true;
        break;
    case Side::West:
        m_openEast[indexOf(beyond)] = true;
        break;
    case Side::South:
        m_openNorth[indexOf(beyond)] = true;
        break;
    }
}

std::vector<CellSide> CellMaze::closedInnerWalls() const {
    std::vector<CellSide> walls;
    for (std::size_t index = 0; index < cellCount(); ++index) {
        for (const Side side : {Side::East, Side::North}) {
            const CellSide wall{cellAt(index), side};
            if (contains(neighbour(wall.cell, side)) && !isOpen(wall)) walls.push_back(wall);
        }
    }
    return walls;
}

std::vector<int> CellMaze::distancesFrom(Cell start) const {
    std::vector<int> distances(cellCount(), -1);
    distances[indexOf(start)] = 0;
    std::vector<Cell> queue{start};
    for (std::size_t next = 0; next < queue.size(); ++next) {
        const Cell here = queue[next];
        for (const Side side : kSides) {
            const Cell there = neighbour(here, side);
            if (!isOpen({here, side}) || distances[indexOf(there)] >= 0) continue;
            distances[indexOf(there)] = distances[indexOf(here)] + 1;
            queue.push_back(there);
        }
    }
    return distances;
}

CellSide farthestOuterSide(const CellMaze &maze, Cell start) {
    const std::vector<int> distances = maze.distancesFrom(start);
    CellSide farthest;
    int longest = -1;
    for (std::size_t index = 0; index < maze.cellCount(); ++index) {
        const Cell cell = maze.cellAt(index);
        for (const Side side : kSides) {
            if (maze.contains(neighbour(cell, side)) || distances[index] <= longest) continue;
            longest = distances[index];
            farthest = {cell, side};
        }
    }
    return farthest;
}

} // namespace mazes
