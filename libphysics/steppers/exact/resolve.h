// SPDX-License-Identifier: MIT
// Instantaneous events: impacts, and which contacts last afterwards. model.md 8.1 and 13.2.
#pragma once

#include "exact/ground.h"
#include "exact/touching.h"

namespace phys {

/// Finds the contacts, applies all impacts of the moment, and determines which contacts last.
void resolve(const Ground &ground, MovingBall &ball, Touching &touching);

/// One round of impacts with all contacts that the ball approaches: true if there was an impact. Sets the restitution
/// of contacts whose bounce is the last to zero. negligible: m/s, speeds along normals that are rounding.
bool collide(double negligible, MovingBall &ball, Touching &touching);

} // namespace phys
