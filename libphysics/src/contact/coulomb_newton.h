// SPDX-License-Identifier: MIT
// Coulomb's law of all lasting contacts by Newton's method, where one contact at a time comes to the answer too slowly:
// model.md 13.5.
#pragma once

#include "contact/lasting.h"

#include <span>

namespace phys {

/// What the contacts of one ball are in while their equations are solved.
struct CoulombProblem {
    std::span<Lasting> contacts;
    double radius;
    double rollingFriction; ///< 0: nothing resists
    double negligible;      ///< m/s
    Work &work;
};

/// Improves the impulses and the motion that they made, which must fit each other, until Coulomb's law holds for all.
/// False, and nothing changed, if that comes to no end.
bool solveCoulomb(const CoulombProblem &problem, Motion &motion);

} // namespace phys
