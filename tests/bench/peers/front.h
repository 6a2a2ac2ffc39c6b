// SPDX-License-Identifier: MIT
// Evaluates trials: which engine is cheapest for a given error, and where ours isn't.
#pragma once

#include "peers/trial.h"

namespace bench {

// All trials of a group, in the order in which they were measured.
std::vector<const Trial *> trialsOf(const std::vector<Trial> &trials, const std::string &group);

// The Pareto front: trials that no other trial of the group beats in both cost and median error, from cheap to
// expensive.
std::vector<const Trial *> paretoFront(const std::vector<Trial> &trials, const std::string &group);

enum class Side { Ours, Peers };

// The cheapest trial of this side whose error stays below `bound` radii in every scene of the group; nullptr if there
// is none.
const Trial *cheapestUnder(const std::vector<Trial> &trials, const std::string &group, double bound, Side side);

// Peers' trials for which none of ours is at least as cheap and at least as accurate.
std::vector<const Trial *> unbeatenPeers(const std::vector<Trial> &trials, const std::string &group);

} // namespace bench
