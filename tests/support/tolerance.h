// SPDX-License-Identifier: MIT
// The accuracy that each stepper promises, and the tolerances that follow from it. Each number has a reason.
#pragma once

#include "support/orders.h"

#include <QByteArray>

#include <cmath>

namespace support {

/// One rounding of a double, relative: 2^-53 either way.
inline constexpr double kUnit = 1.1102230246251565e-16;

/// Rounding error of `operations` operations on numbers up to `size`, if all roundings go in the same direction.
inline double rounding(double operations, double size) { return operations * kUnit * size; }

/// Beside its orders.
struct Promise : Orders {
    bool heats;   ///< gains energy in lasting contact (10.3)
    bool inSteps; ///< divides the step into substeps if the speed requires it
};

/// An unknown stepper is held to what the crudest one promises.
inline Promise promiseOf(const QByteArray &stepper) {
    const Orders orders = ordersOf({stepper.constData(), static_cast<size_t>(stepper.size())});
    if (stepper == "exact" || stepper == "swept") return {orders, false, false};
    const bool isStable = stepper == "rk4" || stepper == "velocity-verlet" || stepper == "symplectic-euler";
    return {orders, !isStable, true};
}

} // namespace support
