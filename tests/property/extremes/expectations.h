// SPDX-License-Identifier: MIT
// What the cases have in common: their ball, their step, and ways to say what is expected of which stepper.
#pragma once

#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <functional>

namespace extremes {

inline constexpr double kRadius = 0.0625; // m, of most cases
inline constexpr double kDt = 0x1p-7;     // s

using Expected = std::function<QByteArray(const QByteArray &stepper, uint32_t model)>;

inline Expected always(const QByteArray &text) {
    return [text](const QByteArray &, uint32_t) { return text; };
}

/// Steppers of fixed substeps against those that find the impact inside the step.
inline Expected bySubsteps(const QByteArray &withSubsteps, const QByteArray &without) {
    return [=](const QByteArray &stepper, uint32_t) {
        return support::promiseOf(stepper).inSteps ? withSubsteps : without;
    };
}

} // namespace extremes
