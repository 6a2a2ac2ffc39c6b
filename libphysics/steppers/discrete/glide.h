// SPDX-License-Identifier: MIT
// The step that most steps are: the scene requires nothing but the smooth law.
#pragma once

#include "clearing.h"
#include "discrete.h"

#include <cstring>

namespace phys {

/// The cheapest step: a ball that stands still stays where it is, as the full step would find too. False, with `out`
/// untouched, if the ball moves or may begin to.
[[gnu::always_inline]] inline bool stay(const PlanInput &input, Clearing &clearing, phys_state &out) {
    if (input.params.options != 0 || input.params.stepper[0] != 0.0) return false;
    const phys_state &in = input.state;
    const bool isStill = in.velocity.x == 0.0 && in.velocity.y == 0.0 && in.velocity.z == 0.0 && in.spin.x == 0.0 &&
                         in.spin.y == 0.0 && in.spin.z == 0.0;
    if (!isStill || !clearing.footing().holds(input.params, in.position)) return false;
    const phys_box &bounds = input.scene.bounds;
    const bool isInside = in.position.x >= bounds.min.x && in.position.x <= bounds.max.x &&
                          in.position.y >= bounds.min.y && in.position.y <= bounds.max.y;
    if (&out != &in) {
        out.position = in.position;
        std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    }
    storeVector(0.0, 0.0, 0.0, &out.velocity.x);
    storeVector(0.0, 0.0, 0.0, &out.spin.x);
    out.flags = isInside ? PHYS_AT_REST : PHYS_AT_REST | PHYS_OUT;
    return true;
}

/// Whether the step may be one free roll, slide or slip on the floor: one substep, no option.
inline bool mayGlide(const PlanInput &input) { return input.params.options == 0 && isSlow(input) && !spinsFast(input); }

/// Ends a step that nothing interfered with. False, with `out` untouched, if something might have: a box near the way,
/// or a ball that stays at rest or comes to rest, which needs to be told why. kRoom: how many lengths of the way must
/// be clear around it.
template<int kRoom>
[[gnu::always_inline]] inline bool endGlide(const PlanInput &input, const Clearing &clearing, const Advance<Vec2> &next,
                                            const Vec3 &spin, phys_state &out) {
    const phys_state &in = input.state;
    const Vec2 from = inPlane(in.position);
    const Vec2 to = from + next.displacement;
    // A step of constant acceleration stays in the triangle of its ends and this corner.
    const Vec2 corner = from + 0.5 * input.dt * inPlane(in.velocity);
    Vec2 low = glm::min(corner, glm::min(from, to));
    Vec2 high = glm::max(corner, glm::max(from, to));
    if constexpr (kRoom > 0) {
        const double room = kRoom * (std::abs(next.displacement.x) + std::abs(next.displacement.y));
        low -= room;
        high += room;
    }
    if (!clearing.holds(low, high) || next.velocity == Vec2(0.0)) return false;

    if (&out != &in) std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    const bool slips = isSlipping(input.params, input.scene.radius, next.velocity, spin);
    storeVector(to.x, to.y, in.position.z, &out.position.x);
    storeVector(next.velocity.x, next.velocity.y, 0.0, &out.velocity.x);
    storeVector(spin.x, spin.y, spin.z, &out.spin.x);
    out.flags = slips ? PHYS_SLIPPING : 0;
    return true;
}

/// The step that most steps are: rolls or slides freely on the floor, bit by bit as the full step would. False, with
/// `out` untouched, if the step needs any more than that. Calls nothing, so that nothing needs to be saved for it.
template<class Scheme, int kRoom = 0>
[[gnu::always_inline]] inline bool glide(const PlanInput &input, const Clearing &clearing, phys_state &out) {
    if (!mayGlide(input)) return false;
    const FloorContact contact = input.contact();
    if (contact == FloorContact::Slips) return false;
    const Vec2 velocity = inPlane(input.state.velocity);
    const Advance<Vec2> next = Scheme::advance(velocityLaw(contact, input.params), velocity, input.dt);
    const Vec3 spinBefore = input.params.model == PHYS_MODEL_RIGID ? toVec(input.state.spin) : Vec3(0.0);
    return endGlide<kRoom>(input, clearing, next, spinAfter(contact, next.velocity, spinBefore, input.scene.radius),
                           out);
}

/// The same for a ball that slips.
template<class Scheme, int kRoom>
bool glideSlipping(const PlanInput &input, const Clearing &clearing, phys_state &out) {
    if (!mayGlide(input) || input.contact() != FloorContact::Slips) return false;
    Vec3 spin = toVec(input.state.spin);
    const Advance<Vec2> next =
        slip<Scheme>(input.params, input.scene.radius, input.dt, inPlane(input.state.velocity), spin, nullptr);
    return endGlide<kRoom>(input, clearing, next, spin, out);
}

/// What is left to try where `glide` failed: find a clearing around the ball, and slip through it.
template<class Scheme, int kRoom = 0>
[[gnu::noinline]] bool glideElsewhere(const PlanInput &input, Clearing &clearing, phys_state &out) {
    return mayGlide(input) && clearing.findAround(inPlane(input.state.position)) &&
           (glideSlipping<Scheme, kRoom>(input, clearing, out) || glide<Scheme, kRoom>(input, clearing, out));
}

} // namespace phys
