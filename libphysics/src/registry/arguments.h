// SPDX-License-Identifier: MIT
// The arguments of a step: parameters, step size and state, and their constraints.
#pragma once

#include "base/numbers.h"
#include "registry/params.h"
#include "scene/scene.h"

#include <physics/plugin.h>

#include <cmath>

namespace phys {

inline bool isUnit(const double (&q)[4]) {
    const double square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    return std::abs(square - 1.0) <= 1e-6; // false for NaN
}

/// Whether a ball can have this state: moderate numbers, a unit quaternion, known flags.
inline bool stateIsValid(const phys_state &state) {
    // Position, velocity, spin, and the first number of the orientation, are adjacent.
    static_assert(offsetof(phys_state, orientation) - offsetof(phys_state, position) == 9 * sizeof(double));
    return areModerate<10>(&state.position.x) && isModerate(state.time) && isUnit(state.orientation) &&
           (state.flags & ~static_cast<uint64_t>(PHYS_STATE_FLAGS)) == 0;
}

/// Explains why it is invalid. whose: how the message begins, "the given state".
phys_status explainState(const phys_state &state, phys_status status, const char *whose, phys_error *err);

phys_status refuseDt(double dt, phys_error *err);

// The checks are inlined, as each step makes them; the messages aren't.
inline phys_status checkDt(double dt, phys_error *err) {
    const bool isAllowed = dt >= 0.0 && dt <= kLargestNumber; // false for NaN
    return isAllowed ? PHYS_OK : refuseDt(dt, err);
}

/// Checks against the rows of the library and of the stepper.
inline phys_status checkParams(const phys_stepper_api &api, const phys_params &params, phys_error *err) {
    if (!paramsAreValid(params)) return explainParams(params, err);
    return checkOwnRows(params, {api.rows, api.row_count}, err);
}

inline phys_status checkState(const phys_state &state, phys_error *err) {
    return stateIsValid(state) ? PHYS_OK : explainState(state, PHYS_ERROR_STATE, "the given state", err);
}

phys_status checkUpwardPull(const Scene &scene, const phys_params &params, const phys_state &state, phys_error *err);

/// Gravity may pull upwards only if no floor carries the ball. The state must be valid.
inline phys_status checkPull(const Scene &scene, const phys_params &params, const phys_state &state, phys_error *err) {
    return params.gravity.z < 0.0 ? PHYS_OK : checkUpwardPull(scene, params, state, err);
}

} // namespace phys
