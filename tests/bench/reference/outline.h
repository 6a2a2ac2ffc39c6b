// SPDX-License-Identifier: MIT
// The parts of flush walls that a ball can touch: straight faces, merged across joints, and convex corners.
#pragma once

#include "support/scene.h"

#include <vector>

namespace bench {

struct Face {
    int axis;          // of the normal: 0 for x, 1 for y
    int sign;          // of the normal
    double coordinate; // along the normal's axis, m
    double low, high;  // along the other axis, m
};

struct Corner {
    double x, y;      // m
    int signX, signY; // towards the free quadrant
};

struct Outline {
    std::vector<Face> faces;
    std::vector<Corner> corners;
};

Outline outlineOf(const std::vector<Wall> &walls);

} // namespace bench
