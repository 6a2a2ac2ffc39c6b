// SPDX-License-Identifier: MIT
// The table of a stepper of fixed substeps, made from its scheme.
#pragma once

#include "discrete.h"

namespace phys {

/// The row that these steppers have of their own: 1 leaves out cures and substeps, which shows what they are for.
extern const phys_param_row *const kDiscreteRows[1];

inline bool asReported(const phys_params &params) { return params.stepper[0] != 0.0; }

Ball loadBall(const phys_state &state);

/// Stores the ball. flags: PHYS_AT_REST and PHYS_AIRBORNE as they are; the others follow from the ball.
void storeBall(const Scene &scene, const phys_params &params, const Ball &ball, uint64_t flags, phys_state &out);

/// Turns the orientation by the mean spin of the step.
void turn(const phys_state &in, double dt, phys_state &out);

/// Events that only show at the end of a step.
void reportTransitions(Reporter &reporter, double dt, const phys_state &in, bool wasSupported, const phys_state &out);

/// create and destroy of a stepper that needs nothing but the scene.
phys_status keepScene(const phys_scene_view *view, void **self, phys_error *err);
void forgetScene(void *self);

phys_status refuseSubsteps(double substeps, phys_error *err);
phys_status refuseStuck(const phys_state &in, phys_error *err);

template<class Scheme>
struct DiscreteStepper {
    static phys_status requirements(void *self, const phys_params *params, double dt, const phys_state *state,
                                    phys_requirements *out, phys_error *) {
        const Scene &scene = *static_cast<const Scene *>(self);
        describePlan(scene, *params, dt, *state, plan(scene, *params, dt, *state), *out);
        return PHYS_OK;
    }

    static phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                            phys_report *report, phys_error *err) {
        const Scene &scene = *static_cast<const Scene *>(self);
        const StepPlan stepPlan = plan(scene, *params, dt, *in);
        if (stepPlan.substeps > kSubstepCap) return refuseSubsteps(stepPlan.substeps, err);

        const auto substeps = static_cast<uint32_t>(stepPlan.substeps);
        const double h = dt / stepPlan.substeps;
        Reporter reporter(report, in->time);
        reporter.substeps(substeps, kSubstepCap);
        DiscreteStep<Scheme> substep(scene, *params, reporter, stepPlan, h);

        Ball ball = loadBall(*in);
        const bool wasSupported = reporter.wanted() && substep.supports(ball);
        for (uint32_t i = 1; i <= substeps; ++i) {
            if (!substep.run(i * h, ball)) return refuseStuck(*in, err);
        }
        uint64_t flags = substep.supports(ball) ? 0 : PHYS_AIRBORNE;
        if (substep.rests(ball)) flags |= PHYS_AT_REST;
        storeBall(scene, *params, ball, flags, *out);
        if (stepPlan.runs(PHYS_STAGE_ORIENTATION)) turn(*in, dt, *out);
        if (reporter.wanted()) reportTransitions(reporter, dt, *in, wasSupported, *out);
        return PHYS_OK;
    }

private:
    static StepPlan plan(const Scene &scene, const phys_params &params, double dt, const phys_state &state) {
        return planStep(scene, params, dt, state, Scheme::kBounce, asReported(params));
    }
};

/// A stepper's table: id, name, version, summary, and the rest from its scheme.
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
            keepScene,
            forgetScene,
            Stepper::step,
            Stepper::requirements,
            nullptr};
}

} // namespace phys
