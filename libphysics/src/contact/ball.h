// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec.h"

namespace phys {

/// The part of a state that moves.
struct Ball {
    Vec3 position;
    Vec3 velocity;
    Vec3 spin;
    bool supported; ///< by a floor: its height is then a constraint instead of a bounce in each step
};

/// J/kg
inline double spinEnergy(const Vec3 &spin, double radius) { return 0.2 * radius * radius * glm::dot(spin, spin); }

} // namespace phys
