// SPDX-License-Identifier: MIT
// The shortest vector whose components along given normals have given lower bounds: model.md 13.2.
#pragma once

#include "base/vec.h"
#include "contact/work.h"

#include <span>

namespace phys {

/// A lower bound on the vector's component along a contact's normal.
struct Push {
    Vec3 normal;         ///< unit
    double wanted;       ///< lower bound of the component along it
    double amount = 0.0; ///< the solution, >= 0: the vector is the sum of amount * normal
};

/// Solves the linear complementarity problem: amounts >= 0 whose sum satisfies every bound, each 0 where its bound is
/// exceeded. At most three are positive. Returns the sum. negligible: what counts as rounding. If no vector satisfies
/// all bounds (opposite normals), or the work limit is reached, the amounts are meaningless.
Vec3 leastPush(std::span<Push> pushes, double negligible, Work &work);

} // namespace phys
