// SPDX-License-Identifier: MIT
// Algorithms that choose the passages of a maze.
#pragma once

#include "generator/cell_maze.h"
#include "generator/random.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace mazes {

enum class Algorithm { Backtracker, Kruskal, Wilson };

struct AlgorithmRow {
    Algorithm algorithm;
    std::string_view name;
    std::string_view character;
};

inline constexpr std::array<AlgorithmRow, 3> kAlgorithms = {{
    {Algorithm::Backtracker, "backtracker", "long winding ways, few dead ends"},
    {Algorithm::Kruskal, "kruskal", "many short dead ends"},
    {Algorithm::Wilson, "wilson", "every perfect maze equally likely"},
}};

std::string_view algorithmName(Algorithm algorithm);

// A perfect maze: exactly one way between any two cells.
CellMaze carvePerfectMaze(int width, int height, Algorithm algorithm, Random &random);

// Opens this many millionths of the closed inner walls, rounded down; each adds one loop.
void openLoops(CellMaze &maze, std::int64_t millionths, Random &random);

} // namespace mazes
