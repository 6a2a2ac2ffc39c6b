// SPDX-License-Identifier: MIT
// The rigid model's motion on the floor: rolling, slipping, and slipping along a wall.
#pragma once

#include "law.h"
#include "surroundings.h"

namespace phys {

/// Whether the floor contact rolls: u = 0 within rounding, model.md 2.2 F2.
bool rolls(const Ball &ball, double radius);

/// Whether friction can keep the ball rolling on this slope: tan(tilt) <= 7/2 mu_s, model.md 2.2 F2.
bool gripHolds(const phys_params &params);

/// Acceleration of the centre while the contact slips: g_t - mu_s gn hat(u), model.md 2.2 F1.
Vec2 slippingDrive(const Ball &ball, const phys_params &params, double radius);

/// A substep of a ball that leans on walls and slips on the floor or rubs on the wall: all contacts answer with
/// impulses in turn, which is first order in h whatever the stepper (model.md 6.5). Returns the displacement.
Vec2 slideAlongWalls(const StepContext &context, const Pressing &pressing, Ball &ball);

} // namespace phys
