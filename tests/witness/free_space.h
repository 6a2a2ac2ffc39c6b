// SPDX-License-Identifier: MIT
// Whether a path of bounded length leads from one position of the ball's centre to another without passing through a
// box.
#pragma once

#include "integrator/vector.h"

#include <array>
#include <span>
#include <vector>

namespace witness {

/// Regions that the centre can't enter: each box enlarged by the ball. These are boxes inside that shape, so that a
/// region they separate is indeed separated: enlarged along one axis by R, along two by R/sqrt 2, along three by R/sqrt
/// 3; less a margin for rounding.
class FreeSpace {
public:
    FreeSpace(std::span<const phys_box> boxes, double radius);

    /// False if every path from a to b of length up to `reach` passes through a box.
    bool isReachable(const phys_vec3 &a, const phys_vec3 &b, double reach) const;

private:
    using Triple = std::array<double, 3>;
    struct Block {
        Triple low;
        Triple high;
    };

    bool isStraightWayFree(const Triple &a, const Triple &b) const;
    bool isFlooded(const Triple &a, const Triple &b, double reach) const;

    std::vector<Block> m_blocks;
};

} // namespace witness
