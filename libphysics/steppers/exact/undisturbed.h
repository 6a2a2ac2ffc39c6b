// SPDX-License-Identifier: MIT
// The step that most are: a ball rolls over a floor, or on it along a smooth wall, and meets nothing. model.md 8.1.
#pragma once

#include "registry/report.h"
#include "shared/floor_region.h"

namespace phys {

/// Makes a step of dt if it is such a one, with the bits of followEvents: all of `out`, which isn't `in`, but the time
/// and the number of the step. False, and nothing is written, where it isn't sure.
bool rollUndisturbed(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                     const phys_state &in, phys_state &out, phys_report *report);

} // namespace phys
