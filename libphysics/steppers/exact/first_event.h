// SPDX-License-Identifier: MIT
// What ends a phase: itself, a border of its features, a box on the way, or the step. model.md 8.1.
#pragma once

#include "exact/choose.h"
#include "exact/ground.h"
#include "exact/search.h"

namespace phys {

struct Event {
    End end;
    Border border; ///< if that is its cause
};

/// Adds to the work of the ball's step, and leaves all else as it is.
Event firstEvent(const Ground &ground, const Touching &touching, const Choice &choice, MovingBall &ball);

} // namespace phys
