// SPDX-License-Identifier: MIT
// The walls of a maze of cells as few, long, straight pieces.
#pragma once

#include "generator/cell_maze.h"

#include <vector>

namespace mazes {

enum class Axis { X, Y };

// A straight wall on grid line number `line` from post `first` to post `last`. Grid lines and the posts on them are
// numbered from 0; a post is the square where two lines cross. Each post with a wall belongs to exactly one run, so
// that runs that meet are flush and never overlap.
struct WallRun {
    Axis axis = Axis::X;
    int line = 0;
    int first = 0;
    int last = 0;
    bool fillsFirst = false;
    bool fillsLast = false;
    bool isRim = false;
};

// All walls, the outer ones (rim) without the opening `exit`; those along x first, by line, then by post.
std::vector<WallRun> wallRuns(const CellMaze &maze, CellSide exit);

} // namespace mazes
