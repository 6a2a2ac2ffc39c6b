// SPDX-License-Identifier: MIT
#include "reference/outline.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace bench {

namespace {

constexpr double kJoint = 1e-9; // m: walls closer than this are flush

std::array<Face, 4> facesOf(const Wall &wall) {
    return {{{0, -1, wall.x0, wall.y0, wall.y1},
             {0, 1, wall.x1, wall.y0, wall.y1},
             {1, -1, wall.y0, wall.x0, wall.x1},
             {1, 1, wall.y1, wall.x0, wall.x1}}};
}

auto lineOf(const Face &face) { return std::tuple(face.axis, face.sign, face.coordinate); }

std::vector<Face> mergedFaces(const std::vector<Wall> &walls) {
    std::vector<Face> all;
    for (const Wall &wall : walls)
        for (const Face &face : facesOf(wall)) all.push_back(face);
    std::sort(all.begin(), all.end(),
              [](const Face &a, const Face &b) { return std::tuple(lineOf(a), a.low) < std::tuple(lineOf(b), b.low); });
    std::vector<Face> merged;
    for (const Face &face : all) {
        const bool continues =
            !merged.empty() && lineOf(merged.back()) == lineOf(face) && face.low <= merged.back().high + kJoint;
        if (continues)
            merged.back().high = std::max(merged.back().high, face.high);
        else
            merged.push_back(face);
    }
    return merged;
}

bool contains(const Wall &wall, double x, double y) { return x > wall.x0 && x < wall.x1 && y > wall.y0 && y < wall.y1; }

// A corner stands out if three of the four quadrants around it are free.
bool standsOut(const Corner &corner, const std::vector<Wall> &walls) {
    int filled = 0;
    for (const Wall &wall : walls) {
        const bool isNear = corner.x >= wall.x0 - kJoint && corner.x <= wall.x1 + kJoint &&
                            corner.y >= wall.y0 - kJoint && corner.y <= wall.y1 + kJoint;
        if (!isNear) continue;
        for (const int signX : {-1, 1})
            for (const int signY : {-1, 1})
                filled += contains(wall, corner.x + signX * kJoint, corner.y + signY * kJoint);
    }
    return filled == 1;
}

} // namespace

Outline outlineOf(const std::vector<Wall> &walls) {
    Outline outline{mergedFaces(walls), {}};
    for (const Wall &wall : walls)
        for (const Corner &corner : {Corner{wall.x0, wall.y0, -1, -1}, Corner{wall.x1, wall.y0, 1, -1},
                                     Corner{wall.x0, wall.y1, -1, 1}, Corner{wall.x1, wall.y1, 1, 1}})
            if (standsOut(corner, walls)) outline.corners.push_back(corner);
    return outline;
}

} // namespace bench
