// SPDX-License-Identifier: MIT
// One ball in one random maze under one stepper and a tilt that turns at random, checked at every step.
#pragma once

#include <physics/physics.h>

#include <cstdint>
#include <string>

namespace soak {

/// What one trial came to; `problem` is empty if every step kept every invariant.
struct Outcome {
    uint64_t steps = 0;
    uint64_t impacts = 0;
    uint64_t hash = 0;       ///< of all its states
    double deepest = 0.0;    ///< in a wall at the end of a step, m
    double mostGained = 0.0; ///< by one step, J/kg
    double fastest = 0.0;    ///< m/s
    std::string declined;    ///< what a step that this stepper can't do says, which ended it: UNSUPPORTED, EVENT_CAP
    std::string problem;
};

/// What a trial follows from: the same for the same numbers.
struct Plan {
    const phys_registry *registry; ///< that has the stepper
    uint64_t seed;
    std::string stepper;
    uint32_t model;
    uint64_t steps;
};

Outcome run(const Plan &plan);

/// "PHYS_MODEL_RIGID, stepper rk4, seed 7"
std::string describe(const Plan &plan);

} // namespace soak
