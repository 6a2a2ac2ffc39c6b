// SPDX-License-Identifier: MIT
// A stepper's ability to move balls in lanes (registry/lanes.h): a single ball, or several side by side.
#pragma once

#include "base/orientation.h"
#include "floor_contact.h"
#include "floor_kind.h"
#include "known_places.h"
#include "lane_step.h"
#include "lane_step_by_four.h"
#include "registry/lanes.h"
#include "registry/report.h"
#include "requirements.h"
#include "shared/floor_region.h"

#include <cmath>
#include <cstring>

namespace phys {

template<class Scheme, RegionRule kRule>
class LaneStepper {
public:
    static const void *extension(void *self, const char *id) {
        static constexpr LaneSteps kByTwo{begin, enter, stepInLanes<Scheme, kRule, Pair>, prepare, one, leave};
        static constexpr LaneSteps kByFour{begin, enter, stepByFour<Scheme, kRule>, prepare, one, leave};
        if (std::strcmp(id, kLanesId) != 0) return nullptr;
        // Beside walls four are slower: all of them take the longer way if one of them leans, and balls come and go.
        const bool isOpen = static_cast<KnownPlaces *>(self)->scene().boxes.size() == 1;
        return isOpen && mayStepByFour() ? &kByFour : &kByTwo;
    }

private:
    static constexpr uint32_t kReportedCap = kRule == RegionRule::Swept ? 0 : kSubstepCap;

    /// fall: m, upper bound of the ball's fall in a step; from mayFallOffFloor.
    static RegionLimits limitsOf(const Scene &scene, double dt, double fall) {
        const bool isOpen = kRule == RegionRule::Substeps && scene.boxes.size() == 1;
        // From isSlow and FloorView. A single floor needs neither, only finite numbers for the computation.
        const bool isUsual = dt >= 1e-9 && dt <= 1e3;
        const double reach = !isUsual ? -1.0 : isOpen ? 1e6 : 0.5 * scene.radius * (1.0 - 1e-9) - 4.0 * scene.tolerance;
        // From mayRest, under the strongest gravity.
        return {dt, reach, 3.5e-17 * scene.radius, isOpen || (kRule == RegionRule::Substeps && fall > reach)};
    }

    /// The longest displacement of a step where nothing is near. swept checks once whether a long path is free, and
    /// then makes it in one piece; where it puts the ball exactly onto its floor, and friction can't speed it up, this
    /// changes no bit.
    static double farthestOf(double reach, const phys_params &params, const FloorKind &kind,
                             const FloorRegion &region) {
        const bool mayBeLong = kRule == RegionRule::Swept && region.isEven && kind.friction(params) == 0.0;
        return mayBeLong && reach > 0.0 ? 0x1p100 : reach;
    }

    static bool isAtRest(const phys_state &state) {
        const phys_vec3 &v = state.velocity, &spin = state.spin;
        return state.flags == PHYS_AT_REST && v.x == 0.0 && v.y == 0.0 && spin.x == 0.0 && spin.y == 0.0 &&
               spin.z == 0.0;
    }

    /// Whether a ball rolls or slides on the floor with no other spin than that.
    static bool isOnFloor(const PlanInput &input, const FloorKind &kind) {
        if (!input.isOnFloor()) return false;
        if (!kind.isRigid) return true;
        const Vec3 spin = toVec(input.state.spin);
        const double turn = input.dt * (kind.slides ? glm::length(spin) : std::abs(spin.z));
        if (turn > 0.5) return false; // from spinsFast
        return kind.slides || rolls(inPlane(input.state.velocity), spin, input.scene.radius);
    }

    /// The region of a ball that satisfies InRegion, or nullptr.
    static const FloorRegion *regionOf(KnownPlaces &places, const phys_state &state, bool mayLean) {
        if (has(places.regions().last(), state, mayLean)) return &places.regions().last();
        const FloorRegion *region = places.regions().find(state.position, inPlane(state.velocity));
        return region && has(*region, state, mayLean) ? region : nullptr;
    }

    static bool has(const FloorRegion &region, const phys_state &state, bool mayLean) {
        const phys_vec3 &p = state.position, &v = state.velocity;
        const auto isIn = [mayLean](const FloorRegion::Range &range, double place, double speed) {
            return range.isFree(place) || (mayLean && speed == 0.0 && range.isFace(place));
        };
        return p.z == region.z && isIn(region.along[0], p.x, v.x) && isIn(region.along[1], p.y, v.y);
    }

