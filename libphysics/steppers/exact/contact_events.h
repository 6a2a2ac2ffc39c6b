// SPDX-License-Identifier: MIT
// Reports contacts that begin to last, and those that end without an impact.
#pragma once

#include "exact/touching.h"

namespace phys {

class ContactEvents {
public:
    /// The closed contacts of a phase, before it begins.
    void add(const Touching &touching, const Response &response, MovingBall &ball);
    /// The same for a ball that a floor carries, beside a wall or PHYS_NO_BOX.
    void addOnFloor(uint32_t wall, int axis, int side, MovingBall &ball);

private:
    void add(bool isCarried, const Contact *wall, MovingBall &ball);

    bool m_isCarried = false; // in the previous phase
    uint32_t m_wall = PHYS_NO_BOX;
};

} // namespace phys
