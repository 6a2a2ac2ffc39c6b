// SPDX-License-Identifier: MIT
#include "scene/nearest.h"

#include <array>
#include <cmath>
#include <limits>

namespace phys {

namespace {

/// For a centre inside or on the surface: out through the nearest face, model.md 5.7.
Nearest nearestFace(const phys_box &box, const Vec3 &p) {
    struct Face {
        double depth;
        Vec3 normal;
    };
    const std::array<Face, 6> faces{{{p.x - box.min.x, {-1, 0, 0}},
                                     {box.max.x - p.x, {1, 0, 0}},
                                     {p.y - box.min.y, {0, -1, 0}},
                                     {box.max.y - p.y, {0, 1, 0}},
                                     {p.z - box.min.z, {0, 0, -1}},
                                     {box.max.z - p.z, {0, 0, 1}}}};
    // On ties the first one wins, so the order of the faces matters.
    const Face &face =
        *std::min_element(faces.begin(), faces.end(), [](const Face &a, const Face &b) { return a.depth < b.depth; });
    return {p + face.depth * face.normal, face.normal, -face.depth, PHYS_FEATURE_INSIDE};
}

} // namespace

Nearest nearest(const phys_box &box, const Vec3 &p) {
    const Vec3 point{limited(p.x, box.min.x, box.max.x), limited(p.y, box.min.y, box.max.y),
                     limited(p.z, box.min.z, box.max.z)};
    const Vec3 d = p - point;
    const int outside = (d.x != 0.0) + (d.y != 0.0) + (d.z != 0.0);
    // A face's normal is exact, and its distance isn't rounded by a square root.
    if (outside == 0) return nearestFace(box, p);
    if (outside == 1) {
        const double distance = std::abs(d.x + d.y + d.z);
        return {point, d / distance, distance, PHYS_FEATURE_FACE};
    }
    const double squared = d.x * d.x + d.y * d.y + d.z * d.z;
    if (squared < std::numeric_limits<double>::min()) return nearestFace(box, p); // the direction would be undefined
    const double distance = std::sqrt(squared);
    return {point, d / distance, distance, outside == 2 ? PHYS_FEATURE_EDGE : PHYS_FEATURE_CORNER};
}

} // namespace phys
