// SPDX-License-Identifier: MIT
// Moves the ball along a phase, and makes exact what holds at its end: model.md 8.1.
#pragma once

#include "exact/first_event.h"

namespace phys {

/// Turns the normals of edges and corners according to the ball's motion round them.
void follow(const Choice &choice, const Event &event, MovingBall &ball, Touching &touching);

} // namespace phys
