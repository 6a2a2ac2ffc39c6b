// SPDX-License-Identifier: MIT
// The default: cheap, first order, and stable in contact, because the overshoot of its update never adds speed.
#include "discrete/schemes.h"
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

constinit const phys_stepper_api kSymplecticEuler = discreteStepper<SymplecticEuler>(
    "symplectic-euler", "Symplectic Euler", "19", "The default: the cheapest that is stable at rest; first order.");

} // namespace phys
