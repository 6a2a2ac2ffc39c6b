// SPDX-License-Identifier: MIT
// Balls on the floor side by side, in regions where nothing but rolling, leaning on walls and resting happens. What is
// here is what DiscreteStep::runOnFloor and glideOnFloor do there, and LastFooting at rest.
#pragma once

#include "base/orientation.h"
#include "base/pair.h"
#include "floor_contact.h"
#include "floor_region.h"
#include "known_places.h"
#include "registry/lanes.h"
#include "registry/params.h"
#include "registry/report.h"
#include "requirements.h"

#include <cmath>
#include <cstring>

namespace phys {

/// The law of balls that no resistance stops within the substep; nor do they stand still if there is any.
template<class N, bool kResists>
struct UnstoppedLaw {
    Planar<N> A; ///< constant acceleration, m/s^2
    N B;         ///< constant resistance against the motion, m/s^2
};

template<class N, bool kResists>
bool nearStop(const UnstoppedLaw<N, kResists> &, const Planar<N> &, double) {
    return false;
}
template<class N, bool kResists>
Planar<N> acceleration(const UnstoppedLaw<N, kResists> &law, const Planar<N> &v) {
    if constexpr (kResists) return law.A - law.B / length(v) * v;
    return law.A;
}
template<class N, bool kResists>
Planar<N> clampedVelocity(const UnstoppedLaw<N, kResists> &law, const Planar<N> &v, double dt) {
    return v + dt * acceleration(law, v);
}

/// When a stepper leaves a step to its general case.
enum class LaneRule {
    Substeps, ///< steps of DiscreteStepper
    Sweep     ///< steps of swept: it looks whether the way leads back, and how a ball starts
};

/// One axis of balls in their regions.
template<class N>
class InRegion {
public:
    using Mask = typename N::Mask;

    InRegion(const LaneAxis &along, uint32_t lane, N drive)
        : m_low(N::load(along.low + lane))
        , m_high(N::load(along.high + lane))
        , m_place(N::load(along.position + lane))
        , m_velocity(N::load(along.velocity + lane))
        , m_atLow((m_place == N::load(along.lowFace + lane)) & (m_velocity == 0.0))
        , m_atHigh((m_place == N::load(along.highFace + lane)) & (m_velocity == 0.0))
        , m_leans((m_atLow & (drive < 0.0)) | (m_atHigh & (drive > 0.0))) {}

