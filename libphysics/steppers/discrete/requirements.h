// SPDX-License-Identifier: MIT
// Which stages a step of fixed substeps needs: the plan it runs by, and the same in words.
#pragma once

#include "surroundings.h"

#include <cstdint>

namespace phys {

/// More substeps than this in one step are refused.
inline constexpr uint32_t kSubstepCap = 10'000;

/// What one step runs.
struct StepPlan {
    Bounce bounce;
    uint32_t stages; ///< PHYS_STAGE_* bits
    double substeps; ///< 1, 2, ...; more than kSubstepCap: refused

    bool runs(uint32_t stage) const { return stages & stage; }
};

/// bounce: the stepper's own; asReported: without cures and without substeps (definition D of model.md 10 as it is).
StepPlan planStep(const Scene &scene, const phys_params &params, double dt, const phys_state &state, Bounce bounce,
                  bool asReported);

/// The plan in words.
void describePlan(const Scene &scene, const phys_params &params, double dt, const phys_state &state,
                  const StepPlan &plan, phys_requirements &out);

} // namespace phys
