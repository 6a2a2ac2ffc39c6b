// SPDX-License-Identifier: MIT
#include "board.h"

#include "shared/closed_form.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr int kMostPushes = 64; // model.md 5.7

double coordinate(const Vec3 &v, int axis) { return axis == 0 ? v.x : v.y; }
double low(const phys_box &box, int axis) { return axis == 0 ? box.min.x : box.min.y; }
double high(const phys_box &box, int axis) { return axis == 0 ? box.max.x : box.max.y; }

/// The side of the box that the plane's normal points away from.
double front(const phys_box &box, const Plane &plane) {
    return plane.sign > 0.0 ? high(box, plane.axis) : low(box, plane.axis);
}

/// How far (x, y) is inside the rectangle; negative outside.
double depthInside(const phys_box &box, const Vec3 &p) {
    return std::min(std::min(p.x - box.min.x, box.max.x - p.x), std::min(p.y - box.min.y, box.max.y - p.y));
}

/// Whether p is at a border of the floor, within the tolerance, and `direction` leads out there.
bool leads(const phys_box &box, const Vec3 &p, const Vec2 &direction, double tolerance) {
    return (direction.x < 0.0 && p.x - box.min.x <= tolerance) || (direction.x > 0.0 && box.max.x - p.x <= tolerance) ||
           (direction.y < 0.0 && p.y - box.min.y <= tolerance) || (direction.y > 0.0 && box.max.y - p.y <= tolerance);
}

/// The box without bottom and top: ways out of it lie in the plane.
phys_box upright(phys_box box) {
    box.min.z = -kNever;
    box.max.z = kNever;
    return box;
}

} // namespace

Board::Board(const Scene &scene)
    : m_scene(&scene)
    , m_grazing(std::min(0.05, 2.0 * std::sqrt(scene.tolerance / scene.radius)))
    , m_near(std::max(scene.solids.size(), scene.floors.size())) {}

bool Board::isOpen(const Vec3 &p, double way) const {
    const Scene &scene = *m_scene;
    if (scene.floors.size() != 1 || depthInside(scene.floors[0], p) <= way) return false;
    if (way > (kCandidateReach - 1.01) * radius()) return false;
    const double reach = radius() * (1.0 + 1e-9) + tolerance() + way;
    for (const uint32_t solid : scene.solidsNear(p.x, p.y, scene.needsGrid)) {
        if (squaredDistance(scene.solids[solid], p) <= reach * reach) return false;
    }
    return true;
}

void Board::findTouches(const Vec3 &p, Touches &touches) const {
    touches.count = 0;
    touches.overflow = false;
    // A little more than the radius: which of these really touch is told by the distance itself.
    const double reach = radius() * (1.0 + 1e-9) + tolerance();
    for (const uint32_t solid : m_scene->solidsNear(p.x, p.y, m_scene->needsGrid)) {
        if (squaredDistance(m_scene->solids[solid], p) > reach * reach) continue;
        const Nearest close = nearest(m_scene->solids[solid], p);
        if (close.distance - radius() > tolerance()) continue;
        add({close.normal, close.point, solid, close.feature}, touches);
    }
}

void Board::add(const Touch &touch, Touches &touches) const {
    for (uint32_t i = 0; i < touches.count; ++i) {
        Touch &known = touches.items[i];
        if (glm::length(known.normal - touch.normal) > sameNormal()) continue;
        if (touch.feature < known.feature) known = touch;
        return;
    }
    touches.overflow = touches.count == kMostTouches;
    if (!touches.overflow) touches.items[touches.count++] = touch;
}

std::span<const uint32_t> Board::near(const Vec2 &lowEnd, const Vec2 &highEnd) const {
    if (!m_scene->needsGrid) return m_scene->allSolids;
    const uint32_t count = m_scene->solidGrid.overlapping(lowEnd, highEnd, m_near);
    return {m_near.data(), count};
}

