// SPDX-License-Identifier: MIT
#include "generator/algorithms.h"

#include <numeric>
#include <vector>

namespace mazes {

namespace {

std::vector<Side> sidesInside(const CellMaze &maze, Cell cell) {
    std::vector<Side> sides;
    for (const Side side : kSides)
        if (maze.contains(neighbour(cell, side))) sides.push_back(side);
    return sides;
}

// Depth first: walk to an unvisited neighbour, go back if there is none. The path is a separate list because recursion
// would need one stack frame per cell.
void carveBacktracker(CellMaze &maze, Random &random) {
    std::vector<bool> visited(maze.cellCount());
    std::vector<Cell> path{maze.cellAt(random.below(maze.cellCount()))};
    visited[maze.indexOf(path.back())] = true;
    while (!path.empty()) {
        const Cell here = path.back();
        std::vector<Side> ways = sidesInside(maze, here);
        std::erase_if(ways, [&](Side side) { return visited[maze.indexOf(neighbour(here, side))]; });
        if (ways.empty()) {
            path.pop_back();
            continue;
        }
        const Side way = ways[random.below(ways.size())];
        maze.open({here, way});
        path.push_back(neighbour(here, way));
        visited[maze.indexOf(path.back())] = true;
    }
}

// Which cells are already connected: a forest whose roots represent the connected groups.
class JoinedCells {
public:
    explicit JoinedCells(std::size_t count)
        : m_parent(count) {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    }

    // False if the two were connected before.
    bool join(std::size_t first, std::size_t second) {
        const std::size_t firstRoot = root(first);
        const std::size_t secondRoot = root(second);
        m_parent[firstRoot] = secondRoot;
        return firstRoot != secondRoot;
    }

private:
    std::size_t root(std::size_t index) {
        while (m_parent[index] != index) {
            m_parent[index] = m_parent[m_parent[index]];
            index = m_parent[index];
        }
        return index;
    }

    std::vector<std::size_t> m_parent;
};

// All walls in random order; each wall between two groups of cells is opened.
void carveKruskal(CellMaze &maze, Random &random) {
    std::vector<CellSide> walls = maze.closedInnerWalls();
    shuffle(walls, random);
    JoinedCells joined(maze.cellCount());
    for (const CellSide &wall : walls)
        if (joined.join(maze.indexOf(wall.cell), maze.indexOf(neighbour(wall.cell, wall.side)))) maze.open(wall);
}

// Random walks from each cell to the part carved so far. Only the last way out of each cell is stored, which removes
// the walk's own loops; the result is a uniformly drawn spanning tree.
void carveWilson(CellMaze &maze, Random &random) {
    std::vector<bool> carved(maze.cellCount());
    std::vector<Side> lastWay(maze.cellCount());
    carved[random.below(maze.cellCount())] = true;
    for (std::size_t index = 0; index < maze.cellCount(); ++index) {
        const Cell start = maze.cellAt(index);
        for (Cell here = start; !carved[maze.indexOf(here)]; here = neighbour(here, lastWay[maze.indexOf(here)])) {
            const std::vector<Side> ways = sidesInside(maze, here);
            lastWay[maze.indexOf(here)] = ways[random.below(ways.size())];
        }
        for (Cell here = start; !carved[maze.indexOf(here)]; here = neighbour(here, lastWay[maze.indexOf(here)])) {
            carved[maze.indexOf(here)] = true;
            maze.open({here, lastWay[maze.indexOf(here)]});
        }
    }
}

} // namespace

std::string_view algorithmName(Algorithm algorithm) {
    for (const AlgorithmRow &row : kAlgorithms)
        if (row.algorithm == algorithm) return row.name;
    return {};
}

CellMaze carvePerfectMaze(int width, int height, Algorithm algorithm, Random &random) {
    CellMaze maze(width, height);
    switch (algorithm) {
    case Algorithm::Backtracker:
        carveBacktracker(maze, random);
        break;
    case Algorithm::Kruskal:
        carveKruskal(maze, random);
        break;
    case Algorithm::Wilson:
        carveWilson(maze, random);
        break;
    }
    return maze;
}

void openLoops(CellMaze &maze, std::int64_t millionths, Random &random) {
    std::vector<CellSide> walls = maze.closedInnerWalls();
    shuffle(walls, random);
    walls.resize(walls.size() * static_cast<std::size_t>(millionths) / 1'000'000);
    for (const CellSide &wall : walls) maze.open(wall);
}

} // namespace mazes
