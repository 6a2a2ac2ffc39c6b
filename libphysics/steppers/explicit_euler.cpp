// SPDX-License-Identifier: MIT
// The bad example: at a wall it gains energy in each step, and no correction helps (model.md 10.3).
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

namespace {

/// model.md 10.1: the position moves with the old velocity.
struct ExplicitEuler {
    static constexpr ContactRule kContactRule = ContactRule::Explicit;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &velocity, double h) {
        return {eulerVelocity(law, velocity, h), h * velocity};
    }
};

} // namespace

constinit const phys_stepper_api kExplicitEuler = discreteStepper<ExplicitEuler>(
    "explicit-euler", "Explicit Euler", "9", "A bad example to compare with: first order, and restless in contact.");

} // namespace phys
