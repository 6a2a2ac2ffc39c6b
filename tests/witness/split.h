// SPDX-License-Identifier: MIT
// Divides a step: a stepper without a step-size error comes to the same position either way.
#pragma once

#include "integrator/vector.h"

#include <optional>
#include <vector>

namespace witness {

struct SplitDifference {
    double apart;                  ///< m between the two ends
    double spread;                 ///< m by which the end moves if the start is off by 1e-12
    std::vector<phys_vec3> places; ///< of the ball at the start, after each part, and after the whole
};

/// Compares the step from `in` by dt with three parts of it. Empty if a part fails, or if the scene amplifies a
/// disturbance so much that no statement is possible.
std::optional<SplitDifference> splitDifference(phys_stepper *stepper, const phys_params &params, double dt,
                                               const phys_state &in, double radius);

} // namespace witness
