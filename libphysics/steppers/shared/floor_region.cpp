// SPDX-License-Identifier: MIT
#include "shared/floor_region.h"

#include "scene/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace phys {

namespace {

constexpr uint32_t kMostFloors = 8; ///< capacity of a FloorView

/// A region while it is being reduced.
class Cutting {
public:
    /// way: for which it should extend far, m.
    Cutting(const Scene &scene, FloorRegions::Beside beside, const Vec3 &place, const Vec2 &way)
        : m_scene(scene)
        , m_beside(beside)
        , m_place(place)
        , m_way(way)
        , m_margin(4.0 * scene.tolerance)
        , m_clear(scene.radius + m_margin) {
        m_region.z = place.z;
        m_region.foundAt = inPlane(place);
    }

    /// cell: of the position in the scene's grid.
    FloorRegion run(size_t cell) {
        findWindow(cell);
        for (const uint32_t number : m_scene.hasManyBoxes ? m_scene.grid.nearCell(cell) : m_scene.allBoxes) {
            if (!cut(m_scene.boxes[number])) return {};
        }
        if (!m_floor) return {};
        cutToFloor();
        if (!isOverFloor(0, m_place.x) || !isOverFloor(1, m_place.y)) return {};
        findFaces();
        return isEasy() ? m_region : FloorRegion();
    }

private:
    static constexpr uint32_t kRoom = 16;

    /// Begins with all positions for which only the boxes of this cell matter: the cell, and around it as far as the
    /// grid lists more than can be touched.
    void findWindow(size_t cell) {
        const Grid::Square square = m_scene.grid.squareOf(cell);
        const double around =
            m_scene.hasManyBoxes ? (kCandidateReach - 1.0) * m_scene.radius - 2.0 * m_margin : INFINITY;
        for (int axis = 0; axis < 2; ++axis) {
            m_region.along[axis].low = square.low[axis] - around;
            m_region.along[axis].high = square.high[axis] + around;
        }
    }

    /// Removes the positions at which the ball would overlap a box. False if the ball is so near to it that no region
    /// contains the ball.
    bool cut(const phys_box &box) {
        const double top = m_place.z - m_scene.radius;
        if (box.max.z < top - m_margin) return true;
        if (box.max.z <= top + m_scene.tolerance) {
            if (m_floorCount == kRoom) return false;
            m_floors[m_floorCount++] = &box;
            if (Scene::isOver(box, m_place.x, m_place.y)) m_floor = &box;
            return true;
        }
        if (box.min.z > m_place.z + kCandidateReach * m_scene.radius + m_margin) return true;
        if (m_count == kRoom) return false;
        m_boxes[m_count++] = &box;
        m_region.hasSlopes = m_region.hasSlopes || !isUpright(box);
        return isTouched(box) ? leanOn(box) : cutAway(box);
    }

    /// Whether another floor overlaps the region or its faces, so that a different one may carry the ball.
    bool hasOtherFloor() const {
        const double ends = 2.0 * m_margin; // for the faces, and for what counts as contact there
        return std::any_of(m_floors.begin(), m_floors.begin() + m_floorCount, [&](const phys_box *box) {
            const auto isBeside = [&](int axis) {
                return (&box->min.x)[axis] > m_region.along[axis].high + ends ||
                       (&box->max.x)[axis] < m_region.along[axis].low - ends;
            };
            return box != m_floor && !isBeside(0) && !isBeside(1);
        });
    }

    uint32_t numberOf(const phys_box &box) const { return static_cast<uint32_t>(&box - m_scene.boxes.data()); }

    void cutToFloor() {
        m_region.floor = numberOf(*m_floor);
        m_region.isEven = m_place.z == m_floor->max.z + m_scene.radius && m_floorCount == 1;
        for (int axis = 0; axis < 2; ++axis) {
            cutAt(axis, true, (&m_floor->min.x)[axis] + m_margin);
            cutAt(axis, false, (&m_floor->max.x)[axis] - m_margin);
        }
    }

    /// Whether a centre is away from the floor's ends, on which another floor may carry the ball.
    bool isOverFloor(int axis, double place) const {
        return place >= (&m_floor->min.x)[axis] + m_margin && place <= (&m_floor->max.x)[axis] - m_margin;
    }

    double faceAtLow(const phys_box &box, int axis) const { return (&box.max.x)[axis] + m_scene.radius; }
    double faceAtHigh(const phys_box &box, int axis) const { return (&box.min.x)[axis] - m_scene.radius; }

