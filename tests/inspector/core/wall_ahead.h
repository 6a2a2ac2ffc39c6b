// SPDX-License-Identifier: MIT
// The scene of a bounce: a floor of 2 m, and a wall to the right of the ball's start.
#pragma once

#include "inspector/core/scenes.h"

namespace inspector {

// face: x of the wall's near side, m; height: m above the floor.
inline Scene wallAhead(double face, double height = 0.05) {
    return sceneOf({{{-1.0, -1.0, -0.01}, {1.0, 1.0, 0.0}}, {{face, -1.0, 0.0}, {face + 0.1, 1.0, height}}});
}

} // namespace inspector