    N place() const { return m_place; }
    N velocity() const { return m_velocity; }
    /// Whether the ball leans on a face, which takes the drive into it.
    Mask leans() const { return m_leans; }
    /// Whether it may be at a place: nothing is near there, or the face that it is at.
    Mask has(N place) const {
        return ((m_low <= place) & (place <= m_high)) | ((m_atLow | m_atHigh) & (place == m_place));
    }
    /// Whether it is there, and comes to no other face within a way in either direction.
    Mask isClear(N way) const { return ((m_low <= m_place - way) | m_atLow) & ((m_place + way <= m_high) | m_atHigh); }

private:
    N m_low, m_high, m_place, m_velocity;
    Mask m_atLow, m_atHigh, m_leans;
};

/// Moves as many balls as N has numbers, where they can be moved so. Returns which took the step, as bits.
template<class N, class Scheme, LaneRule kRule, bool kResists>
[[gnu::always_inline]] inline uint32_t rollInLanes(Lanes &lanes, uint32_t lane, Planar<N> *displacement = nullptr) {
    using Mask = typename N::Mask;
    const double h = lanes.dt;
    const auto of = [lane](const LaneNumbers &numbers) { return N::load(numbers + lane); };
    const Planar<N> pull{of(lanes.x.gravity), of(lanes.y.gravity)};
    const N normal = -of(lanes.gravityZ);
    const Planar<N> drive = of(lanes.share) * pull;
    const N B = of(lanes.share) * (of(lanes.resistance) * normal);
    const InRegion<N> x(lanes.x, lane, drive.x), y(lanes.y, lane, drive.y);
    const Planar<N> start{x.place(), y.place()}, velocity{x.velocity(), y.velocity()};
    const Planar<N> A{choose(x.leans(), 0.0, drive.x), choose(y.leans(), 0.0, drive.y)};

    // nearStop. Numbers that can be computed with stand in for a ball that the general case moves.
    const N speedSquared = dot(velocity, velocity);
    const N stop = choose(B < length(A), 1.0, 4.0) * (length(A) + B) * h;
    const Mask goesOn = kResists                      ? speedSquared > stop * stop
                        : kRule == LaneRule::Substeps ? speedSquared >= 0.0
                                                      : speedSquared > 0.0;
    const Planar<N> v{choose(goesOn, velocity.x, 1.0), choose(goesOn, velocity.y, 0.0)};
    const auto next = Scheme::advance(UnstoppedLaw<N, kResists>{A, B}, v, h);
    const Planar<N> nextVelocity{choose(x.leans(), 0.0, next.velocity.x), choose(y.leans(), 0.0, next.velocity.y)};
    const Planar<N> moved = start + next.displacement;
    const Planar<N> end{choose(x.leans(), start.x, moved.x), choose(y.leans(), start.y, moved.y)};

    // Which faces a leaning ball meets is looked up on the way that it would take without the one that it leans on.
    const Planar<N> speed{magnitude(velocity.x), magnitude(velocity.y)};
    const N across = magnitude(pull.x) + magnitude(pull.y);
    const N reach = (speed.x + speed.y + (across + of(lanes.pull) * normal) * h) * h;
    const N way = magnitude(next.displacement.x) + magnitude(next.displacement.y);
    const Mask isSlow = (reach <= lanes.reach) & (way <= lanes.reach);
    const N inTheOpen = lanes.isOpen * reach;
    const N aheadX = choose(y.leans(), (speed.x + (magnitude(drive.x) + B) * h) * h, inTheOpen);
    const N aheadY = choose(x.leans(), (speed.y + (magnitude(drive.y) + B) * h) * h, inTheOpen);
    const Mask grips = dot(pull, pull) <= of(lanes.grip) * (normal * normal);
    const Mask staysFast = dot(nextVelocity, nextVelocity) > 1.1e-23 * (across + normal) * lanes.radius; // mayRest
    Mask rolls = grips & goesOn & isSlow & staysFast & x.has(end.x) & y.has(end.y) & (of(lanes.rests) == 0.0);
    if constexpr (kRule == LaneRule::Sweep) {
        const Planar<N> corner = start + 0.5 * h * velocity;
        rolls = rolls & x.has(corner.x) & y.has(corner.y) & (dot(nextVelocity, velocity) > 1.1e-9 * speedSquared);
    }
    const Mask rests = (of(lanes.rests) > 0.0) & (dot(A, A) <= B * B);
    const Mask isAllowed = (magnitude(pull.x) <= kMostGravity) & (magnitude(pull.y) <= kMostGravity) &
                           (normal <= kMostGravity) & (normal > 0.0) & x.isClear(aheadX) & y.isClear(aheadY);
    rolls = rolls & isAllowed;
    if (displacement) *displacement = next.displacement;
    choose(rolls, end.x, start.x).store(lanes.x.position + lane);
    choose(rolls, end.y, start.y).store(lanes.y.position + lane);
    choose(rolls, nextVelocity.x, velocity.x).store(lanes.x.velocity + lane);
    choose(rolls, nextVelocity.y, velocity.y).store(lanes.y.velocity + lane);
    return (rolls | (rests & isAllowed)).bits();
}

/// The ability that a stepper's `extension` offers.
template<class Scheme, LaneRule kRule>
class LaneStepper {
public:
    static const void *extension(void *, const char *id) {
        static constexpr LaneSteps kSteps{begin, enter, step, one, leave};
        return std::strcmp(id, kLanesId) == 0 ? &kSteps : nullptr;
    }

private:
    static void begin(void *self, const phys_params &params, double dt, Lanes &lanes) {
        lanes = {};
        setUp(static_cast<KnownPlaces *>(self)->scene(), params, dt, lanes);
        for (uint32_t i = 0; i < kLaneCount; ++i) {
            lanes.gravityZ[i] = -1.0;
            for (LaneAxis *along : {&lanes.x, &lanes.y}) keepTo({}, true, *along, i);
        }
    }

    [[gnu::always_inline]] static void setUp(const Scene &scene, const phys_params &params, double dt, Lanes &lanes) {
        lanes.dt = dt;
        const bool isOpen = kRule == LaneRule::Substeps && scene.boxes.size() == 1;
        lanes.isOpen = isOpen ? 1.0 : 0.0;
        // Of isSlow and a FloorView. One floor alone needs neither, but numbers that can be computed with.
        const bool isUsual = dt >= 1e-9 && dt <= 1e3 && scene.radius >= 1e-9 && scene.radius <= 1e9;
        lanes.reach = !isUsual ? -1.0 : isOpen ? 1e6 : 0.5 * scene.radius * (1.0 - 1e-9) - 4.0 * scene.tolerance;
        lanes.radius = scene.radius;
        lanes.resists = params.rolling_friction > 0.0;
    }

    static bool enter(void *self, const phys_params &params, const phys_state &state, Lanes &lanes, uint32_t i) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const PlanInput input{places.scene(), params, lanes.dt, state};
        return params.options == 0 && enterAny(places, input, lanes, i);
    }

