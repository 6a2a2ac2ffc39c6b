// SPDX-License-Identifier: MIT
// Runs one case under one stepper and checks at every step the invariants of any motion.
#pragma once

#include "case.h"

#include <string>

namespace witness {

/// The result of a run; `check` names the invariant that failed first, and is empty if all held.
struct Verdict {
    std::string check;
    std::string what;
    uint64_t step = 0;            ///< at which it failed, or the first refused step
    phys_status status = PHYS_OK; ///< the first one other than PHYS_OK
    std::string statusText;
    uint64_t steps = 0;      ///< done
    uint32_t substeps = 0;   ///< most in a step
    uint64_t events = 0;     ///< most in a step
    double seconds = 0.0;    ///< longest step; informative only
    double energyRise = 0.0; ///< most in a step, of (|g| dt)^2
};

/// The names that Verdict::check can have.
const std::vector<std::string> &checkNames();

Verdict examine(const phys_registry *registry, const std::string &stepper, const Case &scene);

} // namespace witness
