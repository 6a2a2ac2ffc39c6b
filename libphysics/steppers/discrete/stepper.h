// SPDX-License-Identifier: MIT
// The table of a stepper of fixed substeps, generated from its scheme.
#pragma once

#include "discrete.h"
#include "known_places.h"
#include "lane_stepper.h"

#include <algorithm>

namespace phys {

/// The steppers' own row: 1 switches off corrections and substeps, to show their purpose.
extern const phys_param_row *const kDiscreteRows[1];

inline Ball loadBall(const phys_state &state) {
    return {toVec(state.position), toVec(state.velocity), toVec(state.spin), false};
}

/// Stores the ball. flags: PHYS_AT_REST and PHYS_AIRBORNE unchanged; the others are derived from the ball.
inline void storeBall(const Scene &scene, const phys_params &params, const Ball &ball, uint64_t flags,
                      phys_state &out) {
    out.position = fromVec(ball.position);
    out.velocity = fromVec(ball.velocity);
    out.spin = fromVec(ball.spin);
    if (scene.isOut(out.position)) flags |= PHYS_OUT;
    const bool onFloor = !(flags & PHYS_AIRBORNE);
    if (onFloor && isSlipping(params, scene.radius, inPlane(ball.velocity), ball.spin)) flags |= PHYS_SLIPPING;
    out.flags = flags;
}

/// Stores the orientation, rotated by the mean spin of the step if that is asked for. The spin after it is in `out`.
void storeOrientation(const PlanInput &input, const StepPlan &plan, const Vec3 &spinBefore, phys_state &out);

/// Events that are known only at the end of a step. before.supported: whether the floor carried the ball.
void reportTransitions(Reporter &reporter, const PlanInput &input, const Ball &before, const phys_state &out);

/// create and destroy of a stepper whose data are its KnownPlaces only.
phys_status makePlaces(const phys_scene_view *view, void **self, phys_error *err);
void deletePlaces(void *self);

phys_status refuseSubsteps(double substeps, phys_error *err);
/// Refuses steps that take too much work.
phys_status refuseWork(phys_status status, phys_error *err);
phys_status refuseStuck(const Vec3 &position, phys_error *err);

/// Stores the ball after its last substep, with the flags derived from it and the events known only now; all but the
/// orientation.
template<class Scheme>
void finishStep(DiscreteStep<Scheme> &substep, const PlanInput &input, const Ball &before, Ball &ball,
                const StepPlan &plan, Reporter &reporter, phys_state &out) {
    const bool isStill =
        plan.asReported ? ball.velocity == Vec3(0.0) : mayRest({input.scene, input.params}, ball.velocity);
    uint64_t flags = isStill && substep.rests(ball) ? PHYS_AT_REST : 0;
    if (!substep.supports(ball)) flags |= PHYS_AIRBORNE;
    storeBall(input.scene, input.params, ball, flags, out);
    if (reporter.wanted()) reportTransitions(reporter, input, before, out);
}

template<class Scheme>
struct DiscreteStepper {
    static phys_status requirements(void *self, const phys_params *params, double dt, const phys_state *state,
                                    phys_requirements *out, phys_error *) {
        const PlanInput input{static_cast<KnownPlaces *>(self)->scene(), *params, dt, *state};
        describePlan(input, plan(input), *out);
        return PHYS_OK;
    }

    static phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                            phys_report *report, phys_error *err) {
        const Scene &scene = static_cast<KnownPlaces *>(self)->scene();
        const PlanInput input{scene, *params, dt, *in};
        const StepPlan stepPlan = plan(input);
        const auto substeps = static_cast<uint32_t>(std::min<double>(stepPlan.substeps, kSubstepCap));
        const double h = dt / stepPlan.substeps;
        Reporter reporter(report, *in, dt);
        reporter.substeps(substeps, kSubstepCap);
        Work work(kMostWork);
        DiscreteStep<Scheme> substep({scene, *params}, reporter, work, stepPlan, h);

        Ball before = loadBall(*in);
        if (!stepPlan.asReported && before.velocity == Vec3(0.0) && substep.rests(before)) {
            finishStep(substep, input, before, before, stepPlan, reporter, *out);
            storeOrientation(input, stepPlan, before.spin, *out);
            return PHYS_OK;
        }
        if (stepPlan.substeps > kSubstepCap) return refuseSubsteps(stepPlan.substeps, err);
        if (reporter.wanted()) before.supported = substep.supports(before);
        if (stepPlan.runs(PHYS_STAGE_ORIENTATION)) before.spin = substep.spinAtStart(before);
        Ball ball = loadBall(*in);
        for (uint32_t i = 1; i <= substeps; ++i) {
            const Ball last = ball;
            if (!substep.run(i * h, ball)) return refuseStuck(before.position, err);
            if (work.isTooMuch()) return refuseWork(PHYS_ERROR_SUBSTEP_CAP, err);
            if (i == substeps || substep.stays(last, ball)) break;
            if (i % kCountedTogether == 0) work.add(kCountedTogether * workOfSubstep(scene, ball.position));
        }
        finishStep(substep, input, before, ball, stepPlan, reporter, *out);
        storeOrientation(input, stepPlan, before.spin, *out);
        return PHYS_OK;
    }

private:
    /// Counting each by itself would make substeps in the open 3 % slower.
    static constexpr uint32_t kCountedTogether = 16;

    static uint64_t workOfSubstep(const Scene &scene, const Vec3 &position) {
        return Work::kSubstep + scene.boxesNear(position.x, position.y, scene.hasManyBoxes).size();
    }

    static StepPlan plan(const PlanInput &input) { return planStep(input, asReported(input.params)); }
};

/// A stepper's table: id, name, version, summary; the rest follows from its scheme.
template<class Scheme>
constexpr phys_stepper_api discreteStepper(const char *id, const char *name, const char *version, const char *summary) {
    using Stepper = DiscreteStepper<Scheme>;
    return {sizeof(phys_stepper_api),
            PHYS_STEPPER_BITS_EVERYWHERE,
            id,
            name,
            version,
            summary,
            kDiscreteRows,
            1,
            0,
            makePlaces,
            deletePlaces,
            Stepper::step,
            Stepper::requirements,
            LaneStepper<Scheme, RegionRule::Substeps>::extension};
}

} // namespace phys