    /// Whatever becomes of the orientation.
    [[gnu::always_inline]] static bool enterAny(KnownPlaces &places, const PlanInput &input, Lanes &lanes, uint32_t i) {
        const auto &[scene, params, dt, state] = input;
        if (params.stepper[0] != 0.0 || !input.isOnFloor()) return false;
        if (lanes.resists != (params.rolling_friction > 0.0)) return false;
        const phys_vec3 &v = state.velocity, &spin = state.spin;
        const bool isRigid = params.model == PHYS_MODEL_RIGID;
        const bool slides = isRigid && params.sliding_friction == 0.0;
        if (isRigid) {
            const double turn = lanes.dt * (slides ? glm::length(toVec(spin)) : std::abs(spin.z));
            if (turn > 0.5) return false; // spinsFast
            if (!slides && !rolls({v.x, v.y}, toVec(spin), lanes.radius)) return false;
        }
        const bool isStill = v.x == 0.0 && v.y == 0.0;
        const bool rests = state.flags == PHYS_AT_REST && isStill && spin.x == 0.0 && spin.y == 0.0 && spin.z == 0.0;
        const FloorRegion &region = places.regions().around(state.position, v.x == 0.0 || v.y == 0.0);
        if (!region.has(state.position)) return false;

        const bool mayLean = !isRigid || params.wall_friction == 0.0;
        keepTo(region.along[0], mayLean, lanes.x, i);
        keepTo(region.along[1], mayLean, lanes.y, i);
        lanes.x.position[i] = state.position.x;
        lanes.y.position[i] = state.position.y;
        lanes.x.velocity[i] = v.x;
        lanes.y.velocity[i] = v.y;
        lanes.share[i] = slides ? 1.0 : 5.0 / 7.0;
        lanes.resistance[i] = params.rolling_friction;
        lanes.pull[i] = isRigid ? params.sliding_friction : 0.0;
        const double steepest = 3.5 * params.sliding_friction;
        lanes.grip[i] = isRigid && !slides ? steepest * steepest * (1.0 - 1e-9) : 0x1p400; // gripHolds
        lanes.rests[i] = rests ? 1.0 : 0.0;
        return true;
    }

    [[gnu::always_inline]] static void keepTo(const FloorRegion::Range &range, bool mayLean, LaneAxis &along,
                                              uint32_t i) {
        along.low[i] = range.low;
        along.high[i] = range.high;
        along.lowFace[i] = mayLean ? range.lowFace : FloorRegion::kNoFace;
        along.highFace[i] = mayLean ? range.highFace : FloorRegion::kNoFace;
    }

    static bool one(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                    phys_report *report) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const bool slides = params.model == PHYS_MODEL_RIGID && params.sliding_friction == 0.0;
        if ((params.options & ~static_cast<uint32_t>(PHYS_OPTION_ORIENTATION)) || (report && slides)) return false;
        Lanes lanes; // only the first is used
        setUp(places.scene(), params, dt, lanes);
        if (!enterAny(places, {places.scene(), params, dt, in}, lanes, 0)) return false;
        lanes.x.gravity[0] = params.gravity.x;
        lanes.y.gravity[0] = params.gravity.y;
        lanes.gravityZ[0] = params.gravity.z;
        Planar<Single> displacement{0.0, 0.0};
        const bool moved = lanes.resists
                               ? rollInLanes<Single, Scheme, kRule, true>(lanes, 0, report ? &displacement : nullptr)
                               : rollInLanes<Single, Scheme, kRule, false>(lanes, 0);
        if (!moved) return false;
        const Vec3 spinBefore = toVec(in.spin);
        if (&out != &in) out = in;
        leave(params, lanes, 0, out);
        if (params.options & PHYS_OPTION_ORIENTATION) {
            rotate(out.orientation, 0.5 * dt * (spinBefore + toVec(out.spin)));
        }
        if (!report) return true;
        Reporter reporter(report, in.time);
        reporter.substeps(1, kRule == LaneRule::Sweep ? 0 : kSubstepCap);
        if (lanes.rests[0] == 0.0) reporter.lostRolling(1.4 * rollingLaw(params).B * length(displacement).number());
        return true;
    }

    static uint32_t step(Lanes &lanes) { return lanes.resists ? roll<true>(lanes) : roll<false>(lanes); }

    template<bool kResists>
    static uint32_t roll(Lanes &lanes) {
        uint32_t moved = 0;
        for (uint32_t lane = 0; lane < kLaneCount; lane += Pair::kWidth) {
            moved |= rollInLanes<Pair, Scheme, kRule, kResists>(lanes, lane) << lane;
        }
        return moved;
    }

    static void leave(const phys_params &params, const Lanes &lanes, uint32_t i, phys_state &state) {
        const bool isRigid = params.model == PHYS_MODEL_RIGID;
        const bool slides = isRigid && params.sliding_friction == 0.0;
        const Vec2 velocity(lanes.x.velocity[i], lanes.y.velocity[i]);
        if (lanes.rests[i] != 0.0) {
            state.velocity = state.spin = {0.0, 0.0, 0.0};
            return;
        }
        state.position.x = lanes.x.position[i];
        state.position.y = lanes.y.position[i];
        state.velocity = {velocity.x, velocity.y, 0.0};
        const FloorContact contact = slides ? FloorContact::Slides : FloorContact::Rolls;
        const Vec3 drilling(state.spin.x, state.spin.y, isRigid ? state.spin.z : 0.0);
        const Vec3 spin = spinAfter(contact, velocity, drilling, lanes.radius);
        state.spin = fromVec(spin);
        state.flags = slides && isSlipping(params, lanes.radius, velocity, spin) ? PHYS_SLIPPING : 0;
    }
};

} // namespace phys
