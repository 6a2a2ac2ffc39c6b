// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec.h"

namespace phys {

/// The moving part of a state.
struct Ball {
    Vec3 position;
    Vec3 velocity;
    Vec3 spin;
    bool supported; ///< by a floor: its height is a constraint then, not a bounce in each step
};

} // namespace phys
