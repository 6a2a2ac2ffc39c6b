// SPDX-License-Identifier: MIT
// The contribution of a lasting contact to the accelerations: model.md 14.1.
#pragma once

#include "contact/modes.h"

#include <algorithm>
#include <cmath>

namespace phys {

inline constexpr double kFits = 1e-11;          // relative: conditions violated by less than this are satisfied
inline constexpr double kRoughly = 1e6 * kFits; // where directions converge slowly; friction still dissipates
inline constexpr double kInertia = 2.5;         // m R^2 / I of a solid ball
inline constexpr double kSlipPerFriction = 3.5; // change of a contact's slip per unit of its own friction: 1 + 5/2

inline double squared(const Vec3 &v) { return glm::dot(v, v); }

/// Also normalises vectors whose squares underflow.
inline Vec3 hat(Vec3 v) {
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (most == 0.0) return Vec3(0.0);
    if (most < 1e-100) v /= most;
    return v / glm::length(v);
}

inline Vec3 tangential(const Vec3 &v, const Vec3 &normal) { return v - glm::dot(v, normal) * normal; }

inline bool isFace(const Held &held) { return held.across.x + held.across.y + held.across.z == 1.0; }
inline bool isTopFace(const Held &held) { return isFace(held) && held.normal.z == 1.0; }

/// Of two faces as far apart as the ball is wide: whether the first is the idle one, from which gravity pulls the ball.
/// A squeeze of both moves nothing, and there is none, model.md 14.1.
inline bool isIdleBeside(const Vec3 &normal, const Vec3 &other, const Vec3 &gravity, bool isFirst) {
    if (normal != -other) return false;
    const double pull = glm::dot(normal, gravity);
    return pull > 0.0 || (pull == 0.0 && isFirst);
}

/// The contribution of a feature's curvature to the normal acceleration: |P v|^2 / R.
inline double curvature(const Moment &moment, const Held &held) {
    return isFace(held) ? 0.0 : squared(held.across * moment.velocity) / moment.radius;
}

/// How much of a contact's reaction acts along another one's normal, at most, if friction has its worst direction.
inline double mostCoupling(const Vec3 &from, double friction, const Vec3 &to) {
    const double cosine = glm::dot(from, to);
    return std::abs(cosine) + friction * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

/// Whether friction can't hold what it presses by itself, so that only one combination of modes fits: the reactions of
/// the other contacts always change the speed along a normal by less than its own reaction does. Those with nearly the
/// same normal, as at a crack in a floor, don't count: they share what presses on both.
template<class List>
bool areUncoupled(const List &contacts) {
    const auto coupling = [](const auto &to, const auto &from) {
        constexpr double kNearlySame = 1e-4; // rad
        const bool isSameSide = glm::dot(to.normal, from.normal) > 0.0;
        if (isSameSide && glm::length(glm::cross(to.normal, from.normal)) < kNearlySame) return 0.0;
        return mostCoupling(from.normal, from.friction, to.normal);
    };
    if (std::none_of(contacts.begin(), contacts.end(), [](const auto &one) { return one.friction > 0.0; })) return true;
    if (contacts.end() - contacts.begin() == 2) {
        const auto &a = *contacts.begin(), &b = *(contacts.end() - 1);
        return coupling(a, b) * coupling(b, a) < 1.0;
    }
    return std::all_of(contacts.begin(), contacts.end(), [&](const auto &to) {
        double sum = 0.0;
        for (const auto &from : contacts) sum += &from == &to ? 0.0 : coupling(to, from);
        return sum < 1.0;
    });
}

/// The part of the spin that rolling resistance opposes.
inline Vec3 rollingSpin(const Moment &moment, const Held &held) { return tangential(moment.spin, held.normal); }

inline double resistancePerPressure(const Moment &moment, const Held &held) {
    return kInertia * held.resistance / moment.radius;
}

} // namespace phys
