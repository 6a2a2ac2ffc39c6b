// SPDX-License-Identifier: MIT
#include "requirements.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace phys {

namespace {

template<class... Part>
void say(phys_requirements &out, int index, const char *format, Part... part) {
    writeText(out.reasons[index], sizeof out.reasons[index], format, part...);
}

/// Whether the ball rolls on the only box, a floor, and stays on it.
bool staysOnOneFloor(const PlanInput &input, double reach) {
    if (!input.isOnFloor() || input.scene.boxes.size() != 1) return false;
    const phys_box &floor = input.scene.boxes.front();
    const phys_vec3 &p = input.state.position;
    return Scene::isOver(floor, p.x - reach, p.y - reach) && Scene::isOver(floor, p.x + reach, p.y + reach);
}

/// reachOfStep with the fall: whatever can lift a ball off the floor, and the floor's edge, can let it fall within a
/// long step. leaves: whether it may pass that edge.
double wayOfStep(const PlanInput &input, bool leaves) {
    const double reach = reachOfStep(input);
    return leaves || !input.isPlanar() ? reach + fallOfStep(input) : reach;
}

void saySubsteps(const PlanInput &input, double substeps, phys_requirements &out) {
    const double reach = reachOfStep(input) / input.scene.radius;
    if (substeps == 1.0)
        return say(out, 1, "not needed: the ball moves at most %.2g of its radius in this step; half a radius is safe",
                   reach);
    if (spinsFast(input) && reach <= 0.5)
        return say(out, 1, "%s", "friction may turn the ball's spin into a way of more than a quarter of its radius");
    if (reach <= 0.5)
        return say(out, 1, "%s",
                   "the ball may come over the floor's edge, and fall by more than half a radius in this step");
    say(out, 1, "the ball moves at most %.2g of its radius in this step; half a radius is safe",
        wayOfStep(input, mayFallOffFloor(input)) / input.scene.radius);
}

} // namespace

bool passesBy(const PlanInput &input) {
    const Vec3 from = toVec(input.state.position);
    const Vec3 to = from + input.dt * toVec(input.state.velocity);
    // Twice what gravity can add, and the ball's size.
    const double margin = input.scene.radius + input.dt * input.dt * glm::length(toVec(input.params.gravity));
    const Vec3 low = glm::min(from, to) - margin;
    const Vec3 high = glm::max(from, to) + margin;
    const phys_box &bounds = input.scene.bounds;
    return low.x > bounds.max.x || high.x < bounds.min.x || low.y > bounds.max.y || high.y < bounds.min.y ||
           low.z > bounds.max.z || high.z < bounds.min.z;
}

double reachOfStep(const PlanInput &input) {
    const phys_params &params = input.params;
    const Vec3 gravity = toVec(params.gravity);
    const double drive = glm::length(input.isCarried() ? Vec3(gravity.x, gravity.y, 0.0) : gravity);
    double speed = glm::length(toVec(input.state.velocity)) + drive * input.dt;
    if (params.model == PHYS_MODEL_RIGID) {
        // The floor's friction adds at most 2/7 of the slip that it removes as speed.
        const double slip = speed + input.scene.radius * glm::length(toVec(input.state.spin));
        speed += std::min(params.sliding_friction * std::abs(gravity.z) * input.dt, 2.0 / 7.0 * slip);
    }
    return speed * input.dt;
}

double substepsNeeded(const PlanInput &input) {
    const Scene &scene = input.scene;
    const double safe = 0.5 * scene.radius;
    const double reach = reachOfStep(input);
    if (scene.boxes.empty() || staysOnOneFloor(input, reach) || passesBy(input)) return 1.0;
    const bool leaves = mayFallOffFloor(input);
    const double way = wayOfStep(input, leaves);
    const double forWay = (leaves ? way : reach) <= safe ? 1.0 : std::ceil(way / safe);
    const double spin = glm::length(toVec(input.state.spin));
    return spinsFast(input) ? std::max(forWay, std::ceil(spin * input.dt / kSafeTurn)) : forWay;
}

void describePlan(const PlanInput &input, const StepPlan &plan, phys_requirements &out) {
    const Scene &scene = input.scene;
    const phys_params &params = input.params;
    out = phys_requirements{};
    out.stages = plan.stages;
    out.substeps = static_cast<uint32_t>(std::min(plan.substeps, 4294967295.0));

    say(out, 0, "%s",
        !input.isOnFloor() ? "the ball is not on the floor"
        : input.isPlanar() ? "not needed: the floor carries the ball and walls push it sideways only"
                           : "a low box or a rough wall can lift the ball off the floor");
    saySubsteps(input, plan.substeps, out);
    say(out, 2, "%s",
        params.rolling_friction > 0.0 ? "rolling_friction is above 0" : "not needed: rolling_friction is 0");
    say(out, 3, "%s",
        params.model != PHYS_MODEL_RIGID ? "not needed: the rolling model has no slip"
        : input.contact() == FloorContact::Slides
            ? "not needed: without sliding_friction the spin has no part in the motion"
        : input.contact() == FloorContact::Slips
            ? "the floor contact slips, or the slope is too steep for friction to hold it"
            : "not needed: the ball rolls, and friction holds it on this slope");
    say(out, 4, "%s",
        scene.hasManyBoxes ? "there are more than a handful of boxes"
                           : "not needed: for a handful of boxes looking at each is cheaper");
    say(out, 5, "%s",
        params.options & PHYS_OPTION_ORIENTATION ? "asked for by params.options"
                                                 : "not needed: params.options doesn't ask for it");
    if (!(params.options & PHYS_OPTION_ALL_STAGES)) return;
    for (int i = 0; i < PHYS_STAGE_COUNT; ++i) {
        const bool forced = out.stages >> i & 1U && std::string_view(out.reasons[i]).starts_with("not needed");
        if (forced) say(out, i, "%s", "forced by PHYS_OPTION_ALL_STAGES");
    }
}

} // namespace phys
