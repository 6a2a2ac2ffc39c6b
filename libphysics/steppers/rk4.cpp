// SPDX-License-Identifier: MIT
// Fourth order where the motion is smooth, but no better than the others across impacts, which it is here to show.
#include "discrete/schemes.h"
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

constinit const phys_stepper_api kRk4 = discreteStepper<RungeKutta4>(
    "rk4", "Runge-Kutta 4", "19", "Fourth order between impacts, first across them: order alone buys nothing there.");

} // namespace phys
