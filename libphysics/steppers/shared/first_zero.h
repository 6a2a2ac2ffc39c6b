// SPDX-License-Identifier: MIT
// The first zero of a function of time that is known by its value, its rate and a bound of its curvature: no zero is
// passed over. model.md 5.2.
#pragma once

#include "shared/closed_form.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// A function at a moment, and until the end of the time that is looked at: f(t + s) >= value + rate s + least s^2/2.
struct Look {
    double value, rate, least;
};

/// A search that takes more looks than this is at a zero that it can't tell from rounding.
inline constexpr int kMostLooks = 2000;

/// The same zero found from a start of few digits, so that the way on which the search came to it leaves no trace in
/// the last ones: boards that are cut into other boxes give the same bits.
template<class Function>
double settled(const Function &look, double t, double until) {
    double s = static_cast<double>(static_cast<float>(t));
    for (int i = 0; i < 2; ++i) {
        const Look now = look(s);
        if (!(now.rate < 0.0)) return t;
        s -= now.value / now.rate;
    }
    return s >= 0.0 && s <= until && std::abs(s - t) <= 0x1p-40 * t ? s : t;
}

/// First time in [from, until] at which f falls through zero; kNever if it doesn't. look(t) gives a Look. What is no
/// more than `zero` and falls counts as zero. Steps are as long as the bound allows; near a zero they become Newton's.
template<class Function>
double firstZero(const Function &look, double from, double until, double zero) {
    double t = from, least = 0x1p-44 * (until - from); // a step that gets on from a value of zero and no rate
    bool isPolished = false;
    for (int i = 0; i < kMostLooks; ++i) {
        const Look now = look(t);
        const double step = firstFall(std::max(0.0, now.value), now.rate, now.least);
        if (now.value <= zero && now.rate < 0.0) {
            if (isPolished || t + step == t) return settled(look, t, until);
            isPolished = true;
            t = std::min(until, t + step);
            continue;
        }
        if (t + step > until || !(t < until)) return kNever;
        if (step <= least && (now.value <= zero || t + step == t)) {
            t = std::min(until, t + least);
            least *= 2.0;
        } else {
            t += step;
        }
    }
    return t;
}

} // namespace phys
