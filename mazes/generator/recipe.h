// SPDX-License-Identifier: MIT
// All inputs of a maze: the same recipe gives the same files, byte for byte, on every machine.
#pragma once

#include "generator/algorithms.h"
#include "generator/board.h"

#include <cstdint>
#include <string>

namespace mazes {

// Increased when the same recipe gives different bytes than before.
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

// The recipe must be possible (see impossibility()).
Maze makeMaze(const Recipe &recipe);

// Number of cells on the way from the entrance to the exit, both included.
int wayLength(const Maze &maze);

// "mazegen 1 --seed 7 --cells 5x5 ...": with every option, so that later defaults don't change its meaning.
std::string generatorLine(const Recipe &recipe);

} // namespace mazes
