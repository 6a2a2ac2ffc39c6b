// SPDX-License-Identifier: MIT
// One step of the exact stepper: from event to event until the end of the step, model.md 8.
#pragma once

#include "shared/floor_region.h"

#include <physics/physics.h>

namespace phys {

/// Sets all of `out` except the time and the step number.
phys_status stepExactly(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                        const phys_state &in, phys_state &out, phys_report *report, phys_error *err);

} // namespace phys
