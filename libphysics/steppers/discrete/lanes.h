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
    Swept     ///< steps of swept: it looks whether the way leads back, and how a ball starts
};

/// What gravity does to balls on the floor, model.md 2.1.
template<class N>
struct FloorDrive {
    Planar<N> pull; ///< gravity along the floor, m/s^2
    N normal;       ///< gravity into it, m/s^2
    Planar<N> A;    ///< what the pull accelerates a ball by that nothing holds, m/s^2
    N B;            ///< rolling resistance, m/s^2

    FloorDrive(const Lanes &lanes, uint32_t lane)
        : pull{N::load(lanes.x.gravity + lane), N::load(lanes.y.gravity + lane)}
        , normal(-N::load(lanes.gravityZ + lane))
        , A(N::load(lanes.share + lane) * pull)
        , B(N::load(lanes.share + lane) * (N::load(lanes.resistance + lane) * normal)) {}
};

/// One axis of balls in their regions. Each is where nothing is near, or it is at a face with no speed along the axis.
template<class N>
class InRegion {
public:
    using Mask = typename N::Mask;

    InRegion(const LaneAxis &along, uint32_t lane)
        : m_along(along)
        , m_lane(lane)
        , m_place(of(along.position))
        , m_velocity(of(along.velocity)) {}

    N place() const { return m_place; }
    N velocity() const { return m_velocity; }
    Mask isAtLow() const { return (m_place == of(m_along.lowFace)) & (m_velocity == 0.0); }
    Mask isAtHigh() const { return (m_place == of(m_along.highFace)) & (m_velocity == 0.0); }
    /// Whether nothing is near a place.
    Mask isFree(N place) const { return (of(m_along.low) <= place) & (place <= of(m_along.high)); }
    Mask isFreeAround(N way) const { return (of(m_along.low) <= m_place - way) & (m_place + way <= of(m_along.high)); }
    /// Whether that is so, or the ball is still at its face there.
    Mask has(N place) const { return isFree(place) | ((isAtLow() | isAtHigh()) & (place == m_place)); }
    /// Whether the ball comes to no other face within a way in either direction.
    Mask isClear(N way) const {
        return ((of(m_along.low) <= m_place - way) | isAtLow()) & ((m_place + way <= of(m_along.high)) | isAtHigh());
    }

private:
    N of(const LaneNumbers &numbers) const { return N::load(numbers + m_lane); }

    const LaneAxis &m_along;
    uint32_t m_lane;
    N m_place, m_velocity;
};

/// What balls do in a step, and whether they can do it in their lanes.
template<class N>
struct LaneStep {
    Planar<N> velocity, displacement;
    typename N::Mask isFine;
};

/// The step of the scheme under a drive, wherever it leads.
template<class N, class Scheme, LaneRule kRule, bool kResists>
[[gnu::always_inline]] inline LaneStep<N> rollBy(const Planar<N> &A, const FloorDrive<N> &drive, const Lanes &lanes,
                                                 uint32_t lane, const Planar<N> &velocity) {
    const double h = lanes.dt;
    const auto of = [lane](const LaneNumbers &numbers) { return N::load(numbers + lane); };
    // nearStop. Numbers that can be computed with stand in for a ball that the general case moves.
    const N speedSquared = dot(velocity, velocity), driveLength = length(A);
    const N stop = choose(drive.B < driveLength, 1.0, 4.0) * (driveLength + drive.B) * h;
    const auto goesOn = kResists                      ? speedSquared > stop * stop
                        : kRule == LaneRule::Substeps ? speedSquared >= 0.0
                                                      : speedSquared > 0.0;
    const Planar<N> v{choose(goesOn, velocity.x, 1.0), choose(goesOn, velocity.y, 0.0)};
    const auto next = Scheme::advance(UnstoppedLaw<N, kResists>{A, drive.B}, v, h);

    const N across = magnitude(drive.pull.x) + magnitude(drive.pull.y);
    const N pull = across + of(lanes.pull) * drive.normal;
    const N reach = (magnitude(velocity.x) + magnitude(velocity.y) + pull * h) * h;
    const N way = magnitude(next.displacement.x) + magnitude(next.displacement.y);
    const auto isAllowed = (across <= kMostGravity) & (drive.normal <= kMostGravity) & (drive.normal > 0.0);
    auto isFine = goesOn & isAllowed & (reach <= lanes.reach) & (way <= lanes.reach);
    if (lanes.mayGrip)
        isFine = isFine & (dot(drive.pull, drive.pull) <= of(lanes.grip) * (drive.normal * drive.normal));
    return {next.velocity, next.displacement, isFine};
}

