// SPDX-License-Identifier: MIT
// Flush boxes that together are one box become one: no seam is left to bump into (model.md 5.6).
#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace phys {

/// Merged boxes, and for each the numbers of the given ones it was made of: parts[first[i] .. first[i + 1]), ascending.
struct Merged {
    std::vector<phys_box> boxes; ///< in ascending order of their lowest part
    std::vector<uint32_t> first, parts;
};

/// members: numbers of the boxes of `given` to merge among each other, ascending.
Merged mergeFlush(std::span<const phys_box> given, std::span<const uint32_t> members);

} // namespace phys
