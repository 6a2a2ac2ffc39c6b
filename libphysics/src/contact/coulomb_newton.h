// SPDX-License-Identifier: MIT
// Coulomb's law of all lasting contacts by Newton's method, for cases in which sweeps over the contacts converge too
// slowly: model.md 13.5.
#pragma once

#include "contact/lasting.h"

#include <span>

namespace phys {

/// What is constant while the equations of a ball's contacts are solved.
struct CoulombProblem {
    std::span<Lasting> contacts;
    double radius;
    double rollingFriction; ///< 0: no resistance
    double negligible;      ///< m/s
    Work &work;
};

/// Improves the impulses and the motion that results from them, which must be consistent, until Coulomb's law holds for
/// all contacts. If that doesn't converge, returns false and changes nothing.
bool solveCoulomb(const CoulombProblem &problem, Motion &motion);

} // namespace phys
