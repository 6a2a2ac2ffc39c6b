// SPDX-License-Identifier: MIT
// Limits of the numbers in a step.
#pragma once

#include "base/pair.h"

#include <physics/physics.h>

#include <cmath>

namespace phys {

/// 2^100: squares and products of smaller numbers, as they occur in a step, stay finite.
inline constexpr double kLargestNumber = 0x1p100;

/// False for NaN.
inline bool isModerate(double number) { return std::abs(number) <= kLargestNumber; }

inline bool isModerate(const phys_vec3 &v) { return isModerate(v.x) && isModerate(v.y) && isModerate(v.z); }

/// As many numbers side by side. False for NaN.
template<uint32_t kCount>
bool areModerate(const double *numbers) {
    static_assert(kCount % kWidth<Pair> == 0);
    MaskOf<Pair> areFine = magnitude(load<Pair>(numbers)) <= kLargestNumber;
    for (uint32_t i = kWidth<Pair>; i < kCount; i += kWidth<Pair>) {
        areFine = all(areFine, magnitude(load<Pair>(numbers + i)) <= kLargestNumber);
    }
    return areAll(areFine);
}

} // namespace phys
