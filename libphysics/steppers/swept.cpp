// SPDX-License-Identifier: MIT
// Moves to the first impact inside the step, reflects, and continues with the rest: second order across impacts as
// well, and no tunnelling at any speed.
#include "base/text.h"
#include "discrete/schemes.h"
#include "discrete/stepper.h"
#include "discrete/swept_step.h"
#include "registry/built_in_steppers.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace phys {

namespace {

/// Sweeping replaces substeps, and the only rest rule is the one for slow bounces.
StepPlan planSweep(const PlanInput &input) {
    StepPlan plan = planStep(input, true);
    plan.asReported = false;
    plan.stages |= PHYS_STAGE_SUBSTEPS;
    return plan;
}

phys_status requirementsOfSwept(void *self, const phys_params *params, double dt, const phys_state *state,
                                phys_requirements *out, phys_error *) {
    const PlanInput input{static_cast<KnownPlaces *>(self)->scene(), *params, dt, *state};
    describePlan(input, planSweep(input), *out);
    char(&substeps)[120] = out->reasons[std::countr_zero(static_cast<uint32_t>(PHYS_STAGE_SUBSTEPS))];
    writeText(substeps, sizeof substeps, "always: the way of the whole step is searched for impacts");
    return PHYS_OK;
}

phys_status sweepStep(const PlanInput &input, phys_state &out, phys_report *report, phys_error *err) {
    const double dt = input.dt;
    const phys_state &in = input.state;
    Reporter reporter(report, in, dt);
    reporter.substeps(1, 0);
    const StepPlan plan = planSweep(input);
    Work work(kMostWork);
    const StepContext context{SweptStep::settingOf(input), reporter, work};
    DiscreteStep<VelocityVerlet> whole(context.setting, reporter, work, plan, dt);

    Ball before = loadBall(in);
    if (!leaveOverlaps(context, before)) return refuseStuck(before.position, err);
    if (before.velocity == Vec3(0.0) && whole.rests(before)) {
        finishStep(whole, input, before, before, plan, reporter, out);
        storeOrientation(input, plan, before.spin, out);
        return PHYS_OK;
    }
    if (reporter.wanted()) before.supported = whole.supports(before);
    SweptStep sweep(input, reporter, work, plan, before);
    for (uint32_t counted = 0; !sweep.toNextEvent(); counted = sweep.effort()) {
        const Vec3 &p = sweep.ball().position;
        const size_t boxes = input.scene.boxesNear(p.x, p.y, input.scene.hasManyBoxes).size();
        work.add(Work::kEvent + (sweep.effort() - counted) * Work::kPlace + boxes);
        if (work.isTooMuch()) return refuseWork(PHYS_ERROR_EVENT_CAP, err);
    }
    Ball ball = sweep.ball();
    if (!leaveOverlaps(context, ball)) return refuseStuck(before.position, err);
    finishStep(whole, input, before, ball, plan, reporter, out);
    std::copy(std::begin(sweep.orientation()), std::end(sweep.orientation()), out.orientation);
    return PHYS_OK;
}

phys_status stepSwept(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                      phys_report *report, phys_error *err) {
    const PlanInput input{static_cast<KnownPlaces *>(self)->scene(), *params, dt, *in};
    return sweepStep(input, *out, report, err);
}

} // namespace

constinit const phys_stepper_api kSwept = {sizeof(phys_stepper_api),
                                           PHYS_STEPPER_BITS_EVERYWHERE,
                                           "swept",
                                           "Swept",
                                           "18",
                                           "Second order throughout: every impact is found, moved to and reflected "
                                           "inside the step.",
                                           nullptr,
                                           0,
                                           0,
                                           makePlaces,
                                           deletePlaces,
                                           stepSwept,
                                           requirementsOfSwept,
                                           LaneStepper<VelocityVerlet, RegionRule::Swept>::extension};

} // namespace phys
