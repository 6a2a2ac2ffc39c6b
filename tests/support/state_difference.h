// SPDX-License-Identifier: MIT
// Names the member in which two states differ.
#pragma once

#include <physics/physics.h>

#include <array>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>

namespace support {

/// "velocity.x 0.10000000000000001, then 0.20000000000000001": of the first member whose bits differ; empty if none
/// does.
inline std::string firstDifference(const phys_state &first, const phys_state &second) {
    constexpr std::array<const char *, 16> kMembers = {
        "time",           "step",           "position.x",     "position.y", "position.z", "velocity.x",
        "velocity.y",     "velocity.z",     "spin.x",         "spin.y",     "spin.z",     "orientation[0]",
        "orientation[1]", "orientation[2]", "orientation[3]", "flags"};
    using Words = std::array<uint64_t, kMembers.size()>;
    const auto a = std::bit_cast<Words>(first), b = std::bit_cast<Words>(second);
    size_t i = 0;
    while (i < a.size() && a[i] == b[i]) ++i;
    if (i == a.size()) return {};
    std::array<char, 100> text{};
    if (i == 1 || i == a.size() - 1) {
        std::snprintf(text.data(), text.size(), "%s %" PRIu64 ", then %" PRIu64, kMembers[i], a[i], b[i]);
    } else {
        std::snprintf(text.data(), text.size(), "%s %.17g, then %.17g", kMembers[i], std::bit_cast<double>(a[i]),
                      std::bit_cast<double>(b[i]));
    }
    return text.data();
}

} // namespace support
