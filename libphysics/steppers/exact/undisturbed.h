// SPDX-License-Identifier: MIT
// The most frequent kind of step: a ball rolls on a floor, possibly along a smooth wall, and meets nothing. model.md
// 8.1.
#pragma once

#include "registry/report.h"
#include "shared/floor_region.h"

namespace phys {

/// Makes a step of dt of this kind, with the bits of followEvents: sets all of `out`, which isn't `in`, except the time
/// and the step number. If the kind isn't certain, returns false and writes nothing.
bool rollUndisturbed(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                     const phys_state &in, phys_state &out, phys_report *report);

} // namespace phys
