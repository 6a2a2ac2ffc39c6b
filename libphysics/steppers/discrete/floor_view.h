// SPDX-License-Identifier: MIT
// What a ball that lies on a floor can meet there, in the simple cases: nothing, or vertical faces.
#pragma once

#include "contact_step.h"

#include <span>

namespace phys {

/// A vertical face that the ball touches or reaches.
struct UprightFace {
    uint32_t box;
    int axis;      ///< 0: x, 1: y
    double normal; ///< from the box to the centre along the axis: -1 or 1
    double gap;    ///< m
    double place;  ///< m: coordinate of the centre along the axis at which the gap is 0
};

/// Whether a box that is higher than the ball's floor may touch the ball above or below its centre.
inline bool isSlope(const phys_box &box, const Ball &ball) {
    return box.min.z > ball.position.z || box.max.z < ball.position.z;
}

/// The boxes near a ball on a floor, looked up once per substep.
class FloorView {
public:
    /// Looks around a ball that would come to `end` without obstacles and is never farther than `way` (m) from the
    /// start. False unless it lies on the top of one floor, would still do so at the end, and the way is so short that
    /// the view contains all that it may meet.
    bool look(const StepContext &context, const Vec3 &start, const Vec3 &end, double way);

    /// Whether nothing is near the path.
    bool isEmpty() const { return m_count == 0; }
    /// Whether anything near it may touch the ball above or below its centre.
    bool hasSlopes(const StepContext &context, const Ball &ball) const;
    /// Finds the faces that the ball touches or would overlap at the end. False if it also meets anything else.
    bool findFaces(const StepContext &context, const Vec3 &start, const Vec3 &end);
    std::span<UprightFace> faces() { return {m_faces.data(), m_faceCount}; }

    /// Whether another end is on the floor, within the view, and overlaps nothing.
    bool hasRoom(const StepContext &context, const Vec3 &start, const Vec3 &end) const;
    /// Whether a path within a rectangle (m, of the centre) meets nothing except the faces, and doesn't leave any of
    /// them beyond its edge.
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
