// SPDX-License-Identifier: MIT
// One step by a plugin, and what its result must be before anyone sees it.
#pragma once

#include "registry/stepper.h"

namespace phys {

/// in: with a time and a step of its own; next: filled as plugin.h promises.
phys_status stepPlugin(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &next, phys_report *report, phys_error *err);

} // namespace phys