double Board::faceEnd(const Plane &plane, const Vec3 &p, double direction, double limit) const {
    const int along = 1 - plane.axis;
    double end = coordinate(p, along);
    // Each round goes on to the end of the solid that reaches furthest of those that cover the place reached so far.
    while (direction * (limit - end) > 0.0) {
        Vec3 place = p;
        place[along] = end;
        double further = end;
        for (const uint32_t solid : m_scene->solidsNear(place.x, place.y, m_scene->needsGrid)) {
            const phys_box &box = m_scene->solids[solid];
            const bool carries = std::abs(front(box, plane) - plane.coordinate) <= tolerance() &&
                                 low(box, along) <= end + tolerance() && high(box, along) >= end - tolerance() &&
                                 box.min.z <= p.z && box.max.z >= p.z;
            if (!carries) continue;
            const double reach = direction > 0.0 ? high(box, along) : low(box, along);
            if (direction * (reach - further) > 0.0) further = reach;
        }
        if (further == end) break;
        end = further;
    }
    return end;
}

uint32_t Board::carrier(const Plane &plane, const Vec3 &p, const Vec3 &direction) const {
    const int along = 1 - plane.axis;
    uint32_t best = 0;
    double furthest = -kNever;
    for (const uint32_t solid : m_scene->solidsNear(p.x, p.y, m_scene->needsGrid)) {
        const phys_box &box = m_scene->solids[solid];
        const bool carries = std::abs(front(box, plane) - plane.coordinate) <= tolerance() &&
                             low(box, along) <= p[along] && high(box, along) >= p[along] && box.min.z <= p.z &&
                             box.max.z >= p.z;
        if (!carries) continue;
        // The shorter of the ways to its side and to its lower or upper end.
        const double side = direction[along] < 0.0 ? p[along] - low(box, along) : high(box, along) - p[along];
        const double vertical = direction.z < 0.0 ? p.z - box.min.z : box.max.z - p.z;
        if (std::min(side, vertical) <= furthest) continue;
        furthest = std::min(side, vertical);
        best = solid;
    }
    return best;
}

Heights Board::heights(const Vec3 &p, const Vec3 &normal) const {
    Heights heights{p.z, p.z};
    for (const uint32_t solid : m_scene->solidsNear(p.x, p.y, m_scene->needsGrid)) {
        const phys_box &box = m_scene->solids[solid];
        const Nearest close = nearest(box, p);
        const bool carries =
            close.distance - radius() <= tolerance() && glm::length(close.normal - normal) <= sameNormal();
        if (!carries) continue;
        heights = {std::min(heights.low, box.min.z), std::max(heights.high, box.max.z)};
    }
    return heights;
}

bool Board::isBehind(const Plane &plane, uint32_t solid) const {
    return plane.sign * (front(m_scene->solids[solid], plane) - plane.coordinate) <= tolerance();
}

bool Board::pushOut(Vec3 &p, bool supported, double &deepest) const {
    for (int push = 0; push < kMostPushes; ++push) {
        double worst = -tolerance();
        Nearest out{};
        for (const uint32_t solid : m_scene->solidsNear(p.x, p.y, m_scene->needsGrid)) {
            const phys_box &box = m_scene->solids[solid];
            if (squaredDistance(box, p) > radius() * radius()) continue;
            const bool atHeight = box.min.z <= p.z && box.max.z >= p.z;
            const Nearest close = nearest(supported && atHeight ? upright(box) : box, p);
            if (close.distance - radius() >= worst) continue;
            worst = close.distance - radius();
            out = close;
        }
        if (worst == -tolerance()) return true;
        deepest = std::max(deepest, -worst);
        // From the surface, not by the depth: on a face the coordinate is then exact.
        p = out.point + radius() * out.normal;
    }
    return false;
}

std::optional<uint32_t> Board::floorUnder(const Vec3 &p, const Vec2 &direction) const {
    std::optional<uint32_t> best;
    double deepest = -tolerance();
    const auto consider = [&](uint32_t floor) {
        const phys_box &box = m_scene->floors[floor];
        const double depth = depthInside(box, p);
        if (depth < deepest || leads(box, p, direction, tolerance())) return;
        if (best && depth == deepest) return;
        deepest = depth;
        best = floor;
    };
    if (m_scene->floors.size() <= kHandful) {
        for (uint32_t floor = 0; floor < m_scene->floors.size(); ++floor) consider(floor);
    } else {
        const Vec2 margin(tolerance());
        const uint32_t count = m_scene->floorGrid.overlapping(inPlane(p) - margin, inPlane(p) + margin, m_near);
        for (uint32_t i = 0; i < count; ++i) consider(m_near[i]);
    }
    return best;
}

} // namespace phys
