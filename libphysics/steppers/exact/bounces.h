// SPDX-License-Identifier: MIT
// Many bounces at once: model.md 6.4.
#pragma once

#include "exact/ground.h"
#include "exact/touching.h"

namespace phys {

/// Bounces on one face that surely meet nothing else need no search, and where each is like the one before no flight of
/// their own. What is touched after them is resolved.
void skipBounces(const Ground &ground, MovingBall &ball, Touching &touching);

} // namespace phys
