// SPDX-License-Identifier: MIT
// All that a maze follows from: the same recipe gives the same files, byte for byte, on every machine.
#pragma once

#include "generator/algorithms.h"
#include "generator/board.h"

#include <cstdint>
#include <string>

namespace mazes {

// Grows when the same recipe gives other bytes than before.
inline constexpr int kGeneratorVersion = 1;

struct Recipe {
    std::uint64_t seed = 1;
    int width = 0; // cells
    int height = 0;
    Algorithm algorithm = Algorithm::Backtracker;
    std::int64_t loopMillionths = 0;
    Dimensions dimensions;
};

struct Maze {
    CellMaze cells;
    Cell entrance;
    CellSide exit;
    Board board;
};

// The recipe must be a possible one (see impossibility()).
Maze makeMaze(const Recipe &recipe);

// Cells on the way from the entrance to the exit, both counted.
int wayLength(const Maze &maze);

// "mazegen 1 --seed 7 --cells 5x5 ...": with every option, so that later defaults don't change what it means.
std::string generatorLine(const Recipe &recipe);

} // namespace mazes
