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

/// Halves the angle until it is small, evaluates the Taylor series of sine and cosine, and squares to undo the halving,
/// which doubles the rounding each time.
Quaternion fromTurn(Vec3 half) {
    constexpr double kSmall = 0.25; // the first omitted terms are below 1e-17 there
    int halvings = 0;
    for (; glm::dot(half, half) > kSmall * kSmall && halvings < 60; ++halvings) half *= 0.5;
    const double s = glm::dot(half, half);
    const double sinc =
        1.0 - s * (1.0 / 6 - s * (1.0 / 120 - s * (1.0 / 5040 - s * (1.0 / 362880 - s * (1.0 / 39916800)))));
    const double cosine =
        1.0 - s * (1.0 / 2 - s * (1.0 / 24 - s * (1.0 / 720 - s * (1.0 / 40320 - s * (1.0 / 3628800)))));
    Quaternion turn{sinc * half, cosine};
    for (; halvings > 0; --halvings) turn = multiply(turn, turn);
    return turn;
}

} // namespace

void rotate(double (&orientation)[4], const Vec3 &turn) {
    constexpr double kMost = 0x1p50; // rad: beyond, rounding leaves no angle to turn by
    if (turn == Vec3(0.0) || !(glm::dot(turn, turn) < kMost * kMost)) return;
    const Quaternion before{{orientation[0], orientation[1], orientation[2]}, orientation[3]};
    const Quaternion after = multiply(fromTurn(0.5 * turn), before);
    const double scale = 1.0 / std::sqrt(glm::dot(after.vector, after.vector) + after.scalar * after.scalar);
    orientation[0] = scale * after.vector.x;
    orientation[1] = scale * after.vector.y;
    orientation[2] = scale * after.vector.z;
    orientation[3] = scale * after.scalar;
}

} // namespace phys
