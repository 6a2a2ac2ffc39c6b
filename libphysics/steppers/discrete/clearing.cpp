// SPDX-License-Identifier: MIT
#include "clearing.h"

#include "scene/nearest.h"

#include <algorithm>
#include <utility>

namespace phys {

namespace {

/// How far around the ball a rectangle may reach, in radii: further costs more to find than it saves.
constexpr double kReach = 2.0;

/// Cuts [low, high] down to what `box`, grown by `margin`, leaves of it, on the side that is furthest from a place that
/// must stay inside. False if there is no such side.
bool cutOff(const phys_box &box, double margin, const Vec2 &place, Vec2 &low, Vec2 &high) {
    const Vec2 boxLow = inPlane(box.min) - margin;
    const Vec2 boxHigh = inPlane(box.max) + margin;
    const Vec2 before = place - boxHigh;
    const Vec2 after = boxLow - place;
    const double furthest = std::max({before.x, before.y, after.x, after.y});
    if (furthest < 0.0) return false;
    if (furthest == before.x) {
        low.x = std::max(low.x, boxHigh.x);
    } else if (furthest == before.y) {
        low.y = std::max(low.y, boxHigh.y);
    } else if (furthest == after.x) {
        high.x = std::min(high.x, boxLow.x);
    } else {
        high.y = std::min(high.y, boxLow.y);
    }
    return true;
}

/// The floor box under a place, or nullptr.
const phys_box *floorUnder(const Scene &scene, const Vec2 &place) {
    if (scene.hasOneFloor)
        return Scene::isOver(scene.floors.front(), place.x, place.y) ? &scene.floors.front() : nullptr;
    for (const uint32_t i : scene.floorGrid.near(place.x, place.y)) {
        if (Scene::isOver(scene.floors[i], place.x, place.y)) return &scene.floors[i];
    }
    return nullptr;
}

} // namespace

bool Clearing::findAround(const Vec2 &place) {
    // More than twice the tolerance, within which a full step takes a wall for touched.
    const double margin = m_scene.radius + 4.0 * m_scene.tolerance;
    if (margin > kCandidateReach * m_scene.radius) return false; // further than the grid tells
    for (const uint32_t solid : m_scene.solidsNear(place.x, place.y, m_scene.needsGrid)) {
        if (squaredDistanceFromAbove(m_scene.solids[solid], place) <= margin * margin)
            return false; // the usual no, soon
    }
    const phys_box *floor = floorUnder(m_scene, place);
    if (!floor) return false;
    const double reach = kReach * m_scene.radius;
    Vec2 low = glm::max(place - reach, inPlane(floor->min));
    Vec2 high = glm::min(place + reach, inPlane(floor->max));
    bool isFree = true;
    m_scene.solidGrid.visitOverlapping(place - reach, place + reach, [&](uint32_t solid) {
        isFree = isFree && cutOff(m_scene.solids[solid], margin, place, low, high);
    });
    if (!isFree) return false;
    m_low = low;
    m_high = high;
    return true;
}

} // namespace phys
