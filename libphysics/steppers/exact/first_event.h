// SPDX-License-Identifier: MIT
// What ends a phase: the phase itself, a border of its features, a box in its path, or the step. model.md 8.1.
#pragma once

#include "exact/choose.h"
#include "exact/ground.h"
#include "exact/search.h"

namespace phys {

struct Event {
    End end;
    Border border; ///< valid if that is the cause
};

/// Counts its work in the ball's step and changes nothing else.
Event firstEvent(const Ground &ground, const Touching &touching, const Choice &choice, MovingBall &ball);

} // namespace phys
