// SPDX-License-Identifier: MIT
// Reports contacts that begin to last, and those that end without an impact.
#pragma once

#include "exact/touching.h"

namespace phys {

class ContactEvents {
public:
    /// The closed contacts of a phase, before it begins.
    void add(const Touching &touching, const Response &response, MovingBall &ball);
    /// A phase without such events: the ball goes on over a floor, beside a wall or PHYS_NO_BOX.
    void addPhase(uint32_t wall) {
        m_isCarried = true;
        m_wall = wall;
    }

private:
    bool m_isCarried = false; // in the previous phase
    uint32_t m_wall = PHYS_NO_BOX;
};

} // namespace phys