/// What a step must not end with, or lead back by.
template<class N, LaneRule kRule>
[[gnu::always_inline]] inline typename N::Mask staysFast(const Lanes &lanes, const Planar<N> &velocity,
                                                         const Planar<N> &next) {
    const auto isFast = dot(next, next) > lanes.restSquared;
    if constexpr (kRule == LaneRule::Substeps) return isFast;
    return isFast & (dot(next, velocity) > 1.1e-9 * dot(velocity, velocity));
}

/// Balls none of which is at a face or at rest.
template<class N, class Scheme, LaneRule kRule, bool kResists>
[[gnu::always_inline]] inline LaneStep<N> rollFree(const FloorDrive<N> &drive, const Lanes &lanes, uint32_t lane,
                                                   const InRegion<N> &x, const InRegion<N> &y) {
    const double h = lanes.dt;
    const Planar<N> velocity{x.velocity(), y.velocity()};
    LaneStep<N> step = rollBy<N, Scheme, kRule, kResists>(drive.A, drive, lanes, lane, velocity);
    step.isFine = step.isFine & x.isFree(x.place() + step.displacement.x) & y.isFree(y.place() + step.displacement.y) &
                  staysFast<N, kRule>(lanes, velocity, step.velocity);
    if constexpr (kRule == LaneRule::Swept) {
        const Planar<N> turn = 0.5 * h * velocity;
        step.isFine = step.isFine & x.isFree(x.place() + turn.x) & y.isFree(y.place() + turn.y);
    }
    return step;
}

/// staysOnOneFloor, where there is nothing else.
template<class N>
[[gnu::always_inline]] inline typename N::Mask staysOnFloor(const FloorDrive<N> &drive, const Lanes &lanes,
                                                            uint32_t lane, const InRegion<N> &x, const InRegion<N> &y) {
    const double h = lanes.dt;
    const N pull = magnitude(drive.pull.x) + magnitude(drive.pull.y) + N::load(lanes.pull + lane) * drive.normal;
    const N reach = (magnitude(x.velocity()) + magnitude(y.velocity()) + pull * h) * h;
    return x.isFreeAround(reach) & y.isFreeAround(reach);
}

/// Any balls.
template<class N, class Scheme, LaneRule kRule, bool kResists>
[[gnu::always_inline]] inline LaneStep<N> rollOrRest(const FloorDrive<N> &drive, const Lanes &lanes, uint32_t lane,
                                                     const InRegion<N> &x, const InRegion<N> &y) {
    const double h = lanes.dt;
    // A face takes the drive into it from a ball that leans on it.
    const auto leansX = (x.isAtLow() & (drive.A.x < 0.0)) | (x.isAtHigh() & (drive.A.x > 0.0));
    const auto leansY = (y.isAtLow() & (drive.A.y < 0.0)) | (y.isAtHigh() & (drive.A.y > 0.0));
    const Planar<N> A{choose(leansX, 0.0, drive.A.x), choose(leansY, 0.0, drive.A.y)};
    const Planar<N> velocity{x.velocity(), y.velocity()};
    LaneStep<N> step = rollBy<N, Scheme, kRule, kResists>(A, drive, lanes, lane, velocity);
    step.velocity = {choose(leansX, 0.0, step.velocity.x), choose(leansY, 0.0, step.velocity.y)};
    step.displacement = {choose(leansX, 0.0, step.displacement.x), choose(leansY, 0.0, step.displacement.y)};

    // Which faces a leaning ball meets is looked up on the way that it would take without the one that it leans on.
    const N aheadX = (magnitude(velocity.x) + (magnitude(drive.A.x) + drive.B) * h) * h;
    const N aheadY = (magnitude(velocity.y) + (magnitude(drive.A.y) + drive.B) * h) * h;
    const auto isClear = x.isClear(choose(leansY, aheadX, 0.0)) & y.isClear(choose(leansX, aheadY, 0.0));
    auto rolls = step.isFine & isClear & x.has(x.place() + step.displacement.x) &
                 y.has(y.place() + step.displacement.y) & staysFast<N, kRule>(lanes, velocity, step.velocity);
    if constexpr (kRule == LaneRule::Swept) {
        const Planar<N> turn = 0.5 * h * velocity;
        rolls = rolls & x.has(x.place() + turn.x) & y.has(y.place() + turn.y);
    }
    const N rests = N::load(lanes.rests + lane);
    const auto isHeld = (dot(A, A) <= drive.B * drive.B) & (drive.normal <= kMostGravity) & (drive.normal > 0.0) &
                        (magnitude(drive.pull.x) + magnitude(drive.pull.y) <= kMostGravity);
    const auto isAtRest = rests > 0.0;
    step.velocity = {choose(isAtRest, velocity.x, step.velocity.x), choose(isAtRest, velocity.y, step.velocity.y)};
    step.displacement = {choose(isAtRest, 0.0, step.displacement.x), choose(isAtRest, 0.0, step.displacement.y)};
    step.isFine = (isAtRest & isHeld & isClear) | ((rests == 0.0) & rolls);
    return step;
}

