// SPDX-License-Identifier: MIT
// The time of a state.
#pragma once

#include "scene/scene.h"

#include <physics/physics.h>

#include <cmath>
#include <cstdint>

namespace phys {

/// Integers up to here are representable as doubles.
inline constexpr uint64_t kCountedSteps = uint64_t{1} << 53;

/// No step up to this one (s) leads from an allowed time beyond 2^100: a sum is rounded to 2^100 at most, and a product
/// is below 2^63 times dt.
inline constexpr double kLongestHarmlessStep = 0x1p36;

inline double stepsOf(const phys_state &state) { return static_cast<double>(static_cast<int64_t>(state.step)); }

/// Whether the time equals step count times dt (s). If so, steps are counted rather than times summed: model.md 10.6.
inline bool isCounted(const phys_state &state, double dt) {
    return std::abs(stepsOf(state) * dt - state.time) <= 4.0 * kRounding * state.time;
}

/// The time after a step of dt (s).
inline double nextTime(const phys_state &state, double dt) {
    return isCounted(state, dt) ? (stepsOf(state) + 1.0) * dt : state.time + dt;
}

} // namespace phys