    /// Wherever FloorRun::mayLean may.
    static bool looksAhead(const FloorRegion &region, bool mayLean) {
        return kLooksAhead<Scheme> && (region.hasSlopes || !mayLean);
    }

    static double faceOf(double face, bool mayLean) { return mayLean ? face : FloorRegion::kNoFace; }

    // One ball.

    static void prepare(void *self, const phys_params &params, double dt) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const phys_vec3 &g = params.gravity;
        const FloorKind kind(params);
        const bool isOther = (params.options & ~static_cast<uint32_t>(PHYS_OPTION_ORIENTATION)) || asReported(params);
        const RegionLimits limits = limitsOf(places.scene(), dt, dt * dt * -g.z);
        const auto drive = driveOf<double>({g.x, g.y}, g.z, kind.share(), params.rolling_friction,
                                           kind.friction(params), kind.grip(params), limits);
        places.drive() = {!isOther, kind, kind.mayLean(params), limits, drive};
    }

    /// A ball in a region: region_step.h.
    struct OneInRegion {
        using Number = double;

        const phys_state &state;
        const FloorRegion &region;
        const KnownDrive &known;
        double longest;

        InRegion<double> x() const { return along(0, state.position.x, state.velocity.x); }
        InRegion<double> y() const { return along(1, state.position.y, state.velocity.y); }
        const FloorDrive<double> &drive() const { return known.drive; }
        double farthest() const { return longest; }

    private:
        InRegion<double> along(size_t axis, double place, double velocity) const {
            const FloorRegion::Range &range = region.along[axis];
            return {place,
                    velocity,
                    range.low,
                    range.high,
                    faceOf(range.lowFace, known.mayLean),
                    faceOf(range.highFace, known.mayLean)};
        }
    };

