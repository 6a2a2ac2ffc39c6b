// SPDX-License-Identifier: MIT
// What is around a ball at a step's start: it spares most steps the searches for contacts and for the next event.
#pragma once

#include "exact/touching.h"
#include "shared/floor_region.h"

namespace phys {

class Ground {
public:
    /// Looks for the region of the floor that the ball is in, and for the boxes that it touches there.
    Ground(const MovingBall &ball, FloorRegions &regions);

    /// Counts the boxes that the ball can reach in this step if nothing stops it: true if it overlaps none.
    bool lookAround(const MovingBall &ball);

    /// Whether the ball stays in its region from now on, unless it leaves a face that it leans on.
    bool keeps(const MovingBall &ball, double acceleration) const {
        return m_region && m_region->keeps(ball.position, ball.motion.velocity, ball.left, acceleration);
    }

    /// Whether the ball can meet nothing in this step but so many boxes, which it leans on.
    bool isOpen(const MovingBall &ball, uint32_t leansOn, double acceleration) const;

    /// Whether the ball is still where it started, in a region.
    bool holds(const MovingBall &ball) const { return ball.elapsed == 0.0 && !m_boxes.empty(); }
    /// All boxes that it touches there.
    std::span<const uint32_t> boxes() const { return {m_boxes.begin(), m_boxes.count()}; }

    /// Whether it is there on a floor, at one smooth wall at most, and has no velocity across them: then nothing
    /// depends on the order of contacts.
    bool isMovedAlong(const MovingBall &ball) const;
    /// What is touched then needs no search. Puts the ball at the radius of it.
    void touch(MovingBall &ball, Contacts &contacts) const;

private:
    static constexpr uint32_t kManyBoxes = 0xffffffff;

    const FloorRegion *m_region = nullptr;
    ShortList<uint32_t> m_boxes;
    double m_openWay = 0.0;   // m that the ball surely goes no further than in this step, if nothing stops it
    uint32_t m_nearBoxes = 0; // that it can reach on this way
};

} // namespace phys
