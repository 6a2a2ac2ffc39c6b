// SPDX-License-Identifier: MIT
// What each stepper promises, and how far a result may be from the truth because of it. Each number has a reason.
#pragma once

#include <QByteArray>

#include <cmath>

namespace support {

/// One rounding of a double, relative: 2^-53 either way.
inline constexpr double kUnit = 1.1102230246251565e-16;

/// Rounding after `operations` roundings of numbers up to `size`: they may all go one way.
inline double rounding(double operations, double size) { return operations * kUnit * size; }

/// Orders of model.md 10.1 and 10.2: the error goes like dt to this power. 0: none but rounding.
struct Promise {
    int smooth;   ///< while nothing is touched and resistance doesn't stop the ball
    int impacts;  ///< across impacts: an envelope, not a ratio (10.2)
    bool heats;   ///< gains energy in lasting contact (10.3)
    bool inSteps; ///< cuts the step into substeps when the speed calls for it
};

/// An unknown stepper promises what the crudest one does.
inline Promise promiseOf(const QByteArray &stepper) {
    if (stepper == "exact") return {0, 0, false, false};
    if (stepper == "swept") return {2, 2, false, false};
    if (stepper == "rk4") return {4, 1, false, true};
    if (stepper == "velocity-verlet") return {2, 1, false, true};
    if (stepper == "symplectic-euler") return {1, 1, false, true};
    return {1, 1, true, true};
}

} // namespace support
