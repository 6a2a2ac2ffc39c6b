// SPDX-License-Identifier: MIT
#include "requirements.h"

#include "slip.h"

#include <cmath>
#include <cstdio>
#include <string_view>

namespace phys {

namespace {

/// Slip is part of the rigid model rather than of a scene: the rolling model has none to force.
constexpr uint32_t kForcible = ((1U << PHYS_STAGE_COUNT) - 1U) & ~PHYS_STAGE_SLIP;

bool isOnFloor(const Scene &scene, const phys_state &state) {
    return scene.hasFloor && std::abs(state.position.z - scene.supportedZ) <= scene.tolerance &&
           state.velocity.z <= 0.0;
}

/// Whether nothing can push a ball that rolls on the floor upwards.
bool isPlanar(const Scene &scene, const phys_params &params) {
    return scene.nonPlanarReason.empty() && (params.model == PHYS_MODEL_ROLLING || params.wall_friction == 0.0);
}

/// Upper bound of the ball's speed during the step, m/s: model.md 10.4.
double speedBound(const Scene &scene, const phys_params &params, double dt, const phys_state &state) {
    const Vec3 gravity = toVec(params.gravity);
    double drive = glm::length(isOnFloor(scene, state) ? Vec3(gravity.x, gravity.y, 0.0) : gravity);
    if (params.model == PHYS_MODEL_RIGID) drive += params.sliding_friction * std::abs(gravity.z);
    return glm::length(toVec(state.velocity)) + drive * dt;
}

/// Half a radius a substep: nothing is tunnelled through, model.md 10.4.
double substepsNeeded(const Scene &scene, double distance) {
    const double safe = 0.5 * scene.radius;
    return distance > safe && !scene.solids.empty() ? std::ceil(distance / safe) : 1.0;
}

bool slips(const Scene &scene, const phys_params &params, const phys_state &state) {
    if (params.model != PHYS_MODEL_RIGID) return false;
    const Ball ball{toVec(state.position), toVec(state.velocity), toVec(state.spin), true};
    return !rolls(ball, scene.radius) || !gripHolds(params);
}

template<class... Part>
void say(phys_requirements &out, int index, const char *format, Part... part) {
    std::snprintf(out.reasons[index], sizeof out.reasons[index], format, part...);
}

} // namespace

StepPlan planStep(const Scene &scene, const phys_params &params, double dt, const phys_state &state, Bounce bounce,
                  bool asReported) {
    const auto stage = [](bool runs, uint32_t bit) { return runs ? bit : 0U; };
    StepPlan plan{asReported ? Bounce::Plain : bounce, 0, 1.0};
    if (!asReported) plan.substeps = substepsNeeded(scene, speedBound(scene, params, dt, state) * dt);
    plan.stages = stage(!isOnFloor(scene, state) || !isPlanar(scene, params), PHYS_STAGE_VERTICAL) |
                  stage(plan.substeps > 1.0, PHYS_STAGE_SUBSTEPS) |
                  stage(params.rolling_friction > 0.0, PHYS_STAGE_RESISTANCE) |
                  stage(slips(scene, params, state), PHYS_STAGE_SLIP) | stage(scene.needsGrid(), PHYS_STAGE_GRID) |
                  stage(params.options & PHYS_OPTION_ORIENTATION, PHYS_STAGE_ORIENTATION);
    if (params.options & PHYS_OPTION_ALL_STAGES) plan.stages |= kForcible;
    return plan;
}

void describePlan(const Scene &scene, const phys_params &params, double dt, const phys_state &state,
                  const StepPlan &plan, phys_requirements &out) {
    out = phys_requirements{};
    out.stages = plan.stages;
    out.substeps = static_cast<uint32_t>(std::min(plan.substeps, 4294967295.0));

    say(out, 0, "%s",
        !isOnFloor(scene, state)  ? "the ball is not on the floor"
        : isPlanar(scene, params) ? "not needed: the floor carries the ball and walls push it sideways only"
                                  : "a low box or a rough wall can lift the ball off the floor");
    say(out, 1, "%sthe ball moves at most %.2g of its radius in this step; half a radius is safe",
        plan.substeps > 1.0 ? "" : "not needed: ", speedBound(scene, params, dt, state) * dt / scene.radius);
    say(out, 2, "%s",
        params.rolling_friction > 0.0 ? "rolling_friction is above 0" : "not needed: rolling_friction is 0");
    say(out, 3, "%s",
        params.model != PHYS_MODEL_RIGID ? "not needed: the rolling model has no slip"
        : slips(scene, params, state)    ? "the floor contact slips, or the slope is too steep for friction to hold it"
                                         : "not needed: the ball rolls, and friction holds it on this slope");
    say(out, 4, "%s",
        scene.needsGrid() ? "there are more than a handful of boxes"
                          : "not needed: for a handful of boxes looking at each is cheaper");
    say(out, 5, "%s",
        params.options & PHYS_OPTION_ORIENTATION ? "asked for by params.options"
                                                 : "not needed: params.options doesn't ask for it");
    if (!(params.options & PHYS_OPTION_ALL_STAGES)) return;
    for (int i = 0; i < PHYS_STAGE_COUNT; ++i) {
        const bool forced = out.stages >> i & 1U && std::string_view(out.reasons[i]).starts_with("not needed");
        if (forced) say(out, i, "forced by PHYS_OPTION_ALL_STAGES");
    }
}

} // namespace phys
