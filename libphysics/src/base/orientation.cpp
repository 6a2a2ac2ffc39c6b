// SPDX-License-Identifier: MIT
#include "base/orientation.h"

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

/// Newton's step from 1 towards 1 / length: lengths off by up to 1e-6, which a state may have, are then off by 1e-12.
Quaternion normalised(const Quaternion &q) {
    const double scale = 1.5 - 0.5 * (glm::dot(q.vector, q.vector) + q.scalar * q.scalar);
    return {scale * q.vector, scale * q.scalar};
}

/// Halves the angle until it is small, evaluates the Taylor series of sine and cosine, and squares to undo the halving.
Quaternion fromTurn(Vec3 half) {
    constexpr double kSmall = 0.25; // the first omitted terms are below 1e-17 there
    int halvings = 0;
    for (; glm::dot(half, half) > kSmall * kSmall; ++halvings) half *= 0.5;
    const double s = glm::dot(half, half), s2 = s * s;
    // In pairs, which processors compute side by side.
    const double sinc =
        (1.0 - s * (1.0 / 6)) + s2 * ((1.0 / 120 - s * (1.0 / 5040)) + s2 * (1.0 / 362880 - s * (1.0 / 39916800)));
    const double cosine =
        (1.0 - s * (1.0 / 2)) + s2 * ((1.0 / 24 - s * (1.0 / 720)) + s2 * (1.0 / 40320 - s * (1.0 / 3628800)));
    Quaternion turn{sinc * half, cosine};
    for (; halvings > 0; --halvings) turn = normalised(multiply(turn, turn));
    return turn;
}

} // namespace

void rotate(double (&orientation)[4], const Vec3 &turn) {
    constexpr double kMost = 0x1p50; // rad: beyond, rounding leaves no angle to turn by
    if (turn == Vec3(0.0) || !(glm::dot(turn, turn) < kMost * kMost)) return;
    const Quaternion before{{orientation[0], orientation[1], orientation[2]}, orientation[3]};
    const Quaternion after = normalised(multiply(fromTurn(0.5 * turn), before));
    orientation[0] = after.vector.x;
    orientation[1] = after.vector.y;
    orientation[2] = after.vector.z;
    orientation[3] = after.scalar;
}

} // namespace phys
