// SPDX-License-Identifier: MIT
// Scenes that no maze maker draws, by kinds, each from a number.
#pragma once

#include "case.h"

#include <cstdint>
#include <string>
#include <vector>

namespace witness {

/// Names of the kinds, in a fixed order: "boxes", "notch", "gap", ...
const std::vector<std::string> &kinds();

/// The scene of this number. kind: index in kinds().
Case drawCase(size_t kind, uint64_t seed, uint32_t model);

/// A tamer one for convergence: one gravity a leg, some tenths of a second, coefficients and speeds of real balls.
Case drawSmoothCase(size_t kind, uint64_t seed, uint32_t model);

} // namespace witness
