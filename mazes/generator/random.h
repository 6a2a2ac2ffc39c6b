// SPDX-License-Identifier: MIT
// Random draws that give the same numbers with every compiler and standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mazes {

// SplitMix64. The distributions and std::shuffle of <random> and <algorithm> may differ between standard libraries, so
// the draws made from it are written here too.
class Random {
public:
    explicit Random(std::uint64_t seed)
        : m_state(seed) {}

    std::uint64_t next();

    // Uniform in [0, bound); bound > 0.
    std::size_t below(std::size_t bound);

private:
    std::uint64_t m_state;
};

template<typename T>
void shuffle(std::vector<T> &items, Random &random) {
    for (std::size_t left = items.size(); left > 1; --left) std::swap(items[left - 1], items[random.below(left)]);
}

} // namespace mazes
