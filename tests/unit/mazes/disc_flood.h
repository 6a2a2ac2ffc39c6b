// SPDX-License-Identifier: MIT
// The region that a disc can reach among the walls of a maze, computed from the boxes alone, on a grid of positions.
#pragma once

#include "maze_text.h"

#include <cstddef>
#include <vector>

class DiscFlood {
public:
    // All positions that the disc's centre can reach from the maze's start, in moves of `step` along x or y, without
    // leaving the board's outline. A disc of radius 0 finds every leak wider than `step`. The outline must be a whole
    // number of steps wide.
    DiscFlood(const MazeText &maze, Nanometres radius, Nanometres step);

    bool reaches(Nanometres x, Nanometres y) const;

    // The number of separate parts of the board's outline that are reached.
    int waysOut() const;

private:
    enum class Place : unsigned char { Open, Blocked, Reached };

    std::size_t indexOf(Nanometres column, Nanometres row) const;
    void block(const TextBox &wall, Nanometres radius);
    void spreadFrom(std::size_t start);
    std::vector<std::size_t> outline() const;

    TextBox m_bounds;
    Nanometres m_step;
    Nanometres m_columns;
    Nanometres m_rows;
    std::vector<Place> m_places;
};
