// SPDX-License-Identifier: MIT
// A phase of constant accelerations: flight, straight motion along a face, any motion without resistance. model.md 3.
#pragma once

#include "phases/phase.h"

#include <cmath>

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
    /// When the slip at a contact with this normal, which keeps its direction, ends.
    End endOfSlip(const Vec3 &slip, const Vec3 &normal, double radius, uint32_t contact) const {
        const double slows = -glm::dot(acceleration - radius * glm::cross(spinAcceleration, normal), slip);
        return slows > 0.0 ? End{glm::dot(slip, slip) / slows, Cause::grip, contact} : End();
    }
    /// When resistance stops the ball. rolling: direction of the spin that it opposes.
    End endOfRolling(const Vec3 &rolling, uint32_t contact) const {
        const double speed = glm::dot(spin, rolling), slows = -glm::dot(spinAcceleration, rolling);
        return slows > 0.0 && speed > 0.0 ? End{speed / slows, Cause::stop, contact} : End();
    }
    /// Mean speeds until t, along a direction: of the slip at a contact with this normal, and of the spin.
    double meanSlip(double t, const Vec3 &direction, const Vec3 &normal, double radius) const {
        const Vec3 slip = at(0.5 * t).velocity - radius * glm::cross(spinAt(0.5 * t), normal);
        return std::abs(glm::dot(slip, direction));
    }
    double meanSpin(double t, const Vec3 &direction) const { return std::abs(glm::dot(spinAt(0.5 * t), direction)); }
    double least(const Vec3 &n, double rate, double, double) const { return leastAcceleration(n, rate); }
    double mostAcceleration() const { return glm::length(acceleration); }
    /// Whether the velocity along any direction changes its sign at most once.
    bool turnsOnce() const { return true; }
    Vec3 accelerationAt(double, const Vec3 &) const { return acceleration; }
    double leastAcceleration(const Vec3 &n, double) const { return glm::dot(n, acceleration); }
};

} // namespace phys
