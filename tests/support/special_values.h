// SPDX-License-Identifier: MIT
// NaN and infinities.
#pragma once

#include <limits>

namespace support {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace support
