// SPDX-License-Identifier: MIT
// The time of a state.
#pragma once

#include "scene/scene.h"

#include <physics/physics.h>

#include <cmath>
#include <cstdint>

namespace phys {

/// The time after a step of dt (s). Steps are counted rather than times summed, as long as the time equals step count
/// times dt: model.md 10.6.
inline double nextTime(const phys_state &state, double dt) {
    const double steps = static_cast<double>(static_cast<int64_t>(state.step));
    const bool isCounted = std::abs(steps * dt - state.time) <= 4.0 * kRounding * state.time;
    return isCounted ? (steps + 1.0) * dt : state.time + dt;
}

} // namespace phys
