// SPDX-License-Identifier: MIT
// The most frequent steps: a ball moves on a floor, possibly along a smooth wall, and bounces off smooth walls.
// model.md 8.1.
#pragma once

#include "exact/contact_events.h"
#include "exact/moving_ball.h"
#include "shared/floor_region.h"

namespace phys {

/// Moves the ball as long as it certainly meets nothing except the floor of a region and the smooth faces that bound
/// it, with the bits of the event loop, which continues from there if the step isn't finished. Returns whether it is.
bool runInRegion(FloorRegions &regions, MovingBall &ball, ContactEvents &events);

} // namespace phys
