// SPDX-License-Identifier: MIT
// Random scenes that no maze designer would make, by kinds, each from a number.
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

/// A simpler one for convergence: one gravity per leg, some tenths of a second, coefficients and speeds of real balls.
Case drawSmoothCase(size_t kind, uint64_t seed, uint32_t model);

} // namespace witness
