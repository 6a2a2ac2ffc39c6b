// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps keeps of its scene between steps: what it looked up last. All of it follows from the
// scene alone, so that no answer depends on what is kept.
#pragma once

#include "footing.h"
#include "requirements.h"
#include "shared/floor_region.h"
#include "shared/resting_place.h"

namespace phys {

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_footing(scene)
        , m_regions(scene) {}

    const Scene &scene() const { return m_footing.scene(); }
    LastFooting &footing() { return m_footing; }
    FloorRegions &regions() { return m_regions; }
    RestingPlace &resting() { return m_resting; }

private:
    LastFooting m_footing;
    FloorRegions m_regions;
    RestingPlace m_resting;
};

/// The cheapest step: a ball that stands still stays where it is, as the full step would find too. False, with `out`
/// untouched, if the ball moves or may begin to.
inline bool stay(const PlanInput &input, KnownPlaces &places, phys_state &out) {
    if (input.params.options != 0 || input.params.stepper[0] != 0.0) return false;
    const phys_state &in = input.state;
    if (!standsStill(in)) return false;
    uint64_t flags = places.resting().flagsOf(input.params, in);
    if (!flags) {
        if (!places.footing().holds(input.params, in.position)) return false;
        const phys_box &bounds = input.scene.bounds;
        const bool isInside = in.position.x >= bounds.min.x && in.position.x <= bounds.max.x &&
                              in.position.y >= bounds.min.y && in.position.y <= bounds.max.y;
        flags = isInside ? PHYS_AT_REST : PHYS_AT_REST | PHYS_OUT;
    }
    leaveResting(in, flags, out);
    out.velocity = out.spin = {0.0, 0.0, 0.0};
    return true;
}

} // namespace phys
