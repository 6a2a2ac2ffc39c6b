// SPDX-License-Identifier: MIT
// Shared by the cases: their ball, what they draw, and ways to state the expectation for each stepper.
#pragma once

#include "support/random.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <cmath>
#include <functional>

namespace extremes {

inline constexpr double kRadius = 0.0625; // m, of most cases

/// A step size, s.
inline double drawDt(support::Random &draw) { return draw.between(0x1p-9, 0x1p-6); }

inline double drawSign(support::Random &draw) { return draw.below(2) ? 1.0 : -1.0; }

inline uint64_t stepsFor(double duration, double dt) { return static_cast<uint64_t>(std::ceil(duration / dt)); }

using Expected = std::function<QByteArray(const QByteArray &stepper, uint32_t model)>;

inline Expected always(const QByteArray &text) {
    return [text](const QByteArray &, uint32_t) { return text; };
}

/// Distinguishes steppers of fixed substeps from those that find the impact inside the step.
inline Expected bySubsteps(const QByteArray &withSubsteps, const QByteArray &without) {
    return [=](const QByteArray &stepper, uint32_t) {
        return support::promiseOf(stepper).inSteps ? withSubsteps : without;
    };
}

} // namespace extremes
