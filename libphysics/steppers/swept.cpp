// SPDX-License-Identifier: MIT
// Moves to the first impact inside the step, reflects, and goes on with the rest: second order across impacts too, and
// nothing is tunnelled through at any speed.
#include "discrete/stepper.h"
#include "discrete/sweep.h"
#include "discrete/velocity_verlet.h"
#include "registry/built_in_steppers.h"

namespace phys {

namespace {

/// More impacts than this in one step are refused.
constexpr uint32_t kEventCap = 10'000;

phys_status refuseEvents(phys_error *err) {
    return fail(err, PHYS_ERROR_EVENT_CAP, "this step has more than %u impacts: take a smaller dt", kEventCap);
}

/// Close beside a wall a sweep takes more than one phase, whose sum has other bits than one long step.
constexpr int kRoomToGlide = 1;

/// Sweeping takes the place of substeps, and no rest rule but the one for slow bounces applies.
StepPlan planSweep(const PlanInput &input) {
    StepPlan plan = planStep(input, Bounce::RestRule, true);
    plan.bounce = Bounce::RestRule;
    plan.stages |= PHYS_STAGE_SUBSTEPS;
    return plan;
}

phys_status requirements(void *self, const phys_params *params, double dt, const phys_state *state,
                         phys_requirements *out, phys_error *) {
    const PlanInput input{static_cast<Clearing *>(self)->scene(), *params, dt, *state};
    describePlan(input, planSweep(input), *out);
    return PHYS_OK;
}

phys_status sweepStep(const PlanInput &input, phys_state &out, phys_report *report, phys_error *err) {
    const auto &[scene, params, dt, in] = input;
    Reporter reporter(report, in.time);
    reporter.substeps(1, 0);
    const StepPlan plan = planSweep(input);
    DiscreteStep<VelocityVerlet> whole(scene, params, reporter, plan, dt);

    Ball before = loadBall(in);
    before.supported = whole.supports(before);
    Sweep sweep(input, reporter, plan, before);
    if (!sweep.leaveOverlaps()) return refuseStuck(before.position, err);
    for (uint32_t events = 0; !sweep.toNextEvent(); ++events) {
        if (events == kEventCap) return refuseEvents(err);
    }
    if (!sweep.leaveOverlaps()) return refuseStuck(before.position, err);

    const Ball &ball = sweep.ball();
    uint64_t flags = whole.supports(ball) ? 0 : PHYS_AIRBORNE;
    if (whole.rests(ball)) flags |= PHYS_AT_REST;
    if (&out != &in) std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    storeBall(scene, params, ball, flags, out);
    if (plan.runs(PHYS_STAGE_ORIENTATION)) turn(before.spin, dt, out);
    if (reporter.wanted()) reportTransitions(reporter, input, before, out);
    return PHYS_OK;
}

phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                 phys_report *report, phys_error *err) {
    Clearing &clearing = *static_cast<Clearing *>(self);
    const PlanInput input{clearing.scene(), *params, dt, *in};
    const bool glides = !report && (glide<VelocityVerlet, kRoomToGlide>(input, clearing, *out) ||
                                    glideElsewhere<VelocityVerlet, kRoomToGlide>(input, clearing, *out));
    return glides ? PHYS_OK : sweepStep(input, *out, report, err);
}

} // namespace

constinit const phys_stepper_api kSwept = {sizeof(phys_stepper_api),
                                           PHYS_STEPPER_BITS_EVERYWHERE,
                                           "swept",
                                           "Swept",
                                           "1",
                                           "Second order throughout: every impact is found, moved to and reflected "
                                           "inside the step.",
                                           nullptr,
                                           0,
                                           0,
                                           makeClearing,
                                           deleteClearing,
                                           step,
                                           requirements,
                                           nullptr};

} // namespace phys
