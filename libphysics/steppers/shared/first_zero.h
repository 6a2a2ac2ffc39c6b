// SPDX-License-Identifier: MIT
// The first zero of a function of time whose value, rate and lower curvature bound are known: no zero is missed.
// model.md 5.2.
#pragma once

#include "shared/closed_form.h"

namespace phys {

/// A function at one time, with a bound until the end of the interval: f(t + s) >= value + rate s + least s^2/2.
struct Look {
    double value, rate, least;
};

/// Any function look(t, end) that returns a Look whose bound holds until `end`; it must outlive this.
class Looks {
public:
    template<class Function>
    Looks(const Function &function) // NOLINT(google-explicit-constructor)
        : m_function(&function)
        , m_look(
              [](const void *self, double t, double end) { return (*static_cast<const Function *>(self))(t, end); }) {}

    Look operator()(double t, double end) const { return m_look(m_function, t, end); }

private:
    const void *m_function;
    Look (*m_look)(const void *, double, double);
};

inline double fewDigits(double t) { return static_cast<double>(static_cast<float>(t)); }

/// First time in [from, until] at which f falls through zero; kNever if there is none. A value of at most `zero` that
/// falls counts as a zero. Steps are as long as the bound allows; near a zero they become Newton's.
double firstZero(const Looks &look, double from, double until, double zero);

/// When something begins to hold in [0, until], which is looked for at the ends of as many equal intervals and found by
/// halving one; kNever if it doesn't.
template<class Holds>
double firstHolding(const Holds &holds, double until, int looks, int halvings) {
    for (int i = 1; i <= looks; ++i) {
        double low = until * (i - 1) / looks, high = until * i / looks;
        if (!holds(high)) continue;
        for (int halving = 0; halving < halvings; ++halving) {
            const double middle = 0.5 * (low + high);
            (holds(middle) ? high : low) = middle;
        }
        return high;
    }
    return kNever;
}

} // namespace phys
