// SPDX-License-Identifier: MIT
// Second order where the motion is smooth, at the cost of a second force evaluation.
#include "discrete/schemes.h"
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

constinit const phys_stepper_api kVelocityVerlet = discreteStepper<VelocityVerlet>(
    "velocity-verlet", "Velocity Verlet", "19",
    "Second order between impacts, first across them; for smooth accuracy at little cost.");

} // namespace phys