/// Moves as many balls as N has numbers, where they can be moved so. Returns which took the step, as bits.
template<class N, class Scheme, LaneRule kRule, bool kResists>
[[gnu::always_inline]] inline uint32_t rollInLanes(Lanes &lanes, uint32_t lane, Planar<N> *displacement = nullptr) {
    const FloorDrive<N> drive(lanes, lane);
    const InRegion<N> x(lanes.x, lane), y(lanes.y, lane);
    const bool areFree = ((x.velocity() == 0.0) | (y.velocity() == 0.0)).bits() == 0;
    LaneStep<N> step = areFree ? rollFree<N, Scheme, kRule, kResists>(drive, lanes, lane, x, y)
                               : rollOrRest<N, Scheme, kRule, kResists>(drive, lanes, lane, x, y);
    if (lanes.isOpen) step.isFine = step.isFine & staysOnFloor(drive, lanes, lane, x, y);
    if (displacement) *displacement = step.displacement;
    choose(step.isFine, x.place() + step.displacement.x, x.place()).store(lanes.x.position + lane);
    choose(step.isFine, y.place() + step.displacement.y, y.place()).store(lanes.y.position + lane);
    choose(step.isFine, step.velocity.x, x.velocity()).store(lanes.x.velocity + lane);
    choose(step.isFine, step.velocity.y, y.velocity()).store(lanes.y.velocity + lane);
    return step.isFine.bits();
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
        lanes.isOpen = isOpen;
        lanes.mayGrip = false;
        lanes.restSquared = 3.5e-17 * scene.radius; // mayRest's, under the strongest gravity
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
        lanes.mayGrip = lanes.mayGrip || (isRigid && !slides);
        lanes.grip[i] = isRigid && !slides ? steepest * steepest * (1.0 - 1e-9) : 0x1p400; // gripHolds
        lanes.rests[i] = rests ? 1.0 : 0.0;
        return isInRegion(lanes.x, i) && isInRegion(lanes.y, i);
    }

    /// Whether the ball is as InRegion says.
    [[gnu::always_inline]] static bool isInRegion(const LaneAxis &along, uint32_t i) {
        const double place = along.position[i];
        const bool isAtFace = along.velocity[i] == 0.0 && (place == along.lowFace[i] || place == along.highFace[i]);
        return isAtFace || (place >= along.low[i] && place <= along.high[i]);
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
        const PlanInput input{places.scene(), params, dt, in};
        if (in.flags == PHYS_AT_REST && !report && stay(input, places.footing(), out)) return true;
        const bool slides = params.model == PHYS_MODEL_RIGID && params.sliding_friction == 0.0;
        if ((params.options & ~static_cast<uint32_t>(PHYS_OPTION_ORIENTATION)) || (report && slides)) return false;
        Lanes lanes; // only the first is used
        setUp(places.scene(), params, dt, lanes);
        if (!enterAny(places, input, lanes, 0)) return false;
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
        reporter.substeps(1, kRule == LaneRule::Swept ? 0 : kSubstepCap);
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
