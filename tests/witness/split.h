// SPDX-License-Identifier: MIT
// A step in parts: a stepper that makes no error of its step size comes to the same place either way.
#pragma once

#include "integrator/vector.h"

#include <optional>
#include <vector>

namespace witness {

struct SplitDifference {
    double apart;                  ///< m between the two ends
    double spread;                 ///< m that the end moves if the start is off by a million millionth
    std::vector<phys_vec3> places; ///< of the ball at the start, after each part, and after the whole
};

/// The step from `in` by dt against three parts of it. Empty if a part is refused, or if the scene amplifies a
/// disturbance so much that nothing can be said.
std::optional<SplitDifference> splitDifference(phys_stepper *stepper, const phys_params &params, double dt,
                                               const phys_state &in, double radius);

} // namespace witness
