// SPDX-License-Identifier: MIT
// The boxes that a ball may touch from a position.
#pragma once

#include "scene/scene.h"

namespace phys {

/// Calls visit(box, number) for the boxes within `reach` (m) of a centre, and possibly for others.
template<class Visit>
void visitNear(const Scene &scene, const Vec3 &position, double reach, Visit visit) {
    if (reach > kCandidateReach * scene.radius && scene.hasManyBoxes) {
        scene.visitBoxes(position - reach, position + reach, [&](uint32_t i) { visit(scene.boxes[i], i); });
        return;
    }
    for (const uint32_t i : scene.boxesNear(position.x, position.y, scene.hasManyBoxes)) visit(scene.boxes[i], i);
}

} // namespace phys
