// SPDX-License-Identifier: MIT
#include "base/orientation.h"

#include <cmath>

namespace phys {

namespace {

struct Quaternion {
    Vec3 vector;
    double scalar;
};

Quaternion multiply(const Quaternion &a, const Quaternion &b) {
    return {a.scalar * b.vector + b.scalar * a.vector + glm::cross(a.vector, b.vector),
            a.scalar * b.scalar - glm::dot(a.vector, b.vector)};
}

/// Half the turn is made small by halving, its sine and cosine are Taylor sums, and squaring undoes the halving.
Quaternion fromTurn(Vec3 half) {
    constexpr double kSmall = 0.25; // the sums' first left-out terms are below 1e-17 there
    int halvings = 0;
    for (; glm::dot(half, half) > kSmall * kSmall && halvings < 60; ++halvings) half *= 0.5;
    const double s = glm::dot(half, half);
    const double sinc = 1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0))));
    const double cosine = 1.0 - s / 2.0 * (1.0 - s / 12.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0))));
    Quaternion turn{sinc * half, cosine};
    for (; halvings > 0; --halvings) turn = multiply(turn, turn);
    return turn;
}

} // namespace

void rotate(double (&orientation)[4], const Vec3 &turn) {
    if (turn == Vec3(0.0)) return;
    const Quaternion before{{orientation[0], orientation[1], orientation[2]}, orientation[3]};
    const Quaternion after = multiply(fromTurn(0.5 * turn), before);
    const double norm = std::sqrt(glm::dot(after.vector, after.vector) + after.scalar * after.scalar);
    orientation[0] = after.vector.x / norm;
    orientation[1] = after.vector.y / norm;
    orientation[2] = after.vector.z / norm;
    orientation[3] = after.scalar / norm;
}

} // namespace phys
