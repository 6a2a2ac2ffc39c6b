// SPDX-License-Identifier: MIT
// The schemes of the steppers of fixed substeps, and of `swept`: model.md 10.1.
#pragma once

#include "floor_contact.h"

namespace phys {

/// The position moves with the old velocity.
struct ExplicitEuler {
    static constexpr ContactRule kContactRule = ContactRule::Explicit;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &velocity, double h) {
        return {eulerVelocity(law, velocity, h), h * velocity};
    }
};

/// First the velocity, then the position with the new velocity.
struct SymplecticEuler {
    static constexpr ContactRule kContactRule = ContactRule::Symplectic;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &velocity, double h) {
        const V next = eulerVelocity(law, velocity, h);
        return {next, h * next};
    }
};

/// The second force is evaluated at the predicted velocity, because otherwise the order falls to one with resistance.
struct VelocityVerlet {
    static constexpr ContactRule kContactRule = ContactRule::SecondOrder;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &velocity, double h) {
        if (nearStop(law, velocity, h)) return stopping(law, velocity, h);
        const V a = acceleration(law, velocity);
        const V aNext = acceleration(law, velocity + h * a);
        return {velocity + 0.5 * h * (a + aNext), h * velocity + 0.5 * h * h * a};
    }
};

/// The classical Runge-Kutta formula; positions come from the same four velocities.
struct RungeKutta4 {
    static constexpr ContactRule kContactRule = ContactRule::SecondOrder;

    template<class Law, class V>
    static Advance<V> advance(const Law &law, const V &v1, double h) {
        if (nearStop(law, v1, h)) return stopping(law, v1, h);
        const V a1 = acceleration(law, v1);
        const V v2 = v1 + 0.5 * h * a1;
        const V a2 = acceleration(law, v2);
        const V v3 = v1 + 0.5 * h * a2;
        const V a3 = acceleration(law, v3);
        const V v4 = v1 + h * a3;
        const V a4 = acceleration(law, v4);
        return {v1 + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4), h / 6.0 * (v1 + 2.0 * (v2 + v3) + v4)};
    }
};

} // namespace phys
