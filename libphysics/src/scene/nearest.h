// SPDX-License-Identifier: MIT
// The point of a box nearest to a ball: model.md 5.1 and 5.7, in three dimensions.
#pragma once

#include "base/vec.h"

#include <algorithm>

namespace phys {

/// The point of a box nearest to the ball's centre.
struct Nearest {
    Vec3 point;
    Vec3 normal;      ///< unit, from the box to the centre
    double distance;  ///< from the point to the centre, m; negative: the centre is inside, at this depth
    uint32_t feature; ///< PHYS_FEATURE_*
};

/// Like std::clamp, by value: two instructions instead of two jumps.
inline double limited(double x, double low, double high) { return std::min(std::max(x, low), high); }

/// Square of the distance from p to the box; 0 inside.
inline double squaredDistance(const phys_box &box, const Vec3 &p) {
    const Vec3 d{p.x - limited(p.x, box.min.x, box.max.x), p.y - limited(p.y, box.min.y, box.max.y),
                 p.z - limited(p.z, box.min.z, box.max.z)};
    return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// The general case; for a centre inside, out through the nearest face (order of ties: -x +x -y +y -z +z).
Nearest nearest(const phys_box &box, const Vec3 &p);

} // namespace phys
