// SPDX-License-Identifier: MIT
// The rigid model's motion along walls with friction at work.
#pragma once

#include "surroundings.h"

namespace phys {

/// Acceleration of the centre while the contact slips: g_t - mu_s gn hat(u), model.md 2.2 F1.
Vec2 slippingDrive(const Ball &ball, const phys_params &params, double radius);

/// A substep of a ball that leans on walls and slips on the floor or rubs on the wall: all contacts answer with
/// impulses in turn, which is first order in h whatever the stepper (model.md 6.5). Returns the displacement.
Vec2 slideAlongWalls(const StepContext &context, const Pressing &pressing, Ball &ball);

} // namespace phys