    /// Whether the ball touches a face along the axis, away from the face's ends.
    bool isTouched(const phys_box &box, int axis) const {
        const bool isThere = m_place[axis] == faceAtLow(box, axis) || m_place[axis] == faceAtHigh(box, axis);
        const double along = m_place[1 - axis];
        return isThere && isUpright(box) && along > (&box.min.x)[1 - axis] + m_margin &&
               along < (&box.max.x)[1 - axis] - m_margin;
    }
    bool isTouched(const phys_box &box) const { return isTouched(box, 0) || isTouched(box, 1); }

    bool isUpright(const phys_box &box) const { return box.min.z <= m_place.z && box.max.z >= m_place.z; }

    /// Restricts the region to positions beside a face that the ball touches, and between its ends. False if there is
    /// already such a face.
    bool leanOn(const phys_box &box) {
        const int axis = isTouched(box, 0) ? 0 : 1;
        FloorRegion::Range &range = m_region.along[axis];
        cutAt(1 - axis, true, (&box.min.x)[1 - axis] + 2.0 * m_margin);
        cutAt(1 - axis, false, (&box.max.x)[1 - axis] - 2.0 * m_margin);
        const bool isLow = m_place[axis] == faceAtLow(box, axis);
        double &face = isLow ? range.lowFace : range.highFace;
        if (face != FloorRegion::kNoFace) return false;
        face = isLow ? faceAtLow(box, axis) : faceAtHigh(box, axis); // m_place may be a zero of the other sign
        (isLow ? range.lowBox : range.highBox) = numberOf(box);
        cutAt(axis, isLow, isLow ? face + m_margin : face - m_margin);
        return true;
    }

    /// Position of a box relative to the ball, along an axis.
    struct Side {
        int axis;
        bool isLow;
        double beyond;   ///< m: distance beyond the required one
        double approach; ///< m: part of the way that leads there
    };

    Side sideAlong(int axis, const phys_box &box) const {
        const double above = m_place[axis] - (&box.max.x)[axis] - m_clear;
        const double below = (&box.min.x)[axis] - m_place[axis] - m_clear;
        const bool isLow = above > below;
        return {axis, isLow, std::max(above, below), std::max(0.0, isLow ? -m_way[axis] : m_way[axis])};
    }

    /// Along the axis in which the ball comes near it later, or in which it is farther away.
    Side sideOf(const phys_box &box) const {
        const Side x = sideAlong(0, box), y = sideAlong(1, box);
        const double xLater = x.beyond * y.approach, yLater = y.beyond * x.approach;
        const bool isBeyondBoth = x.beyond > 0.0 && y.beyond > 0.0;
        return (isBeyondBoth && xLater != yLater ? xLater > yLater : x.beyond >= y.beyond) ? x : y;
    }

    /// Removes the positions on one side of a coordinate.
    void cutAt(int axis, bool isLow, double place) {
        FloorRegion::Range &range = m_region.along[axis];
        if (isLow)
            range.low = std::max(range.low, place);
        else
            range.high = std::min(range.high, place);
    }

    /// Removes the side on which the box is. False if it is too near.
    bool cutAway(const phys_box &box) {
        const auto [axis, isLow, beyond, approach] = sideOf(box);
        if (!(beyond > 0.0)) return m_beside == FloorRegions::Beside::edges && cutBesideEdge(box);
        cutAt(axis, isLow, isLow ? (&box.max.x)[axis] + m_clear : (&box.min.x)[axis] - m_clear);
        return true;
    }

    /// Beside an upright edge, a corner of the region lies between edge and ball, at the required distance from the
    /// edge. False if the ball is too near.
    bool cutBesideEdge(const phys_box &box) {
        const Vec2 place = inPlane(m_place);
        const Vec2 edge(limited(place.x, box.min.x, box.max.x), limited(place.y, box.min.y, box.max.y));
        const Vec2 away = place - edge;
        const double share = m_clear / glm::length(away); // infinite inside of the box
        if (away.x == 0.0 || away.y == 0.0 || !(share < 1.0)) return false;
        for (int axis = 0; axis < 2; ++axis) cutAt(axis, away[axis] > 0.0, edge[axis] + share * away[axis]);
        return true;
    }

