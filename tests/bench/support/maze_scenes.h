// SPDX-License-Identifier: MIT
// Mazes of cells of 1 m with walls 0.2 m thick: closed ones, so that no run ends early.
#pragma once

#include "support/scene.h"

#include <array>

namespace bench {

// Five mazes of each size have exactly this many walls after straight ones were merged (rim included).
struct MazeSize {
    int cells; // a side
    int walls;
    std::array<unsigned, 5> seeds;
};

inline constexpr std::array<MazeSize, 3> kMazeSizes = {{
    {16, 118, {15, 21, 42, 45, 77}},
    {32, 495, {25, 61, 97, 144, 160}},
    {64, 2011, {26, 30, 243, 253, 258}},
}};

// The ball starts at rest in a cell in the middle; tilts follow from the same seed.
Scene mazeScene(const MazeSize &size, unsigned seed);

} // namespace bench
