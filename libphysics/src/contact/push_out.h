// SPDX-License-Identifier: MIT
// Pushes the ball out of overlapping boxes: model.md 5.7.
#pragma once

#include "contact/work.h"
#include "scene/scene.h"

namespace phys {

struct PushOut {
    bool isFree;     ///< whether the ball overlaps nothing afterwards
    uint32_t passes; ///< 0: it overlapped nothing before
    double depth;    ///< largest overlap during the passes
};

/// Moves a ball that overlaps boxes out of them, in passes, to the nearest place that their faces and edges allow. A
/// ball whose centre is inside a box moves along an axis to the nearest place with room. Between walls closer than the
/// ball's diameter there is no room, except for arbitrary places to which nearly opposite faces push it: then the
/// position is unchanged, and also if the work limit is exceeded.
PushOut pushOut(const Scene &scene, Vec3 &position, Work &work);

} // namespace phys
