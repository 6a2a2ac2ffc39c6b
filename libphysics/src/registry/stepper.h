// SPDX-License-Identifier: MIT
// A stepper in its scene, and one step whose arguments were checked.
#pragma once

#include "registry/lanes.h"
#include "scene/scene.h"

#include <physics/plugin.h>

struct phys_stepper {
    const phys_stepper_api *api;
    void *self;
    const phys::Scene *scene;
    phys_scene_view view;
    bool isPlugin;
    const phys::LaneSteps *lanes; ///< its ability to move balls in lanes, or nullptr
};

namespace phys {

/// Time and step of a state after so many more steps of dt.
void advanceClock(double dt, uint64_t steps, phys_state &state);

/// As phys_step with checked arguments: `out` may be `in`, and is written on success only. report: a fresh one, or
/// nullptr.
phys_status makeStep(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                     phys_state &out, phys_report *report, phys_error *err);

/// One step of dt > 0 from `in` to `next`, which are not the same; `next` means something only after PHYS_OK. A plugin
/// is not trusted: neither what it returns nor what it writes goes on unchecked.
phys_status advance(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                    phys_state &next, phys_report *report, phys_error *err);

} // namespace phys
