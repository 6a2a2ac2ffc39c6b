// SPDX-License-Identifier: MIT
// Rotation of the ball during a phase, for drawing only.
#pragma once

#include "base/orientation.h"
#include "base/vec.h"
#include "phases/phase.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// Turns an orientation by what a phase does until t (s), where it comes to `end`: Magnus' series of fourth order.
template<class Phase>
void turn(double (&orientation)[4], const Phase &phase, const Place &end, double t) {
    constexpr double kMostParts = 16.0;
    Place before{Vec3(0.0), Vec3(0.0), phase.spinAt(0.0), Vec3(0.0)};
    const double angle = t * std::max(glm::length(before.spin), glm::length(end.spin));
    const int parts = static_cast<int>(std::clamp(std::ceil(angle), 1.0, kMostParts));
    const double h = t / parts;
    for (int part = 1; part <= parts; ++part) {
        const Place now = part < parts ? phase.placeAt(part * h) : end;
        rotate(orientation, now.turning - before.turning + h * h / 12.0 * glm::cross(now.spin, before.spin));
        before = now;
    }
}

} // namespace phys
