// SPDX-License-Identifier: MIT
// The board with its lengths: boxes, and the ball's start.
#pragma once

#include "generator/cell_maze.h"
#include "generator/length.h"

#include <array>
#include <string>
#include <vector>

namespace mazes {

struct Dimensions {
    Length ballRadius = 6 * kMillimetre;
    Length pitch = 36 * kMillimetre; // from the centre of a cell to that of the next
    Length wallThickness = 5 * kMillimetre;
    Length wallHeight = 14 * kMillimetre; // above the floor
    Length floorThickness = 5 * kMillimetre;
};

// Why no ball could roll on a board of these dimensions, in one line; empty if it could.
std::string impossibility(const Dimensions &dimensions);

using Point = std::array<Length, 3>; // x right, y away, z up; the floor's top is z = 0

enum class Material { Floor, Exit, Rim, Wall };

struct Box {
    Point min;
    Point max;
    Material material;
};

struct Board {
    Dimensions dimensions;
    Point start; // the ball's centre, resting on the floor
    std::vector<Box> boxes;
};

// The board is centred on x = y = 0 and its floor ends at the rim's outer face: the ball rolls off the edge through the
// opening `exit`. Boxes touch without overlapping. The dimensions must be possible.
Board buildBoard(const CellMaze &maze, Cell entrance, CellSide exit, const Dimensions &dimensions);

} // namespace mazes
