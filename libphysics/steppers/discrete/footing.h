// SPDX-License-Identifier: MIT
// What holds a ball that stands still at a place, where that is easy to tell.
#pragma once

#include "contact/contact.h"
#include "floor_contact.h"

#include <cmath>

namespace phys {

/// What a ball on a floor touches at a place where that is all: a top face and upright faces.
class Footing {
public:
    /// Not easy if the ball touches anything else, or nothing.
    static Footing of(const Contacts &contacts, double tolerance);

    /// Whether rest is this easy to tell: no friction at a wall that may hold the ball too.
    bool isEasy(const phys_params &params) const {
        const bool isRough = params.model == PHYS_MODEL_RIGID && params.wall_friction > 0.0;
        return m_hasFloor && !(m_hasWalls && isRough);
    }

    /// Whether a ball that stands still stays so, model.md 6.3: walls take what presses on them, resistance holds the
    /// rest up to its limit, the limit included.
    bool holds(const phys_params &params) const {
        if (!(params.gravity.z < 0.0)) return false;
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
