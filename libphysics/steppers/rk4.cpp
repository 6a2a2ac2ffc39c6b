// SPDX-License-Identifier: MIT
// Fourth order where the motion is smooth, but no better than the others across impacts, which it is here to show.
#include "discrete/stepper.h"
#include "registry/built_in_steppers.h"

namespace phys {

namespace {

/// model.md 10.1: the classical Runge-Kutta formula; positions come from the same four velocities.
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

} // namespace

constinit const phys_stepper_api kRk4 = discreteStepper<RungeKutta4>(
    "rk4", "Runge-Kutta 4", "9", "Fourth order between impacts, first across them: order alone buys nothing there.");

} // namespace phys
