// SPDX-License-Identifier: MIT
// Elementary functions made of + - x / and sqrt alone. Those of C libraries differ between systems, and some depend on
// the processor; these give the same bits wherever doubles are IEEE 754's.
//
// Each result is within one unit in the last place of the exact value (tests/unit/elementary/measure prints the
// errors). The method is always the same: the argument is reduced to a neighbour of a table entry, where a short Taylor
// polynomial suffices, and rounding errors are carried along as a tail.
#pragma once

namespace phys::elementary {

double exp(double x);
double expm1(double x);            ///< exp(x) - 1
double log(double x);              ///< of 0: -infinity; of less: NaN
double log1p(double x);            ///< log(1 + x)
double root(double x, int degree); ///< x >= 0, degree 1 .. 1000

/// Angles are reduced up to this one, rad; beyond it sine and cosine are NaN.
inline constexpr double kLargestAngle = 0x1p20;
double sin(double angle);
double cos(double angle);
double atan2(double y, double x); ///< zeros and quadrants as in C; both finite

double hypot(double x, double y); ///< without intermediate overflow or underflow; the same for (y, x)

} // namespace phys::elementary
