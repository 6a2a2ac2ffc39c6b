// SPDX-License-Identifier: MIT
// A stepper's ability to move balls in lanes (registry/lanes.h): a single ball, or several side by side.
#pragma once

#include "base/orientation.h"
#include "floor_contact.h"
#include "known_places.h"
#include "region_step.h"
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
    static const void *extension(void *, const char *id) {
        static constexpr LaneSteps kSteps{begin, enter, step, one, leave};
        return std::strcmp(id, kLanesId) == 0 ? &kSteps : nullptr;
    }

private:
    /// What a step reads of a ball and its parameters besides position and velocity.
    struct Kind {
        bool isRigid, slides;

        explicit Kind(const phys_params &params)
            : isRigid(params.model == PHYS_MODEL_RIGID)
            , slides(isRigid && params.sliding_friction == 0.0) {}

        bool grips() const { return isRigid && !slides; }
        bool mayLean(const phys_params &params) const { return !isRigid || params.wall_friction == 0.0; }
        double share() const { return slides ? 1.0 : 5.0 / 7.0; }
        double friction(const phys_params &params) const { return isRigid ? params.sliding_friction : 0.0; }
        /// gripHolds, with one rounding step of margin.
        double grip(const phys_params &params) const {
            const double steepest = 3.5 * params.sliding_friction;
            return grips() ? steepest * steepest * (1.0 - 1e-9) : 0x1p400;
        }
    };

    static RegionLimits limitsOf(const Scene &scene, double dt) {
        const bool isOpen = kRule == RegionRule::Substeps && scene.boxes.size() == 1;
        // From isSlow and FloorView. A single floor needs neither, only finite numbers for the computation.
        const bool isUsual = dt >= 1e-9 && dt <= 1e3;
        const double reach = isOpen ? 1e6 : 0.5 * scene.radius * (1.0 - 1e-9) - 4.0 * scene.tolerance;
        // From mayRest, under the strongest gravity.
        return {dt, isUsual ? reach : -1.0, 3.5e-17 * scene.radius, isOpen, false};
    }

    /// The longest displacement of a step where nothing is near. swept checks once whether a long path is free, and
    /// then makes it in one piece; where it puts the ball exactly onto its floor, and friction can't speed it up, this
    /// changes no bit.
    static double farthestOf(double reach, const phys_params &params, const Kind &kind, const FloorRegion &region) {
        const bool mayBeLong = kRule == RegionRule::Swept && region.isEven && kind.friction(params) == 0.0;
        return mayBeLong && reach > 0.0 ? 0x1p100 : reach;
    }

    static bool isAtRest(const phys_state &state) {
        const phys_vec3 &v = state.velocity, &spin = state.spin;
        return state.flags == PHYS_AT_REST && v.x == 0.0 && v.y == 0.0 && spin.x == 0.0 && spin.y == 0.0 &&
               spin.z == 0.0;
    }

    /// Whether a ball rolls or slides on the floor with no other spin than that.
    static bool isOnFloor(const PlanInput &input, const Kind &kind) {
        if (asReported(input.params) || !input.isOnFloor()) return false;
        if (!kind.isRigid) return true;
        const Vec3 spin = toVec(input.state.spin);
        const double turn = input.dt * (kind.slides ? glm::length(spin) : std::abs(spin.z));
        if (turn > 0.5) return false; // from spinsFast
        return kind.slides || rolls(inPlane(input.state.velocity), spin, input.scene.radius);
    }

    /// The region of a ball that satisfies InRegion, or nullptr.
    static const FloorRegion *regionOf(KnownPlaces &places, const phys_state &state, bool mayLean) {
        const phys_vec3 &v = state.velocity;
        if (has(places.regions().last(), state, mayLean)) return &places.regions().last();
        const FloorRegion *region = places.regions().find(state.position, v.x == 0.0 || v.y == 0.0);
        return region && has(*region, state, mayLean) ? region : nullptr;
    }

    static bool has(const FloorRegion &region, const phys_state &state, bool mayLean) {
        const phys_vec3 &p = state.position, &v = state.velocity;
        const auto isIn = [mayLean](const FloorRegion::Range &range, double place, double speed) {
            return range.isFree(place) || (mayLean && speed == 0.0 && range.isFace(place));
        };
        return p.z == region.z && isIn(region.along[0], p.x, v.x) && isIn(region.along[1], p.y, v.y);
    }

    static double faceOf(double face, bool mayLean) { return mayLean ? face : FloorRegion::kNoFace; }

    // One ball.

    static bool one(void *self, const phys_params &params, double dt, const phys_state &in, phys_state &out,
                    phys_report *report) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const PlanInput input{places.scene(), params, dt, in};
        const Kind kind(params);
        const bool isOther = params.options & ~static_cast<uint32_t>(PHYS_OPTION_ORIENTATION);
        if (isOther || (report && kind.slides) || !isOnFloor(input, kind)) return false;
        RegionLimits limits = limitsOf(places.scene(), dt);
        limits.mayGrip = kind.grips();
        const bool mayLean = kind.mayLean(params), rests = isAtRest(in);
        const phys_vec3 &g = params.gravity;
        const FloorDrive<double> drive{{g.x, g.y}, g.z, kind.share(), params.rolling_friction};
        const FloorRegion *region = regionOf(places, in, mayLean);
        for (bool isFirst = true; region; isFirst = false) {
            const BallsInRegion<double> ball{axisOf(region->along[0], mayLean, in.position.x, in.velocity.x),
                                             axisOf(region->along[1], mayLean, in.position.y, in.velocity.y),
                                             drive,
                                             kind.grip(params),
                                             kind.friction(params),
                                             rests ? 1.0 : 0.0,
                                             report ? limits.reach : farthestOf(limits.reach, params, kind, *region)};
            const auto asItIs = [](const RegionStep<double> &step) { return step; };
            const RegionStep<double> step = params.rolling_friction > 0.0
                                                ? StepInRegion<Scheme, kRule, true>::make(ball, limits, asItIs)
                                                : StepInRegion<Scheme, kRule, false>::make(ball, limits, asItIs);
            const Planar<double> end{in.position.x + step.displacement.x, in.position.y + step.displacement.y};
            if (step.isFine) {
                take(input, kind, rests, end, step, out, report);
                return true;
            }
            if (!isFirst || (region->along[0].has(end.x) && region->along[1].has(end.y))) return false;
            // Regions overlap: one that contains the end may also contain the start.
            region = places.regions().find({end.x, end.y, in.position.z}, in.velocity.x == 0.0 || in.velocity.y == 0.0);
            if (region && !has(*region, in, mayLean)) return false;
        }
        return false;
    }

    static InRegion<double> axisOf(const FloorRegion::Range &range, bool mayLean, double place, double velocity) {
        return {
            place, velocity, range.low, range.high, faceOf(range.lowFace, mayLean), faceOf(range.highFace, mayLean)};
    }

    /// Stores the result of the step for the ball.
    static void take(const PlanInput &input, const Kind &kind, bool rests, const Planar<double> &place,
                     const RegionStep<double> &step, phys_state &out, phys_report *report) {
        const auto &[scene, params, dt, in] = input;
        const Vec2 velocity = inPlane(in.velocity); // `out` may be `in`
        const Vec3 given = toVec(in.spin);
        const auto spinBefore = [&] { return kind.isRigid ? given : rollingSpin(velocity, scene.radius); };
        if (&out != &in) out = in;
        store(params, kind, scene.radius, rests, {place.x, place.y}, {step.velocity.x, step.velocity.y}, out);
        if (params.options & PHYS_OPTION_ORIENTATION) {
            rotate(out.orientation, 0.5 * dt * (spinBefore() + toVec(out.spin)));
        }
        if (!report) return;
        Reporter reporter(report, in, dt);
        reporter.substeps(1, kRule == RegionRule::Swept ? 0 : kSubstepCap);
        reporter.lostSlip(spinEnergy(given, scene.radius) - spinEnergy(spinBefore(), scene.radius));
        if (rests) return;
        const Advance<Vec2> next{{step.velocity.x, step.velocity.y}, {step.displacement.x, step.displacement.y}};
        reporter.lostRolling(1.4 * rollingLaw(params).B * meanWay<Scheme>(velocity, next, dt));
    }

    /// Stores a ball except for its height, orientation, time and step.
    static void store(const phys_params &params, const Kind &kind, double radius, bool rests, const Vec2 &place,
                      const Vec2 &velocity, phys_state &state) {
        if (rests) {
            state.velocity = state.spin = {0.0, 0.0, 0.0};
            return;
        }
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
        const RegionLimits limits = limitsOf(scene, dt);
        lanes.dt = dt;
        lanes.reach = limits.reach;
        lanes.restSquared = limits.restSquared;
        lanes.isOpen = limits.isOpen;
        lanes.radius = scene.radius;
        lanes.resists = params.rolling_friction > 0.0;
        for (uint32_t i = 0; i < kLaneCount; ++i) {
            lanes.gravityZ[i] = -1.0;
            for (LaneAxis *along : {&lanes.x, &lanes.y}) keepTo({}, true, *along, i);
        }
    }

    static bool enter(void *self, const phys_params &params, const phys_state &state, Lanes &lanes, uint32_t i) {
        KnownPlaces &places = *static_cast<KnownPlaces *>(self);
        const Kind kind(params);
        const bool isUsual = params.options == 0 && lanes.resists == (params.rolling_friction > 0.0);
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
        lanes.mayGrip = lanes.mayGrip || kind.grips();
        lanes.grip[i] = kind.grip(params);
        lanes.rests[i] = isAtRest(state) ? 1.0 : 0.0;
        lanes.farthest[i] = farthestOf(lanes.reach, params, kind, *region);
        return true;
    }

    static void keepTo(const FloorRegion::Range &range, bool mayLean, LaneAxis &along, uint32_t i) {
        along.low[i] = range.low;
        along.high[i] = range.high;
        along.lowFace[i] = faceOf(range.lowFace, mayLean);
        along.highFace[i] = faceOf(range.highFace, mayLean);
    }

    static uint32_t step(Lanes &lanes) { return lanes.resists ? roll<true>(lanes) : roll<false>(lanes); }

    template<bool kResists>
    static uint32_t roll(Lanes &lanes) {
        const RegionLimits limits{lanes.dt, lanes.reach, lanes.restSquared, lanes.isOpen, lanes.mayGrip};
        uint32_t moved = 0;
        for (uint32_t lane = 0; lane < kLaneCount; lane += kWidth<Pair>) {
            const BallsInRegion<Pair> balls = load(lanes, lane);
            moved |= StepInRegion<Scheme, kRule, kResists>::make(balls, limits, [&](const RegionStep<Pair> &step) {
                move(balls.x, step.displacement.x, step.velocity.x, step.isFine, lanes.x, lane);
                move(balls.y, step.displacement.y, step.velocity.y, step.isFine, lanes.y, lane);
                return bitsOf(step.isFine) << lane;
            });
        }
        return moved;
    }

    static BallsInRegion<Pair> load(const Lanes &lanes, uint32_t lane) {
        const auto of = [lane](const LaneNumbers &numbers) { return phys::load<Pair>(numbers + lane); };
        const auto along = [of](const LaneAxis &axis) {
            return InRegion<Pair>{of(axis.position), of(axis.velocity), of(axis.low),
                                  of(axis.high),     of(axis.lowFace),  of(axis.highFace)};
        };
        const Planar<Pair> pull{of(lanes.x.gravity), of(lanes.y.gravity)};
        return {
            along(lanes.x),    along(lanes.y),     {pull, of(lanes.gravityZ), of(lanes.share), of(lanes.resistance)},
            of(lanes.grip),    of(lanes.friction), of(lanes.rests),
            of(lanes.farthest)};
    }

    /// Stores the balls' results along an axis; balls for which `fine` is false are unchanged.
    static void move(const InRegion<Pair> &ball, Pair displacement, Pair velocity, MaskOf<Pair> isFine, LaneAxis &along,
                     uint32_t lane) {
        phys::store(choose(isFine, ball.place + displacement, ball.place), along.position + lane);
        phys::store(choose(isFine, velocity, ball.velocity), along.velocity + lane);
    }

    static void leave(const phys_params &params, const Lanes &lanes, uint32_t i, phys_state &state) {
        store(params, Kind(params), lanes.radius, lanes.rests[i] != 0.0, {lanes.x.position[i], lanes.y.position[i]},
              {lanes.x.velocity[i], lanes.y.velocity[i]}, state);
    }
};

} // namespace phys
