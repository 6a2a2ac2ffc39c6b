// SPDX-License-Identifier: MIT
// What holds a ball at rest at a position, in the simple cases.
#pragma once

#include "contact/contact.h"
#include "floor_contact.h"

#include <cmath>

namespace phys {

/// The contacts of a ball on a floor if there are only a top face and vertical faces.
class Footing {
public:
    /// Not simple if the ball touches anything else, or nothing.
    static Footing of(const Contacts &contacts, double tolerance);

    /// Whether rest can be determined this way: no wall that may hold the ball has friction.
    bool isEasy(const phys_params &params) const {
        const bool isRough = params.model == PHYS_MODEL_RIGID && params.wall_friction > 0.0;
        return m_hasFloor && !(m_hasWalls && isRough);
    }

    /// Whether a ball at rest stays at rest, model.md 6.3: walls balance what presses on them, and resistance holds the
    /// remainder up to its limit, including the limit.
    bool holds(const phys_params &params) const {
        if (params.gravity.z > 0.0) return false;
        Law<Vec2> law = rollingLaw(params);
        if (params.model == PHYS_MODEL_RIGID && params.sliding_friction == 0.0) law.B = 0.0;
        if (!m_isFree[law.A.x > 0.0 ? 1 : 0]) law.A.x = 0.0;
        if (!m_isFree[law.A.y > 0.0 ? 3 : 2]) law.A.y = 0.0;
        return glm::dot(law.A, law.A) <= law.B * law.B;
    }

private:
    bool m_hasFloor = false;
    bool m_hasWalls = false;
    std::array<bool, 4> m_isFree{true, true, true, true}; ///< to -x, +x, -y, +y
};

} // namespace phys
