// SPDX-License-Identifier: MIT
// The stages that a step of fixed substeps needs: the plan for the step, and its description.
#pragma once

#include "floor_contact.h"
#include "scene/scene.h"

#include <cstdint>

namespace phys {

/// Steps that need more substeps are refused.
inline constexpr uint32_t kSubstepCap = 1'000'000;

/// Work limit of a step: some 0.3 s.
inline constexpr uint64_t kMostWork = 70'000'000;

/// The row that steppers of fixed substeps have of their own (stepper.h).
inline bool asReported(const phys_params &params) { return params.stepper[0] != 0.0; }

/// The stages and substeps of one step.
struct StepPlan {
    bool asReported; ///< textbook collisions: definition D of model.md 10 unmodified, without substeps
    uint32_t stages; ///< PHYS_STAGE_* bits
    double substeps; ///< 1, 2, ...; more than kSubstepCap: refused

    bool runs(uint32_t stage) const { return stages & stage; }
};

/// The inputs of a plan.
struct PlanInput {
    const Scene &scene;
    const phys_params &params;
    double dt;
    const phys_state &state;

    /// At the floor's height, neither rising nor landing. False if there is no floor, whose height is then NaN.
    bool isOnFloor() const {
        return std::abs(state.position.z - scene.supportedZ) <= scene.tolerance && state.velocity.z == 0.0;
    }

    /// The same, with the floor below it: beyond an edge there is nothing below. reach: also after moving by up to
    /// this, m.
    bool isCarried(double reach = 0.0) const {
        return isOnFloor() && scene.overFloor(state.position.x, state.position.y, reach);
    }

    /// Whether nothing can push a ball that rolls on the floor upwards.
    bool isPlanar() const {
        return scene.isPlanar() && (params.model == PHYS_MODEL_ROLLING || params.wall_friction == 0.0);
    }

    FloorContact contact() const {
        return floorContact(params, scene.radius, inPlane(state.velocity), toVec(state.spin));
    }
};

/// An upper bound of the ball's displacement in this step, m: model.md 10.4.
double reachOfStep(const PlanInput &input);

/// Whether the ball's path lies wholly outside the bounds of all boxes, as after a fall off the board.
bool passesBy(const PlanInput &input);

/// An upper bound of the ball's fall in this step, m.
inline double fallOfStep(const PlanInput &input) { return input.dt * input.dt * std::abs(input.params.gravity.z); }

/// Whether a supported ball may pass the floor's edge in a step that is long enough for a fall.
inline bool mayFallOffFloor(const PlanInput &input) {
    return fallOfStep(input) > 0.5 * input.scene.radius && input.isCarried() && !input.isCarried(reachOfStep(input));
}

/// No substep moves the ball by more than half its radius, so that it can't tunnel through anything; one is enough
/// where there is nothing to hit.
double substepsNeeded(const PlanInput &input);

/// A cheap test whether one substep is enough: then substepsNeeded is 1, unless mayFallOffFloor.
inline bool isSlow(const PlanInput &input) {
    if (!input.isOnFloor()) return false;
    const phys_vec3 &v = input.state.velocity;
    const phys_vec3 &g = input.params.gravity;
    const double friction = input.params.model == PHYS_MODEL_RIGID ? input.params.sliding_friction * g.z : 0.0;
    const double drive = std::abs(g.x) + std::abs(g.y) + std::abs(friction);
    const double safe = 0.5 * input.scene.radius;
    // The sum of components is never smaller than the length.
    const double reach = (std::abs(v.x) + std::abs(v.y) + drive * input.dt) * input.dt;
    if (reach > safe) return false;
    // A ball that has passed an edge falls, in short steps by too little to need substeps.
    return reach + std::abs(g.z) * input.dt * input.dt <= safe || input.isCarried();
}

/// Friction may turn this many radians of spin into a displacement of a quarter of the radius: 2/7 of it becomes speed.
inline constexpr double kSafeTurn = 0.875;

/// Whether a contact may turn spin into speed that the ball's speed doesn't account for; never for a slow ball that
/// rolls.
inline bool spinsFast(const PlanInput &input) {
    if (input.params.model != PHYS_MODEL_RIGID) return false;
    const Vec3 turn = input.dt * toVec(input.state.spin);
    return glm::dot(turn, turn) > kSafeTurn * kSafeTurn;
}

/// What PHYS_OPTION_ALL_STAGES forces: what depends on the scene. Slip depends on the model, orientation on an option.
inline constexpr uint32_t kForcibleStages =
    ((1U << PHYS_STAGE_COUNT) - 1U) & ~static_cast<uint32_t>(PHYS_STAGE_SLIP | PHYS_STAGE_ORIENTATION);

inline StepPlan planStep(const PlanInput &input, bool asReported) {
    const auto stage = [](bool runs, uint32_t bit) { return runs ? bit : 0U; };
    const phys_params &params = input.params;
    StepPlan plan{asReported, 0, 1.0};
    if (!asReported && (!isSlow(input) || spinsFast(input) || mayFallOffFloor(input)))
        plan.substeps = substepsNeeded(input);
    plan.stages = stage(!input.isOnFloor() || !input.isPlanar(), PHYS_STAGE_VERTICAL) |
                  stage(plan.substeps > 1.0, PHYS_STAGE_SUBSTEPS) |
                  stage(params.rolling_friction > 0.0, PHYS_STAGE_RESISTANCE) |
                  stage(input.contact() == FloorContact::Slips, PHYS_STAGE_SLIP) |
                  stage(input.scene.hasManyBoxes, PHYS_STAGE_GRID) |
                  stage(params.options & PHYS_OPTION_ORIENTATION, PHYS_STAGE_ORIENTATION);
    if (params.options & PHYS_OPTION_ALL_STAGES) plan.stages |= kForcibleStages;
    return plan;
}

/// Describes the plan.
void describePlan(const PlanInput &input, const StepPlan &plan, phys_requirements &out);

} // namespace phys
