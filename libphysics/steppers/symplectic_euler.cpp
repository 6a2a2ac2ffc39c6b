// SPDX-License-Identifier: MIT
// The default: cheap, first order, and stable in contact, because the overshoot of its update never adds speed.
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

namespace {

/// model.md 10.1: first the velocity, then the position with the new velocity.
struct SymplecticEuler {
    static constexpr ContactRule kContactRule = ContactRule::Symplectic;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &velocity, double h) {
        const V next = eulerVelocity(law, velocity, h);
        return {next, h * next};
    }
};

} // namespace

constinit const phys_stepper_api kSymplecticEuler = discreteStepper<SymplecticEuler>(
    "symplectic-euler", "Symplectic Euler", "9", "The default: the cheapest that is stable at rest; first order.");

} // namespace phys
