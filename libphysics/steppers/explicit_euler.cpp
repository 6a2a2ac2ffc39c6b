// SPDX-License-Identifier: MIT
// The bad example: at a wall it gains energy in each step, and no correction helps (model.md 10.3).
#include "discrete/schemes.h"
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

constinit const phys_stepper_api kExplicitEuler = discreteStepper<ExplicitEuler>(
    "explicit-euler", "Explicit Euler", "19", "A bad example to compare with: first order, and restless in contact.");

} // namespace phys
