// SPDX-License-Identifier: MIT
// The first zero of a function of time whose value, rate and lower curvature bound are known: no zero is missed.
// model.md 5.2.
#pragma once

#include "shared/closed_form.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// A function at one time, with a bound until the end of the interval: f(t + s) >= value + rate s + least s^2/2.
struct Look {
    double value, rate, least;
};

/// A search that takes more evaluations is at a zero that it can't distinguish from rounding.
inline constexpr int kMostLooks = 2000;
/// After these, bounds are asked for shorter times, for which they are sharper.
inline constexpr int kFewLooks = 128;

inline double fewDigits(double t) { return static_cast<double>(static_cast<float>(t)); }

/// The zero, recomputed from a start of few digits, so that the path of the search leaves no trace in the last digits:
/// boards that are cut into other boxes give the same bits.
template<class Function>
double settled(const Function &look, double t, double until) {
    double s = fewDigits(t);
    for (int i = 0; i < 2; ++i) {
        const Look now = look(s, until);
        if (!(now.rate < 0.0)) return t;
        s -= now.value / now.rate;
    }
    return s >= 0.0 && s <= until && std::abs(s - t) <= 0x1p-40 * t ? s : t;
}

/// Time towards the zero from t on, where the value counts as zero already; step: the first one. Of a hop lower than
/// that, this is all the way down.
template<class Function>
double refined(const Function &look, double t, double step, double until, double zero) {
    constexpr int kMost = 24;
    for (int i = 0; i < kMost && step > 0x1p-20 * t && t + step < until; ++i) {
        const Look now = look(t + step, until);
        if (!(now.value <= zero && now.rate < 0.0)) break;
        t += step;
        step = firstFall(std::max(0.0, now.value), now.rate, now.least);
    }
    return t;
}

/// A longer step from t on, if the bounds for shorter times allow it; zero: a value that counts as zero already, so
/// that one of rounding that rises may fall by as much.
template<class Function>
double lengthened(const Function &look, double t, double step, double until, double zero) {
    for (double time = 4.0 * step; t + time < until; time *= 4.0) {
        const Look now = look(t, t + time);
        const double longer = firstFall(std::max(zero, now.value), now.rate, now.least);
        step = std::max(step, std::min(longer, time));
        if (longer < time) break;
    }
    return step;
}

/// First time in [from, until] at which f falls through zero; kNever if there is none. look(t, end) returns a Look
/// whose bound holds until then. A value of at most `zero` that falls counts as a zero. Steps are as long as the bound
/// allows; near a zero they become Newton's.
template<class Function>
double firstZero(const Function &look, double from, double until, double zero) {
    double t = from, least = 0x1p-44 * (until - from); // smallest step, for a zero value without rate
    bool isPolished = false;
    for (int i = 0; i < kMostLooks; ++i) {
        const Look now = look(t, until);
        const double step = firstFall(std::max(0.0, now.value), now.rate, now.least);
        if (now.value <= zero && now.rate < 0.0) {
            if (isPolished || t + step == t) return settled(look, refined(look, t, step, until, zero), until);
            isPolished = true;
            t = std::min(until, t + step);
            continue;
        }
        if (t + step > until || !(t < until)) return kNever;
        if (step <= least && (now.value <= zero || t + step == t)) {
            t = std::min(until, t + least);
            least *= 2.0;
        } else {
            t += i < kFewLooks ? step : lengthened(look, t, step, until, zero);
        }
    }
    return t;
}

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
