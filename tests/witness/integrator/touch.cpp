// SPDX-License-Identifier: MIT
#include "touch.h"

#include <algorithm>

namespace witness {

namespace {

/// For a centre inside the box: out through the nearest face.
Touch fromInside(const phys_box &box, const Vector &p, Real radius) {
    const Real depths[] = {p.x - box.min.x, box.max.x - p.x, p.y - box.min.y,
                           box.max.y - p.y, p.z - box.min.z, box.max.z - p.z};
    const Vector normals[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
    const int least = static_cast<int>(std::min_element(depths, depths + 6) - depths);
    return {normals[least], -depths[least] - radius, depths[least] > 0 ? 0 : 1, least == 5};
}

} // namespace

Touch touchOf(const phys_box &box, const Vector &p, Real radius) {
    const Vector nearest = {std::clamp<Real>(p.x, box.min.x, box.max.x), std::clamp<Real>(p.y, box.min.y, box.max.y),
                            std::clamp<Real>(p.z, box.min.z, box.max.z)};
    const Vector way = p - nearest;
    const Real distance = length(way);
    if (distance == 0) return fromInside(box, p, radius);
    const int codes = (way.x != 0) + (way.y != 0) + (way.z != 0);
    return {(1 / distance) * way, distance - radius, codes, codes == 1 && way.z > 0};
}

} // namespace witness
