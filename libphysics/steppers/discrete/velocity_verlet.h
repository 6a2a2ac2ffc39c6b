// SPDX-License-Identifier: MIT
// The scheme of the steppers `velocity-verlet` and `swept`.
#pragma once

#include "discrete.h"

namespace phys {

/// model.md 10.1; the second force is evaluated at the predicted velocity, because otherwise the order falls to one
/// with resistance.
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

} // namespace phys
