// SPDX-License-Identifier: MIT
// One ball in one random maze under one stepper and a randomly changing tilt, checked at every step.
#pragma once

#include <physics/physics.h>

#include <cstdint>
#include <string>

namespace soak {

/// The result of one trial; `problem` is empty if every step kept every invariant.
struct Outcome {
    uint64_t steps = 0;
    uint64_t impacts = 0;
    uint64_t hash = 0;       ///< of all its states
    double deepest = 0.0;    ///< in a wall at the end of a step, m
    double mostGained = 0.0; ///< by one step, J/kg
    double fastest = 0.0;    ///< m/s
    std::string declined; ///< message of a step that the stepper refused, which ended the trial: UNSUPPORTED, EVENT_CAP
    std::string problem;
};

/// The inputs of a trial, which determine its result.
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
