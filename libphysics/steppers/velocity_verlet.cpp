// SPDX-License-Identifier: MIT
// Second order where the motion is smooth, for a second evaluation of the force.
#include "discrete/stepper.h"
#include "steppers.h"

namespace phys {

namespace {

/// model.md 10.1; the second force is taken at the predicted velocity, or the order falls to one with resistance.
struct VelocityVerlet {
    static constexpr Bounce kBounce = Bounce::EnergyCorrect;

    template<class V>
    static Advance<V> advance(const Law<V> &law, const V &velocity, double h) {
        if (nearStop(law, velocity, h)) return advanceNearStop(law, velocity, h);
        const V a = acceleration(law, velocity);
        const V aNext = acceleration(law, velocity + h * a);
        return {velocity + 0.5 * h * (a + aNext), h * velocity + 0.5 * h * h * a};
    }
};

} // namespace

constinit const phys_stepper_api kVelocityVerlet = discreteStepper<VelocityVerlet>(
    "velocity-verlet", "Velocity Verlet", "1",
    "Second order between impacts, first across them; for smooth accuracy at little cost.");

} // namespace phys
