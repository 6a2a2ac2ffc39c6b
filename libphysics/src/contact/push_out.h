// SPDX-License-Identifier: MIT
// Out of overlapping boxes: model.md 5.7.
#pragma once

#include "contact/work.h"
#include "scene/scene.h"

namespace phys {

struct PushOut {
    bool isFree;     ///< whether the ball overlaps nothing now
    uint32_t passes; ///< 0: it overlapped nothing before
    double depth;    ///< deepest overlap met on the way, m
};

/// Moves a ball that overlaps boxes out of them: to the nearest place that their faces and edges leave, in passes. One
/// whose centre is inside a box goes straight along an axis to the nearest place with room. Between walls that are
/// closer than the ball there is none, but for places that nearly opposite faces push it to, anywhere: then the
/// position stays. So it does once the work is too much.
PushOut pushOut(const Scene &scene, Vec3 &position, Work &work);

} // namespace phys
