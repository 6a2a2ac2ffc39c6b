// SPDX-License-Identifier: MIT
// The point of one box nearest to the ball.
#pragma once

#include "vector.h"

namespace witness {

struct Touch {
    Vector normal;      ///< unit, from the box to the centre
    Real gap = 0;       ///< distance of the ball's surface, negative inside
    int codes = 0;      ///< axes along which the centre lies beside the box: 1 face, 2 edge, 3 corner, 0 inside
    bool isTop = false; ///< on the box's top face
};

Touch touchOf(const phys_box &box, const Vector &centre, Real radius);

} // namespace witness