    static bool one(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                    phys_report *report) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const PlanInput input{places.scene(), params, dt, in};
        const KnownDrive &known = places.drive();
        const FloorKind &kind = known.kind;
        const bool mayLean = known.mayLean;
        if (!known.isUsual || (report && kind.slides) || !isOnFloor(input, kind)) return false;
        const FloorRegion *region = regionOf(places, in, mayLean);
        if (!region) return false;
        const RegionLimits &limits = known.limits;
        for (bool isFirst = true;; isFirst = false) {
            const OneInRegion ball{in, *region, known,
                                   report ? limits.reach : farthestOf(limits.reach, params, kind, *region)};
            if (isAtRest(in) && staysAtRest(ball)) {
                stayAtRest(input, out, report);
                return true;
            }
            const auto asItIs = [](const RegionStep<double> &step) { return step; };
            const RegionStep<double> step = params.rolling_friction > 0.0
                                                ? StepInRegion<Scheme, kRule, true>::make(ball, limits, asItIs)
                                                : StepInRegion<Scheme, kRule, false>::make(ball, limits, asItIs);
            const Planar<double> end{in.position.x + step.displacement.x, in.position.y + step.displacement.y};
            if (step.isFine && (!looksAhead(*region, mayLean) || isFreeAhead(ball, dt, step.velocity))) {
                take(input, kind, end, step, out, report);
                return true;
            }
            if (!isFirst || !(region->along[0].endsOpenBefore(end.x) || region->along[1].endsOpenBefore(end.y)))
                return false;
            // Regions overlap: one that contains the end may also contain the start.
            region = places.regions().find({end.x, end.y, in.position.z}, inPlane(in.velocity));
            if (!region || !has(*region, in, mayLean)) return false;
        }
    }

    static void stayAtRest(const PlanInput &input, phys_state &out, phys_report *report) {
        if (&out != &input.state) out = input.state;
        out.velocity = out.spin = {0.0, 0.0, 0.0};
        Reporter(report, input.state, input.dt).substeps(1, kReportedCap);
    }

    /// Stores the result of the step for the ball.
    static void take(const PlanInput &input, const FloorKind &kind, const Planar<double> &place,
                     const RegionStep<double> &step, phys_state &out, phys_report *report) {
        const auto &[scene, params, dt, in] = input;
        const Vec2 velocity = inPlane(in.velocity); // `out` may be `in`
        const Vec3 given = toVec(in.spin);
        const double radius = input.scene.radius; // clang captures no structured binding
        const auto spinBefore = [&] { return kind.isRigid ? given : rollingSpin(velocity, radius); };
        if (&out != &in) out = in;
        store(params, kind, radius, {place.x, place.y}, {step.velocity.x, step.velocity.y}, out);
        if (params.options & PHYS_OPTION_ORIENTATION) {
            rotate(out.orientation, 0.5 * dt * (spinBefore() + toVec(out.spin)));
        }
        if (!report) return;
        Reporter reporter(report, in, dt);
        reporter.substeps(1, kReportedCap);
        reporter.lostSlip(spinEnergy(given, radius) - spinEnergy(spinBefore(), radius));
        const Advance<Vec2> next{{step.velocity.x, step.velocity.y}, {step.displacement.x, step.displacement.y}};
        reporter.lostRolling(1.4 * rollingLaw(params).B * meanWay<Scheme>(velocity, next, dt));
    }

    /// Stores a ball except for its height, orientation, time and step.
    static void store(const phys_params &params, const FloorKind &kind, double radius, const Vec2 &place,
                      const Vec2 &velocity, phys_state &state) {
        state.position.x = place.x;
        state.position.y = place.y;
        state.velocity = {velocity.x, velocity.y, 0.0};
        const FloorContact contact = kind.slides ? FloorContact::Slides : FloorContact::Rolls;
        const Vec3 drilling(state.spin.x, state.spin.y, kind.isRigid ? state.spin.z : 0.0);
        const Vec3 spin = spinAfter(contact, velocity, drilling, radius);
        state.spin = fromVec(spin);
        state.flags = kind.slides && isSlipping(params, radius, velocity, spin) ? PHYS_SLIPPING : 0;
    }

    // Several balls.

    static void begin(void *self, const phys_params &params, double dt, Lanes &lanes) {
        const Scene &scene = static_cast<KnownPlaces *>(self)->scene();
        lanes = {};
        const RegionLimits limits = limitsOf(scene, dt, 0.0);
        lanes.dt = dt;
        lanes.reach = limits.reach;
        lanes.restSquared = limits.restSquared;
        lanes.mayFall = limits.mayFall;
        lanes.radius = scene.radius;
        lanes.resists = params.rolling_friction > 0.0;
        lanes.tilted = ~0U;
        for (uint32_t i = 0; i < kLaneCount; ++i) {
            lanes.gravityZ[i] = -1.0;
            for (LaneAxis *along : {&lanes.x, &lanes.y}) keepTo({}, true, *along, i);
        }
    }

    static bool enter(void *self, const phys_params &params, const phys_state &state, Lanes &lanes, uint32_t i) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const FloorKind kind(params);
        const bool isUsual = params.options == 0 && !asReported(params) && state.flags != PHYS_AT_REST &&
                             lanes.resists == (params.rolling_friction > 0.0);
        if (!isUsual || !isOnFloor({places.scene(), params, lanes.dt, state}, kind)) return false;
        const bool mayLean = kind.mayLean(params);
        const FloorRegion *region = regionOf(places, state, mayLean);
        if (!region) return false;
        keepTo(region->along[0], mayLean, lanes.x, i);
        keepTo(region->along[1], mayLean, lanes.y, i);
        lanes.x.position[i] = state.position.x;
        lanes.y.position[i] = state.position.y;
        lanes.x.velocity[i] = state.velocity.x;
        lanes.y.velocity[i] = state.velocity.y;
        lanes.share[i] = kind.share();
        lanes.resistance[i] = params.rolling_friction;
        lanes.friction[i] = kind.friction(params);
        lanes.grip[i] = kind.grip(params);
        lanes.farthest[i] = farthestOf(lanes.reach, params, kind, *region);
        if (looksAhead(*region, mayLean)) lanes.looksAhead = true;
        return true;
    }

    static void keepTo(const FloorRegion::Range &range, bool mayLean, LaneAxis &along, uint32_t i) {
        along.low[i] = range.low;
        along.high[i] = range.high;
        along.lowFace[i] = faceOf(range.lowFace, mayLean);
        along.highFace[i] = faceOf(range.highFace, mayLean);
    }

    static void leave(const phys_params &params, const Lanes &lanes, uint32_t i, phys_state &state) {
        store(params, FloorKind(params), lanes.radius, {lanes.x.position[i], lanes.y.position[i]},
              {lanes.x.velocity[i], lanes.y.velocity[i]}, state);
    }
};

} // namespace phys
