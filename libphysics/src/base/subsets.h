// SPDX-License-Identifier: MIT
// All subsets of a few numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace phys {

/// Asks for each set of Size numbers below `count`, in lexicographic order, until one holds; false if none does. The
/// first `Chosen` ones are in `set`, the next one is at least `least`.
template<size_t Size, size_t Chosen = 0, class Holds>
bool anySubset(uint32_t count, const Holds &holds, uint32_t least = 0, std::array<uint32_t, Size> set = {}) {
    if constexpr (Chosen == Size) {
        return holds(set);
    } else {
        for (uint32_t next = least; next < count; ++next) {
            set[Chosen] = next;
            if (anySubset<Size, Chosen + 1>(count, holds, next + 1, set)) return true;
        }
        return false;
    }
}

} // namespace phys
