// SPDX-License-Identifier: MIT
// The orders of the steppers: the error is proportional to dt to this power, model.md 10.1, 10.2 and 13.5. The only
// place that knows them.
#pragma once

#include <string_view>

namespace support {

/// 0: rounding only.
struct Orders {
    int smooth;  ///< while nothing is touched and resistance doesn't stop the ball
    int lasting; ///< while contacts last
    int impacts; ///< across impacts: an envelope, not a ratio (10.2)
};

/// An unknown stepper is held to what the crudest one promises.
constexpr Orders ordersOf(std::string_view stepper) {
    if (stepper == "exact") return {0, 0, 0};
    if (stepper == "swept") return {2, 2, 2};
    if (stepper == "rk4") return {4, 2, 1};
    if (stepper == "velocity-verlet") return {2, 2, 1};
    return {1, 1, 1};
}

} // namespace support
