// SPDX-License-Identifier: MIT
// Many bounces at once: model.md 6.4.
#pragma once

#include "exact/ground.h"
#include "exact/touching.h"

namespace phys {

/// Makes bounces on one face that certainly meet nothing else without a search, and similar bounces without computing
/// each flight. Contacts after them must be resolved.
void skipBounces(const Ground &ground, MovingBall &ball, Touching &touching);

} // namespace phys
