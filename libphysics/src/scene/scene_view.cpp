// SPDX-License-Identifier: MIT
#include "scene/scene_view.h"

#include "scene/lowest.h"

#include <limits>

namespace phys {

namespace {

bool isBox(const phys_box &box) { // false for NaN
    return box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z;
}

bool touch(const phys_box &a, const phys_box &b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
}

/// Each given box is part of exactly one merged box, so the grids of merged boxes find it.
uint32_t queryBoxes(const void *handle, const phys_box *region, uint32_t *out, uint32_t capacity) {
    if (!handle || !region || (!out && capacity > 0) || !isBox(*region)) return 0;
    const Scene &scene = *static_cast<const Scene *>(handle);
    Lowest<uint32_t> found({out, capacity});
    scene.visitBoxes(toVec(region->min), toVec(region->max), [&](uint32_t box) {
        for (const uint32_t part : scene.partsOf(box)) {
            if (touch(scene.given[part], *region)) found.add(part);
        }
    });
    found.sort();
    return found.count();
}

uint32_t queryContacts(const void *handle, const phys_vec3 *centre, double reach, phys_contact *out,
                       uint32_t capacity) {
    uint32_t count = 0;
    const auto *scene = static_cast<const phys_scene *>(static_cast<const Scene *>(handle));
    phys_scene_contacts(scene, centre, reach, out, capacity, &count);
    return count;
}

} // namespace

phys_scene_view viewOf(const Scene &scene) {
    return {sizeof(phys_scene_view),
            static_cast<uint32_t>(scene.given.size()),
            scene.given.empty() ? nullptr : scene.given.data(),
            scene.radius,
            scene.hasFloor ? scene.floorTop : std::numeric_limits<double>::quiet_NaN(),
            &scene,
            queryBoxes,
            queryContacts};
}

} // namespace phys
