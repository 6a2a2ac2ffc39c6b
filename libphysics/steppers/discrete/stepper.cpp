// SPDX-License-Identifier: MIT
#include "stepper.h"

#include "base/orientation.h"

#include <cstring>

namespace phys {

namespace {

constexpr phys_param_row kAsReported{"as_reported",
                                     "Textbook collisions",
                                     "",
                                     "1 collides as textbooks do: look once a step whatever the speed, push out, "
                                     "reflect. It shows what that leads to: tunnelling through walls, and jitter "
                                     "where the ball should rest. 0 has substeps and rules for rest. Default: 0.",
                                     "",
                                     0,
                                     1,
                                     0,
                                     1,
                                     0,
                                     1,
                                     static_cast<uint32_t>(offsetof(phys_params, stepper)),
                                     PHYS_ROW_SWITCH};

} // namespace

constinit const phys_param_row *const kDiscreteRows[1] = {&kAsReported};

void storeOrientation(const PlanInput &input, const StepPlan &plan, const Vec3 &spinBefore, phys_state &out) {
    if (&out != &input.state) std::memcpy(out.orientation, input.state.orientation, sizeof out.orientation);
    if (!plan.runs(PHYS_STAGE_ORIENTATION)) return;
    rotate(out.orientation, 0.5 * input.dt * (spinBefore + toVec(out.spin)));
}

void reportTransitions(Reporter &reporter, const PlanInput &input, const Ball &before, const phys_state &out) {
    const double speedBefore = glm::length(before.velocity);
    const double speedAfter = glm::length(toVec(out.velocity));
    const auto event = [&](uint32_t kind) {
        reporter.event(kind, input.dt, toVec(out.position), Vec3(0.0), speedBefore, speedAfter, PHYS_NO_BOX);
    };
    const bool slipped = input.params.model == PHYS_MODEL_RIGID && before.supported &&
                         !rolls(inPlane(before.velocity), before.spin, input.scene.radius);
    if (before.supported && (out.flags & PHYS_AIRBORNE)) event(PHYS_EVENT_TAKEOFF);
    if (slipped && !(out.flags & (PHYS_AIRBORNE | PHYS_SLIPPING))) event(PHYS_EVENT_ROLL);
    if (speedBefore > 0.0 && (out.flags & PHYS_AT_REST)) event(PHYS_EVENT_STOP);
}

phys_status makePlaces(const phys_scene_view *view, void **self, phys_error *) {
    *self = new KnownPlaces(*static_cast<const Scene *>(view->scene));
    return PHYS_OK;
}

void deletePlaces(void *self) { delete static_cast<KnownPlaces *>(self); }

phys_status refuseSubsteps(double substeps, phys_error *err) {
    return fail(err, PHYS_ERROR_SUBSTEP_CAP,
                "this step needs %.9g substeps of half a radius; at most %u are allowed: "
                "take a smaller dt",
                substeps, kSubstepCap);
}

phys_status refuseWork(phys_status status, phys_error *err) {
    return fail(err, status, "more to compute than %.9g in this step: take a smaller dt",
                static_cast<double>(kMostWork));
}

phys_status refuseStuck(const Vec3 &position, phys_error *err) {
    return fail(err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) overlaps boxes with no room for it between them",
                position.x, position.y, position.z);
}

} // namespace phys
