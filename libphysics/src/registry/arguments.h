// SPDX-License-Identifier: MIT
// What a step takes: parameters, step size and state, and what must hold of them.
#pragma once

#include "scene/scene.h"

#include <physics/plugin.h>

namespace phys {

/// Whether a ball can have this state: moderate numbers, a unit quaternion, known flags.
bool stateIsValid(const phys_state &state);

/// Says why it isn't. whose: how the message begins, "the given state".
phys_status explainState(const phys_state &state, phys_status status, const char *whose, phys_error *err);

phys_status checkDt(double dt, phys_error *err);

/// Against the library's rows and the stepper's own.
phys_status checkParams(const phys_stepper_api &api, const phys_params &params, phys_error *err);

phys_status checkState(const phys_state &state, phys_error *err);

phys_status checkUpwardPull(const Scene &scene, const phys_params &params, const phys_state &state, phys_error *err);

/// Only a ball that no floor carries may be pulled upwards. The state is valid.
inline phys_status checkPull(const Scene &scene, const phys_params &params, const phys_state &state, phys_error *err) {
    return params.gravity.z < 0.0 ? PHYS_OK : checkUpwardPull(scene, params, state, err);
}

} // namespace phys
