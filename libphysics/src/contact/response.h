// SPDX-License-Identifier: MIT
// What an impact or a friction impulse does to a ball: model.md 2.1 R2 and 2.2 F3.
#pragma once

#include "base/vec.h"

namespace phys {

/// The moving part of a state.
struct Ball {
    Vec3 position;
    Vec3 velocity;
    Vec3 spin;
    bool supported; ///< by a floor: its height is a constraint then, not a bounce in each step
};

/// Energy per mass that an impulse takes, J/kg.
struct Loss {
    double impact = 0.0;
    double slip = 0.0;
};

/// Rolling model: turns the normal velocity into `normalSpeedAfter` (m/s, >= 0). The spin of a supported ball follows
/// its velocity, so that it counts in the loss.
Loss reflect(Ball &ball, const Vec3 &normal, double normalSpeedAfter);

/// Rigid model: as reflect, with Coulomb friction at the contact point; spin and velocity change together.
Loss reflectWithFriction(Ball &ball, const Vec3 &normal, double normalSpeedAfter, double friction, double radius);

/// Friction of a contact that is pressed with `normalImpulse` (per mass, m/s): takes slip away, at most all of it.
/// Returns the energy lost to slip.
double applyFriction(Ball &ball, const Vec3 &normal, double normalImpulse, double friction, double radius);

} // namespace phys
