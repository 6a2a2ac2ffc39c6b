// SPDX-License-Identifier: MIT
// The surroundings of the ball where the event loop begins; they make searches for contacts and events unnecessary in
// most steps.
#pragma once

#include "exact/touching.h"
#include "shared/floor_region.h"

namespace phys {

class Ground {
public:
    /// Looks up the region of the floor that contains the ball, and the boxes that it touches there.
    Ground(const MovingBall &ball, FloorRegions &regions);

    /// Counts the boxes that the ball can reach in this step without obstacles: true if it overlaps none.
    bool lookAround(const MovingBall &ball);

    /// Whether the ball stays in its region from now on, unless it leaves a face on which it leans.
    bool keeps(const MovingBall &ball, double acceleration) const {
        return m_region && m_region->keeps(ball.position, ball.motion.velocity, ball.left, acceleration);
    }

    /// Whether the ball can meet nothing in this step except this many boxes, on which it leans.
    bool isOpen(const MovingBall &ball, uint32_t leansOn, double acceleration) const;

    /// Whether the ball is still where the loop began, in a region.
    bool holds(const MovingBall &ball) const { return ball.elapsed == m_start && !m_boxes.empty(); }
    /// All boxes that it touches there.
    std::span<const uint32_t> boxes() const { return {m_boxes.begin(), m_boxes.count()}; }

private:
    static constexpr uint32_t kManyBoxes = 0xffffffff;

    double m_start; ///< s of the step gone by
    const FloorRegion *m_region = nullptr;
    ShortList<uint32_t> m_boxes;
    double m_openWay = 0.0;   // m: upper bound of the ball's displacement in this step without obstacles
    uint32_t m_nearBoxes = 0; // number of boxes within this displacement
};

} // namespace phys
