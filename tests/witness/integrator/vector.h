// SPDX-License-Identifier: MIT
// Vectors of 64 bits of mantissa where long double has them.
#pragma once

#include <physics/physics.h>

#include <cmath>

namespace witness {

using Real = long double;

struct Vector {
    Real x = 0;
    Real y = 0;
    Real z = 0;

    Vector &operator+=(const Vector &b) { return *this = {x + b.x, y + b.y, z + b.z}; }
    Vector &operator-=(const Vector &b) { return *this = {x - b.x, y - b.y, z - b.z}; }
};

inline Vector operator+(const Vector &a, const Vector &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector &a, const Vector &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector &a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(Real s, const Vector &a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(const Vector &a, const Vector &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector &a, const Vector &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Vector &a) { return std::sqrt(dot(a, a)); }

/// The part of a across the unit vector n.
inline Vector across(const Vector &a, const Vector &n) { return a - dot(a, n) * n; }

/// a, shortened to `limit` if it is longer.
inline Vector clipped(const Vector &a, Real limit) {
    const Real size = length(a);
    return size > limit ? (limit / size) * a : a;
}

inline Vector vectorOf(const phys_vec3 &a) { return {a.x, a.y, a.z}; }
inline phys_vec3 rounded(const Vector &a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

} // namespace witness
