// SPDX-License-Identifier: MIT
// How large the numbers of a step may be.
#pragma once

#include <physics/physics.h>

#include <cmath>

namespace phys {

/// 2^100: squares and products of numbers below it, as a step makes them, stay finite.
inline constexpr double kLargestNumber = 0x1p100;

/// False for NaN.
inline bool isModerate(double number) { return std::abs(number) <= kLargestNumber; }

inline bool isModerate(const phys_vec3 &v) { return isModerate(v.x) && isModerate(v.y) && isModerate(v.z); }

} // namespace phys
