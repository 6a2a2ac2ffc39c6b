// SPDX-License-Identifier: MIT
// What a ball that lies on a floor meets there, where that is easy to tell: nothing, or upright faces.
#pragma once

#include "contact_step.h"

#include <span>

namespace phys {

/// An upright face that the ball touches or reaches.
struct UprightFace {
    uint32_t box;
    int axis;      ///< 0: x, 1: y
    double normal; ///< from the box to the centre along the axis: -1 or 1
    double gap;    ///< m
    double place;  ///< m: of the centre along the axis where the gap is 0
};

/// Boxes near a ball on a floor, looked up once for a substep.
class FloorView {
public:
    /// Looks around a ball that would come to `end` if nothing was in its way, and is never further than `way` (m) from
    /// the start. False unless it lies on one floor's top, would still do so at the end, and the way is so short that
    /// the view holds what it may meet.
    bool look(const StepContext &context, const Vec3 &start, const Vec3 &end, double way);

    /// Whether nothing is near the way.
    bool isEmpty() const { return m_count == 0; }
    /// Finds the faces that the ball touches or would overlap at the end. False if it meets anything else, too.
    bool findFaces(const StepContext &context, const Vec3 &start, const Vec3 &end);
    std::span<const UprightFace> faces() const { return {m_faces.data(), m_faceCount}; }

    /// Whether another end is on the floor, within the view, and overlaps nothing.
    bool hasRoom(const StepContext &context, const Vec3 &start, const Vec3 &end) const;
    /// Whether a way within a rectangle (m, of the centre) meets nothing but the faces, and leaves none of them past
    /// its edge.
    bool isClear(const StepContext &context, const Vec2 &low, const Vec2 &high) const;

private:
    static constexpr uint32_t kMostNear = 8;

    bool addFace(const UprightFace &face, double tolerance);

    const phys_box *m_floor;
    double m_reach; ///< m
    std::array<uint32_t, kMostNear> m_near;
    uint32_t m_count;
    std::array<UprightFace, 2> m_faces;
    uint32_t m_faceCount;
};

} // namespace phys
