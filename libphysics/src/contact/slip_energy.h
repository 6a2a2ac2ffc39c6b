// SPDX-License-Identifier: MIT
// The friction impulses of one moment: of all within Coulomb's cones, those that leave the least energy, model.md 13.2.
#pragma once

#include "contact/contact.h"
#include "contact/work.h"

#include <span>

namespace phys {

/// A contact whose friction may be any vector across the normal of length up to `most`.
struct FrictionDisc {
    Vec3 normal;
    double most; ///< m/s: impulse per mass
    Vec3 impulse;
};

/// Finds the impulses and applies them. The minimum is unique and so independent of the order. If the work limit is
/// exceeded, it stops early; energy has only fallen then.
void minimiseSlipEnergy(std::span<FrictionDisc> discs, double radius, Motion &motion, Work &work);

} // namespace phys
