// SPDX-License-Identifier: MIT
// The table of parameter rows, and the check of parameters that every step makes.
#pragma once

#include <physics/physics.h>

#include <span>

namespace phys {

/// Whether all values are within their rows and agree with each other; the hot path's yes or no.
bool paramsAreValid(const phys_params &params);

/// As paramsAreValid, with the reason.
phys_status explainParams(const phys_params &params, phys_error *err);

/// Checks the values that a stepper's own rows stand for.
phys_status checkOwnRows(const phys_params &params, std::span<const phys_param_row *const> rows, phys_error *err);

} // namespace phys
