// SPDX-License-Identifier: MIT
// Merges flush boxes whose union is a box, so that the ball can't hit a seam between them (model.md 5.6).
#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace phys {

/// Merged boxes, and the numbers of the given ones that each consists of: parts[first[i] .. first[i + 1]), ascending.
struct Merged {
    std::vector<phys_box> boxes; ///< in ascending order of their lowest part
    std::vector<uint32_t> first, parts;
};

/// members: numbers of the boxes of `given` that may be merged with each other, ascending.
Merged mergeFlush(std::span<const phys_box> given, std::span<const uint32_t> members);

} // namespace phys
