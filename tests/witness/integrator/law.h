// SPDX-License-Identifier: MIT
// What the law of contact says of one moment: coefficients, and impacts of all contacts together.
#pragma once

#include "touch.h"

#include <vector>

namespace witness {

/// Everything a ball is that its motion depends on.
struct Motion {
    Vector place;
    Vector velocity;
    Vector spin;
};

/// What the law reads of the parameters.
struct Law {
    bool isRigid;
    Real radius;
    Vector gravity;
    Real restitutionFloor, restitutionWall;
    Real slidingFriction, wallFriction, rollingFriction;

    Real restitution(const Touch &touch) const { return touch.isTop ? restitutionFloor : restitutionWall; }
    /// In the rolling model no feature has friction but the top faces that the ball rolls on, which hold without limit.
    Real friction(const Touch &touch) const {
        if (!isRigid) return 0;
        return touch.isTop ? slidingFriction : wallFriction;
    }
    /// Speeds of approach below this are none.
    Real noSpeed(const Motion &motion) const;
};

Law lawOf(const phys_params &params, Real radius);

/// The velocity of the ball's surface where it touches.
Vector slipAt(const Motion &motion, const Vector &normal, Real radius);

/// Below this speed a bounce is lower than lengths that count as none, if gravity presses the ball back.
Real closingSpeed(const Law &law, const Touch &touch, Real lengthTolerance);

/// Impacts of all contacts of a moment together. Whether there was one.
bool collide(const Law &law, const std::vector<Touch> &touches, Real lengthTolerance, Motion &motion);

} // namespace witness
