// SPDX-License-Identifier: MIT
// What isn't a number like others.
#pragma once

#include <limits>

namespace support {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace support
