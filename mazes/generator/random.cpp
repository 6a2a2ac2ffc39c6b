// SPDX-License-Identifier: MIT
#include "generator/random.h"

#include <limits>

namespace mazes {

std::uint64_t Random::next() {
    m_state += 0x9E3779B97F4A7C15U;
    std::uint64_t mixed = m_state;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31);
}

std::size_t Random::below(std::size_t bound) {
    // Draws above the last whole multiple of bound would favour the small remainders: draw again.
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t limit = largest - largest % bound;
    std::uint64_t drawn = next();
    while (drawn >= limit) drawn = next();
    return static_cast<std::size_t>(drawn % bound);
}

} // namespace mazes
