// SPDX-License-Identifier: MIT
// The accuracy that each stepper promises, and the tolerances that follow from it. Each number has a reason.
#pragma once

#include <QByteArray>

#include <cmath>

namespace support {

/// One rounding of a double, relative: 2^-53 either way.
inline constexpr double kUnit = 1.1102230246251565e-16;

/// Rounding error of `operations` operations on numbers up to `size`, if all roundings go in the same direction.
inline double rounding(double operations, double size) { return operations * kUnit * size; }

/// Orders of model.md 10.1 and 10.2: the error is proportional to dt to this power. 0: rounding only.
struct Promise {
    int smooth;   ///< while nothing is touched and resistance doesn't stop the ball
    int impacts;  ///< across impacts: an envelope, not a ratio (10.2)
    bool heats;   ///< gains energy in lasting contact (10.3)
    bool inSteps; ///< divides the step into substeps if the speed requires it
};

/// An unknown stepper is held to what the crudest one promises.
inline Promise promiseOf(const QByteArray &stepper) {
    if (stepper == "exact") return {0, 0, false, false};
    if (stepper == "swept") return {2, 2, false, false};
    if (stepper == "rk4") return {4, 1, false, true};
    if (stepper == "velocity-verlet") return {2, 1, false, true};
    if (stepper == "symplectic-euler") return {1, 1, false, true};
    return {1, 1, true, true};
}

} // namespace support
