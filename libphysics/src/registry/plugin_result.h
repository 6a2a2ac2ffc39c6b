// SPDX-License-Identifier: MIT
// What a plugin is asked for, and the checks of what it hands back. It gets copies of its inputs.
#pragma once

#include "registry/stepper.h"

namespace phys {

/// in: with its own time and step; next: filled as plugin.h promises.
phys_status stepPlugin(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &next, phys_report *report, phys_error *err);

/// out: undefined on failure.
phys_status requirementsOfPlugin(const phys_stepper &stepper, const phys_params &params, double dt,
                                 const phys_state &state, phys_requirements &out, phys_error *err);

} // namespace phys
