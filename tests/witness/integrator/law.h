// SPDX-License-Identifier: MIT
// The law of contact at one moment: coefficients, and impacts of all contacts together.
#pragma once

#include "touch.h"

#include <vector>

namespace witness {

/// The ball's state, as far as its motion depends on it.
struct Motion {
    Vector place;
    Vector velocity;
    Vector spin;
};

/// The parameters that the law uses.
struct Law {
    bool isRigid;
    Real radius;
    Vector gravity;
    Real restitutionFloor, restitutionWall;
    Real slidingFriction, wallFriction, rollingFriction;

    Real restitution(const Touch &touch) const { return touch.isTop ? restitutionFloor : restitutionWall; }
    /// In the rolling model no feature has friction except the top faces on which the ball rolls, which hold without
    /// limit.
    Real friction(const Touch &touch) const {
        if (!isRigid) return 0;
        return touch.isTop ? slidingFriction : wallFriction;
    }
    /// Speeds of approach below this are none.
    Real noSpeed(const Motion &motion) const;
};

Law lawOf(const phys_params &params, Real radius);

/// The velocity of the ball's surface at the contact.
Vector slipAt(const Motion &motion, const Vector &normal, Real radius);

/// Below this speed a bounce is lower than the lengths that count as zero, if gravity presses the ball back.
Real closingSpeed(const Law &law, const Touch &touch, Real lengthTolerance);

/// Impacts of all contacts of a moment together. Returns whether there was one.
bool collide(const Law &law, const std::vector<Touch> &touches, Real lengthTolerance, Motion &motion);

} // namespace witness
