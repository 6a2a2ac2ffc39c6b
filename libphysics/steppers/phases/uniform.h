// SPDX-License-Identifier: MIT
// A phase of constant accelerations: flight, straight motion along a face, any motion without resistance. model.md 3.
#pragma once

#include "phases/phase.h"

namespace phys {

struct Uniform {
    static constexpr uint64_t lookWork() { return 12; }

    Vec3 velocity, acceleration, spin, spinAcceleration;

    Way at(double t) const { return {t * (velocity + 0.5 * t * acceleration), velocity + t * acceleration}; }
    Place placeAt(double t) const {
        const Way now = at(t);
        return {now.way, now.velocity, spinAt(t), t * (spin + 0.5 * t * spinAcceleration)};
    }
    Vec3 spinAt(double t) const { return spin + t * spinAcceleration; }
    double least(const Vec3 &n, double rate, double, double) const { return leastAcceleration(n, rate); }
    double mostAcceleration() const { return glm::length(acceleration); }
    double horizon() const { return kNever; }
    /// Whether the velocity along any direction changes its sign at most once.
    bool turnsOnce() const { return true; }
    Vec3 accelerationAt(double, const Vec3 &) const { return acceleration; }
    double leastAcceleration(const Vec3 &n, double) const { return glm::dot(n, acceleration); }
};

} // namespace phys
