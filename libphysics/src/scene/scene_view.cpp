// SPDX-License-Identifier: MIT
#include "scene/scene_view.h"

#include <algorithm>

namespace phys {

namespace {

/// Keeps the lowest numbers in the caller's buffer, as a heap with the highest of them on top.
class LowestNumbers {
public:
    explicit LowestNumbers(std::span<uint32_t> out)
        : m_out(out) {}

    void add(uint32_t number) {
        ++m_count;
        if (m_stored < m_out.size()) {
            m_out[m_stored++] = number;
            std::push_heap(m_out.begin(), end());
        } else if (m_stored > 0 && number < m_out.front()) {
            std::pop_heap(m_out.begin(), end());
            m_out[m_stored - 1] = number;
            std::push_heap(m_out.begin(), end());
        }
    }
    void sort() { std::sort_heap(m_out.begin(), end()); }
    uint32_t count() const { return m_count; }

private:
    std::span<uint32_t>::iterator end() const { return m_out.begin() + static_cast<std::ptrdiff_t>(m_stored); }

    std::span<uint32_t> m_out;
    size_t m_stored = 0;
    uint32_t m_count = 0;
};

bool isBox(const phys_box &box) { // false for a NaN
    return box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z;
}

bool touch(const phys_box &a, const phys_box &b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
}

/// Each given box is part of exactly one merged box, and the grids know where those are.
uint32_t queryBoxes(const void *handle, const phys_box *region, uint32_t *out, uint32_t capacity) {
    const Scene &scene = *static_cast<const Scene *>(handle);
    if (!isBox(*region)) return 0;
    LowestNumbers found({out, capacity});
    const auto considerParts = [&](const std::vector<uint32_t> &parts, uint32_t first, uint32_t last) {
        for (uint32_t i = first; i < last; ++i) {
            if (touch(scene.given[parts[i]], *region)) found.add(parts[i]);
        }
    };
    const auto considerFloor = [&](uint32_t i) {
        considerParts(scene.floorParts, scene.floorFirst[i], scene.floorFirst[i + 1]);
    };
    const Vec2 low{region->min.x, region->min.y};
    const Vec2 high{region->max.x, region->max.y};
    if (scene.floors.size() > kHandful) {
        scene.floorGrid.visitOverlapping(low, high, considerFloor);
    } else {
        for (uint32_t i = 0; i < scene.floors.size(); ++i) considerFloor(i);
    }
    scene.solidGrid.visitOverlapping(
        low, high, [&](uint32_t i) { considerParts(scene.solidParts, scene.solidFirst[i], scene.solidFirst[i + 1]); });
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
            scene.floorTop,
            &scene,
            queryBoxes,
            queryContacts};
}

} // namespace phys
