// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace mazes {

// Nanometres. User input is in whole micrometres, so halves of it are whole numbers here and every coordinate is exact.
using Length = std::int64_t;

inline constexpr Length kMicrometre = 1'000;
inline constexpr Length kMillimetre = 1'000'000;

} // namespace mazes
