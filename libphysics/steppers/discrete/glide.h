// SPDX-License-Identifier: MIT
// The step that most steps are: the scene requires nothing but the smooth law.
#pragma once

#include "discrete.h"

#include <cstring>

namespace phys {

/// Rolls freely on the floor for one step: no box within reach before or after, one substep, no option, no report.
/// False, with `out` untouched, if the step needs any more than that; it computes what the full step would, bit by bit.
template<class Scheme>
inline bool glide(const PlanInput &input, phys_state &out) {
    const Scene &scene = input.scene;
    const phys_state &in = input.state;
    const Vec2 from = inPlane(in.position);
    const Vec2 velocity = inPlane(in.velocity);
    if (input.params.options != 0 || !isSlow(input)) return false;

    Vec3 spin = input.params.model == PHYS_MODEL_RIGID ? toVec(in.spin) : Vec3(0.0);
    const FloorContact contact = floorContact(input.params, scene.radius, velocity, spin);
    const bool slips = contact == FloorContact::Slips;
    const Advance<Vec2> next = slips ? slip<Scheme>(input.params, scene.radius, input.dt, velocity, spin, nullptr)
                                     : Scheme::advance(velocityLaw(contact, input.params), velocity, input.dt);
    if (!slips) spin = spinAfter(contact, next.velocity, spin, scene.radius);
    const Vec2 to = from + next.displacement;
    // What the full step takes for touched counts too: twice the tolerance, model.md 5.2.
    const double reach = scene.radius + 2.0 * scene.tolerance + std::abs(to.x - from.x) + std::abs(to.y - from.y);
    // Seen from above a box is never further away than it is: what lies over or under the ball only costs a full step.
    for (const uint32_t solid : scene.solidsNear(from.x, from.y, scene.needsGrid)) {
        if (squaredDistanceFromAbove(scene.solids[solid], from) <= reach * reach) return false;
    }
    // A ball that stays at rest or comes to rest needs to be told why.
    if (reach > kCandidateReach * scene.radius || next.velocity == Vec2(0.0) || !scene.bothOverFloor(from, to)) {
        return false;
    }

    if (&out != &in) std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    out.position = {to.x, to.y, in.position.z};
    out.velocity = {next.velocity.x, next.velocity.y, 0.0};
    out.spin = fromVec(spin);
    out.flags = isSlipping(input.params, scene.radius, next.velocity, spin) ? PHYS_SLIPPING : 0;
    return true;
}

} // namespace phys
