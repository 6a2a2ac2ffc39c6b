// SPDX-License-Identifier: MIT
// What happens to the ball in no time: impacts, and which contacts last then. model.md 8.1 and 13.2.
#pragma once

#include "exact/ground.h"
#include "exact/touching.h"

namespace phys {

/// Finds what the ball touches, takes all impacts of the moment, and looks at what lasts then.
void resolve(const Ground &ground, MovingBall &ball, Touching &touching);

/// One round of impacts with all contacts that the ball approaches: true if anything was hit. Takes the restitution
/// from those whose bounce is the last. negligible: m/s, speeds across contacts that are rounding.
bool collide(double negligible, MovingBall &ball, Touching &touching);

} // namespace phys
