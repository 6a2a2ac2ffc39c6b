// SPDX-License-Identifier: MIT
// Who computes which job: rank 0 hands them out one by one, the others ask for more until there are none.
#pragma once

#include "roll.h"

#include <functional>

namespace sweep {

/// Called on rank 0 for each job, in the order in which they end; rank: which one computed it.
using Listener = std::function<void(const Outcome &outcome, int rank)>;

/// Computes all jobs; called by all ranks. A single rank computes them itself.
void computeAll(const Plan &plan, const Listener &listener);

} // namespace sweep
