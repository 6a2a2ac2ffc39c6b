// SPDX-License-Identifier: MIT
// Reports which contacts begin to last, and which end without an impact.
#pragma once

#include "exact/touching.h"

namespace phys {

class ContactEvents {
public:
    /// The contacts that are closed in a phase, before it begins.
    void add(const Touching &touching, const Response &response, MovingBall &ball);

private:
    bool m_isCarried = false; // in the phase before
    uint32_t m_wall = PHYS_NO_BOX;
};

} // namespace phys
