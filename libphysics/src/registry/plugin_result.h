// SPDX-License-Identifier: MIT
// One step by a plugin, and the checks of its result.
#pragma once

#include "registry/stepper.h"

namespace phys {

/// in: with its own time and step; next: filled as plugin.h promises.
phys_status stepPlugin(const phys_stepper &stepper, const phys_params &params, double dt, const phys_state &in,
                       phys_state &next, phys_report *report, phys_error *err);

} // namespace phys
