// SPDX-License-Identifier: MIT
// What a stepper of fixed substeps keeps of its scene between steps: what it looked up last. All of it follows from the
// scene alone, so that no answer depends on what is kept.
#pragma once

#include "footing.h"
#include "requirements.h"
#include "shared/floor_region.h"

#include <cstring>

namespace phys {

class KnownPlaces {
public:
    explicit KnownPlaces(const Scene &scene)
        : m_footing(scene)
        , m_regions(scene) {}

    const Scene &scene() const { return m_footing.scene(); }
    LastFooting &footing() { return m_footing; }
    FloorRegions &regions() { return m_regions; }

private:
    LastFooting m_footing;
    FloorRegions m_regions;
};

/// The cheapest step: a ball that stands still stays where it is, as the full step would find too. False, with `out`
/// untouched, if the ball moves or may begin to.
inline bool stay(const PlanInput &input, LastFooting &footing, phys_state &out) {
    if (input.params.options != 0 || input.params.stepper[0] != 0.0) return false;
    const phys_state &in = input.state;
    const bool isStill = in.velocity.x == 0.0 && in.velocity.y == 0.0 && in.velocity.z == 0.0 && in.spin.x == 0.0 &&
                         in.spin.y == 0.0 && in.spin.z == 0.0;
    if (!isStill) return false;
    const uint64_t held = in.flags & PHYS_AT_REST ? footing.flagsOfHeld(input.params, in.position) : 0;
    if (!held && !footing.holds(input.params, in.position)) return false;
    const phys_box &bounds = input.scene.bounds;
    const bool isInside = in.position.x >= bounds.min.x && in.position.x <= bounds.max.x &&
                          in.position.y >= bounds.min.y && in.position.y <= bounds.max.y;
    if (&out != &in) {
        out.position = in.position;
        std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    }
    out.velocity = out.spin = {0.0, 0.0, 0.0};
    out.flags = held ? held : isInside ? PHYS_AT_REST : PHYS_AT_REST | PHYS_OUT;
    return true;
}

} // namespace phys
