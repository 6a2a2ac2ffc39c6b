// SPDX-License-Identifier: MIT
// Answers from trials: who is cheapest for an error, and where ours is not.
#pragma once

#include "peers/trial.h"

namespace bench {

// All trials of a group, in the order in which they were measured.
std::vector<const Trial *> trialsOf(const std::vector<Trial> &trials, const std::string &group);

// Those that no other trial of the group beats in both cost and median error, from cheap to dear.
std::vector<const Trial *> paretoFront(const std::vector<Trial> &trials, const std::string &group);

enum class Side { Ours, Peers };

// The cheapest trial of that side whose error stays under `bound` radii in every scene of the group; nullptr if none.
const Trial *cheapestUnder(const std::vector<Trial> &trials, const std::string &group, double bound, Side side);

// Peers' trials for which ours has none that is at least as cheap and at least as accurate.
std::vector<const Trial *> unbeatenPeers(const std::vector<Trial> &trials, const std::string &group);

} // namespace bench
