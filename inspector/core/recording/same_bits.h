// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <type_traits>

namespace inspector {

/// Compares bits, unlike ==: 0 and -0 differ. For types without padding.
template<class Plain>
bool isSameBits(const Plain &a, const Plain &b) {
    static_assert(std::is_trivially_copyable_v<Plain>);
    return std::memcmp(&a, &b, sizeof a) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

} // namespace inspector
