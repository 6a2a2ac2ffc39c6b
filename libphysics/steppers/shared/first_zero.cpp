// SPDX-License-Identifier: MIT
#include "shared/first_zero.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// A search that takes more evaluations is at a zero that it can't distinguish from rounding.
constexpr int kMostLooks = 2000;
/// After these, bounds are asked for shorter times, for which they are sharper.
constexpr int kFewLooks = 128;

/// The longest step that certainly leads past no zero, from a value of at least `least`.
double stepAfter(const Look &now, double least = 0.0) {
    return firstFall(std::max(least, now.value), now.rate, now.least);
}

/// The zero, recomputed from a start of few digits, so that the path of the search leaves no trace in the last digits:
/// boards that are cut into other boxes give the same bits.
double settled(const Looks &look, double t, double until) {
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
double refined(const Looks &look, double t, double step, double until, double zero) {
    constexpr int kMost = 24;
    for (int i = 0; i < kMost && step > 0x1p-20 * t && t + step < until; ++i) {
        const Look now = look(t + step, until);
        if (!(now.value <= zero && now.rate < 0.0)) break;
        t += step;
        step = stepAfter(now);
    }
    return t;
}

/// A longer step from t on, if the bounds for shorter times allow it; zero: a value that counts as zero already, so
/// that one of rounding that rises may fall by as much.
double lengthened(const Looks &look, double t, double step, double until, double zero) {
    for (double time = 4.0 * step; t + time < until; time *= 4.0) {
        const double longer = stepAfter(look(t, t + time), zero);
        step = std::max(step, std::min(longer, time));
        if (longer < time) break;
    }
    return step;
}

} // namespace

double firstZero(const Looks &look, double from, double until, double zero) {
    double t = from, least = 0x1p-44 * (until - from); // smallest step, for a zero value without rate
    bool isPolished = false;
    for (int i = 0; i < kMostLooks; ++i) {
        const Look now = look(t, until);
        const double step = stepAfter(now);
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

} // namespace phys
