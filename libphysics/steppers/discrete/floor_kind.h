// SPDX-License-Identifier: MIT
// How a ball moves on the floor, for steps in regions.
#pragma once

#include <physics/physics.h>

namespace phys {

/// It follows from the parameters.
struct FloorKind {
    bool isRigid = false, slides = false;

    FloorKind() = default;
    explicit FloorKind(const phys_params &params)
        : isRigid(params.model == PHYS_MODEL_RIGID)
        , slides(isRigid && params.sliding_friction == 0.0) {}

    bool mayLean(const phys_params &params) const { return !isRigid || params.wall_friction == 0.0; }
    double share() const { return slides ? 1.0 : 5.0 / 7.0; }
    double friction(const phys_params &params) const { return isRigid ? params.sliding_friction : 0.0; }
    /// gripHolds, with one rounding step of margin.
    double grip(const phys_params &params) const {
        const double steepest = 3.5 * params.sliding_friction;
        return isRigid && !slides ? steepest * steepest * (1.0 - 1e-9) : 0x1p400;
    }
};

} // namespace phys
