// SPDX-License-Identifier: MIT
// A maze as cells and the passages between them, without lengths.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mazes {

// x grows to the right (east), y away from the player (north); {0, 0} is the near left cell.
struct Cell {
    int x = 0;
    int y = 0;
    bool operator==(const Cell &) const = default;
};

enum class Side { East, North, West, South };

inline constexpr std::array<Side, 4> kSides = {Side::East, Side::North, Side::West, Side::South};

Cell neighbour(Cell cell, Side side);

// One side of one cell: an inner wall, or a piece of the outer one.
struct CellSide {
    Cell cell;
    Side side = Side::East;
    bool operator==(const CellSide &) const = default;
};

class CellMaze {
public:
    // width and height >= 1; every wall is closed.
    CellMaze(int width, int height);

    int width() const { return m_width; }
    int height() const { return m_height; }
    std::size_t cellCount() const { return m_openEast.size(); }
    bool contains(Cell cell) const { return cell.x >= 0 && cell.x < m_width && cell.y >= 0 && cell.y < m_height; }

    // Row by row from {0, 0}; the two are each other's inverse.
    std::size_t indexOf(Cell cell) const;
    Cell cellAt(std::size_t index) const;

    // An outer side is never open.
    bool isOpen(CellSide wall) const;
    // The neighbour on that side must exist.
    void open(CellSide wall);

    // Each closed wall between two cells once, as the east or north side of a cell, in the order of the cells.
    std::vector<CellSide> closedInnerWalls() const;

    // Number of steps from one cell to each cell by index; -1 if it can't be reached.
    std::vector<int> distancesFrom(Cell start) const;

private:
    int m_width;
    int m_height;
    std::vector<bool> m_openEast;
    std::vector<bool> m_openNorth;
};

// The outer side of the border cell with the longest way from `start`; on ties the first cell and side.
CellSide farthestOuterSide(const CellMaze &maze, Cell start);

} // namespace mazes
