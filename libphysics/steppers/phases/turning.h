// SPDX-License-Identifier: MIT
// Rotation of the ball during a phase, for drawing only.
#pragma once

#include "base/orientation.h"
#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// Rotates an orientation by a phase's motion until t (s): Magnus series with two Gauss points, fourth order.
template<class Phase>
void turn(double (&orientation)[4], const Phase &phase, double t) {
    constexpr double kRoot3 = 1.7320508075688772, kMostParts = 16.0;
    const double angle = t * std::max(glm::length(phase.spinAt(0.0)), glm::length(phase.spinAt(t)));
    const double parts = std::clamp(std::ceil(angle), 1.0, kMostParts), h = t / parts;
    for (int part = 0; part < parts; ++part) {
        const double middle = part + 0.5;
        const Vec3 first = phase.spinAt((middle - kRoot3 / 6.0) * h);
        const Vec3 second = phase.spinAt((middle + kRoot3 / 6.0) * h);
        rotate(orientation, 0.5 * h * (first + second) + kRoot3 / 12.0 * h * h * glm::cross(second, first));
    }
}

} // namespace phys
