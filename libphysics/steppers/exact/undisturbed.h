// SPDX-License-Identifier: MIT
// The most frequent steps of all: a ball meets nothing but the floor on which it rolls or glides, and a smooth wall
// along it, or nothing at all. model.md 8.1.
#pragma once

#include "shared/floor_region.h"

#include <physics/physics.h>

namespace phys {

/// Makes a step of a ball on a floor, or of one that falls far from all boxes, with the bits of the event loop: all of
/// `out`, which may be `in`, except time and step number. False, and nothing is written, if anything else may happen.
bool moveUndisturbed(FloorRegions &regions, const Scene &scene, const phys_params &params, double dt,
                     const phys_state &in, phys_state &out);

} // namespace phys
