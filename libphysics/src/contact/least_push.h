// SPDX-License-Identifier: MIT
// The shortest vector that has at least given parts along given normals: model.md 13.2.
#pragma once

#include "base/vec.h"
#include "contact/work.h"

#include <span>

namespace phys {

/// A part of the vector along a contact's normal.
struct Push {
    Vec3 normal;         ///< unit
    double wanted;       ///< least part along it
    double amount = 0.0; ///< the answer, >= 0: how much of the vector this contact makes
};

/// Finds the amounts, none negative, whose sum has every part that is wanted and of which none pushes more than it
/// must: a linear complementarity problem, at most three normals make its answer. Returns the sum. negligible: what
/// counts as rounding. Where no vector has all parts (opposite normals) the amounts are of no use,
/// nor once the work is too much.
Vec3 leastPush(std::span<Push> pushes, double negligible, Work &work);

} // namespace phys
