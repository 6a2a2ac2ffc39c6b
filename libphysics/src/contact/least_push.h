// SPDX-License-Identifier: MIT
// The least sum of pushes along given normals whose components have given lower bounds: model.md 13.2.
#pragma once

#include "base/vec.h"
#include "contact/work.h"

#include <optional>
#include <span>

namespace phys {

/// A push, and a lower bound on a component of the sum of all pushes.
struct Push {
    Push() {} // of a list's unused places
    Push(const Vec3 &along, double least)
        : Push(along, least, along) {}
    Push(const Vec3 &along, double least, const Vec3 &bounded)
        : normal(along)
        , limit(bounded)
        , wanted(least)
        , amount(0.0) {}

    Vec3 normal;   ///< unit: along which it pushes
    Vec3 limit;    ///< along which the sum is bounded: limit . normal = 1
    double wanted; ///< lower bound of limit . sum
    double amount; ///< the solution, >= 0: the sum is that of amount * normal
};

/// Solves the linear complementarity problem: amounts >= 0 whose sum satisfies every bound, each 0 where its bound is
/// exceeded. At most three are positive; of several such solutions it takes the one with the least sum of amounts.
/// Returns the sum of the pushes. negligible: what counts as rounding. If no vector satisfies all bounds (opposite
/// normals), or the work limit is reached, the amounts are meaningless.
Vec3 leastPush(std::span<Push> pushes, double negligible, Work &work);

/// The same; nothing where the amounts of any three pushes don't fit, as rounding keeps those of nearly parallel or
/// opposite normals from it, or as there is no solution. The amounts are meaningless then.
std::optional<Vec3> leastPushOfFew(std::span<Push> pushes, double negligible, Work &work);

} // namespace phys