    bool isEasy() const {
        // A ball that just fits between two faces touches both.
        const bool hasRoom =
            m_region.along[0].low <= m_region.along[0].high && m_region.along[1].low <= m_region.along[1].high;
        return hasRoom && m_region.has(fromVec(m_place)) && !hasOtherFloor() && seen() <= kMostFloors;
    }

    /// The number of boxes that a FloorView may see from somewhere in the region.
    uint32_t seen() const {
        const double far = kCandidateReach * m_scene.radius + m_margin;
        const auto isSeen = [&](const phys_box *box) {
            const auto isNear = [&](int axis) {
                return (&box->min.x)[axis] <= m_region.along[axis].high + far &&
                       (&box->max.x)[axis] >= m_region.along[axis].low - far;
            };
            return isNear(0) && isNear(1);
        };
        return static_cast<uint32_t>(std::count_if(m_boxes.begin(), m_boxes.begin() + m_count, isSeen));
    }

    /// Faces that bound the region: those that extend along its whole side, or else beside the position.
    void findFaces() {
        for (uint32_t i = 0; i < m_count; ++i) {
            const phys_box &box = *m_boxes[i];
            for (int axis = 0; axis < 2 && isUpright(box); ++axis) {
                FloorRegion::Range &range = m_region.along[axis];
                const FloorRegion::Range &length = m_region.along[1 - axis];
                const auto reaches = [&](double low, double high) {
                    return (&box.min.x)[1 - axis] + m_margin < low && (&box.max.x)[1 - axis] - m_margin > high;
                };
                const bool isLong = reaches(length.low, length.high);
                if (!isLong && !reaches(m_place[1 - axis], m_place[1 - axis])) continue;
                // Of several boxes in one plane the one that extends farthest, so that no shorter one hides it.
                const auto bound = [&](double place, double &face, uint32_t &number) {
                    const bool hasLong = face != FloorRegion::kNoFace;
                    if (hasLong != isLong ? hasLong : !isLonger(box, number, 1 - axis)) return;
                    if (isLong) face = place;
                    number = numberOf(box);
                };
                const double atLow = faceAtLow(box, axis), atHigh = faceAtHigh(box, axis);
                if (range.low == (&box.max.x)[axis] + m_clear && isOverFloor(axis, atLow))
                    bound(atLow, range.lowFace, range.lowBox);
                if (range.high == (&box.min.x)[axis] - m_clear && isOverFloor(axis, atHigh))
                    bound(atHigh, range.highFace, range.highBox);
            }
        }
    }

    /// other: PHYS_NO_BOX for none.
    bool isLonger(const phys_box &box, uint32_t other, int axis) const {
        const auto length = [axis](const phys_box &b) { return (&b.max.x)[axis] - (&b.min.x)[axis]; };
        return other == PHYS_NO_BOX || length(box) > length(m_scene.boxes[other]);
    }

    const Scene &m_scene;
    FloorRegions::Beside m_beside;
    Vec3 m_place;
    Vec2 m_way;
    double m_margin, m_clear; ///< m
    FloorRegion m_region;
    const phys_box *m_floor = nullptr;
    std::array<const phys_box *, kRoom> m_boxes, m_floors;
    uint32_t m_count = 0, m_floorCount = 0;
};

} // namespace

FloorRegions::FloorRegions(const Scene &scene, Beside beside)
    : m_scene(scene)
    , m_beside(beside)
    , m_regions(std::make_unique<std::array<FloorRegion, kKept>>())
    , m_last(m_regions->data()) {}

const FloorRegion *FloorRegions::find(const phys_vec3 &place, const Vec2 &velocity, double time) {
    const size_t cell = m_scene.grid.cellAt(place.x, place.y);
    if (cell == Grid::kNoCell) return nullptr;
    const bool isLeaning = velocity.x == 0.0 || velocity.y == 0.0;
    const Vec2 whole = time * velocity;
    const bool isShort = glm::dot(whole, whole) < 0.25 * m_scene.radius * m_scene.radius;
    const Vec2 way = isShort ? whole : Vec2(0.0); // a longer one leads out of any region
    FloorRegion &kept = (*m_regions)[(cell + (isLeaning ? kKept / 2 : 0)) % kKept];
    if (!kept.has(place) || (kept.endsOpenOn(way, place) && kept.foundAt != inPlane(place))) {
        const FloorRegion found = Cutting(m_scene, m_beside, toVec(place), way).run(cell);
        if (!found.has(place)) return nullptr;
        kept = found;
    }
    m_last = &kept;
    return m_last;
}

} // namespace phys
