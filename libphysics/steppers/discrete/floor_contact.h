// SPDX-License-Identifier: MIT
// The motion of a ball on the floor away from walls: it rolls, slides without friction, or slips.
#pragma once

#include "contact/ball.h"
#include "scene/scene.h"
#include "shared/closed_form.h"
#include "shared/law.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// How a substep moves the ball, given the velocity after its lasting contacts.
enum class ContactRule {
    Symplectic,  ///< with the new velocity
    Explicit,    ///< with the old velocity, except for what contacts remove from it
    SecondOrder, ///< with their mean
    Closing,     ///< with the new velocity, where a scheme of second order closes gaps
    EndingSlip,  ///< with the new velocity, where a scheme of second order ends a slip
};

/// The result of a scheme for one substep.
template<class V>
struct Advance {
    V velocity;     ///< at its end, m/s
    V displacement; ///< during the substep, m
};

/// The closed form of a motion that resistance may stop: from there the ball starts back if the drive exceeds it.
inline ResistedLaw::Point resisted(const Law<Vec2> &law, const Vec2 &velocity, double h) {
    const ResistedLaw motion(velocity, law.A, law.B);
    const double stop = motion.stopTime();
    if (!(h >= (1.0 - 8.0 * kRounding) * stop)) return motion.at(h);
    const ResistedLaw::Point end = motion.at(stop);
    if (!(h > stop)) return end;
    const ResistedLaw::Point back = ResistedLaw(Vec2(0.0), law.A, law.B).at(h - stop);
    return {end.x + back.x, back.v};
}

/// The length of that way, m.
inline double pathOfResisted(const Law<Vec2> &law, const Vec2 &velocity, double h) {
    const ResistedLaw motion(velocity, law.A, law.B);
    const double stop = motion.stopTime();
    if (!(h >= (1.0 - 8.0 * kRounding) * stop)) return motion.pathUntil(h);
    const double path = motion.pathUntil(stop);
    return h > stop ? path + ResistedLaw(Vec2(0.0), law.A, law.B).pathUntil(h - stop) : path;
}

/// A substep in which resistance may stop the ball, for schemes of second order and higher: model.md 10.5.
inline Advance<Vec2> stopping(const Law<Vec2> &law, const Vec2 &velocity, double h) {
    const ResistedLaw::Point end = resisted(law, velocity, h);
    return {end.v, end.x};
}
/// In space resistance acts only on a floor.
inline Advance<Vec3> stopping(const Law<Vec3> &law, const Vec3 &velocity, double h) {
    const Advance<Vec2> next = stopping(Law<Vec2>{inPlane(law.A), law.B}, inPlane(velocity), h);
    return {Vec3(next.velocity, 0.0), Vec3(next.displacement, 0.0)};
}

/// How far a ball may go before it turns, in units of the way with its first velocity: a parabola stays in the triangle
/// of its tangents; the speed along an axis only falls until resistance has ended it.
inline double shareOfTurn(const Law<Vec2> &law, const Vec2 &velocity, double h) {
    return nearStop(law, velocity, h) ? 1.0 : 0.5;
}

/// One Euler step of the velocity, clamped if it may end in a stop.
template<class Law, class V>
V eulerVelocity(const Law &law, const V &velocity, double h) {
    if (nearStop(law, velocity, h)) return clampedVelocity(law, velocity, h);
    return velocity + h * acceleration(law, velocity);
}

/// The way (m) along which resistance takes energy in a substep that it acts throughout: model.md 10.5. The rules of
/// first order move with the velocity at one end, which isn't the mean that the impulse opposes.
template<class Scheme, class V>
double meanWay(const V &velocity, const Advance<V> &next, double h) {
    if constexpr (Scheme::kContactRule == ContactRule::SecondOrder) return glm::length(next.displacement);
    return 0.5 * h * glm::length(velocity + next.velocity);
}

/// The same where resistance may have stopped the ball within the substep.
template<class Scheme>
double resistedWay(const Law<Vec2> &law, const Vec2 &velocity, const Advance<Vec2> &next, double h) {
    if constexpr (Scheme::kContactRule == ContactRule::SecondOrder) {
        if (nearStop(law, velocity, h)) return pathOfResisted(law, velocity, h);
    }
    const bool stops = next.velocity == Vec2(0.0) && velocity != Vec2(0.0);
    if (stops) [[unlikely]]
        return 0.5 * std::min(h, timeToStop(law, velocity)) * glm::length(velocity);
    return meanWay<Scheme>(velocity, next, h);
}

enum class FloorContact {
    Rolls,  ///< u = 0 and friction keeps it so; always in the rolling model
    Slides, ///< rigid model without sliding friction: the spin doesn't affect the motion
    Slips   ///< rigid model: friction turns slip into spin
};

/// Whether u = 0 within rounding: model.md 2.2 F2.
inline bool rolls(const Vec2 &velocity, const Vec3 &spin, double radius) {
    const Vec2 w = spinSpeed(spin, radius);
    const Vec2 u = velocity - w;
    const double size = std::abs(velocity.x) + std::abs(velocity.y) + std::abs(w.x) + std::abs(w.y);
    return std::abs(u.x) + std::abs(u.y) <= 4.0 * kRounding * size;
}

/// Whether friction can keep a ball rolling on this slope: tan(tilt) <= 7/2 mu_s, model.md 2.2 F2.
inline bool gripHolds(const phys_params &params) {
    const Vec2 along = inPlane(params.gravity);
    const double grip = 3.5 * params.sliding_friction * params.gravity.z;
    return glm::dot(along, along) <= grip * grip;
}

inline FloorContact floorContact(const phys_params &params, double radius, const Vec2 &velocity, const Vec3 &spin) {
    if (params.model == PHYS_MODEL_ROLLING) return FloorContact::Rolls;
    if (params.sliding_friction == 0.0) return FloorContact::Slides;
    return rolls(velocity, spin, radius) && gripHolds(params) ? FloorContact::Rolls : FloorContact::Slips;
}

/// Whether a supported ball's contact slips; without friction nothing could end a slip within rounding.
inline bool isSlipping(const phys_params &params, double radius, const Vec2 &velocity, const Vec3 &spin) {
    if (params.model == PHYS_MODEL_ROLLING) return false;
    if (params.sliding_friction == 0.0) return velocity != spinSpeed(spin, radius);
    return !rolls(velocity, spin, radius);
}

/// The law of the velocity, if there is one: not while it slips.
inline Law<Vec2> velocityLaw(FloorContact contact, const phys_params &params) {
    return contact == FloorContact::Slides ? Law<Vec2>{inPlane(params.gravity), 0.0} : rollingLaw(params);
}

/// The spin after a step of that law. The spin about the vertical is unchanged.
inline Vec3 spinAfter(FloorContact contact, const Vec2 &velocity, const Vec3 &spin, double radius) {
    if (contact == FloorContact::Slides) return spin;
    return rollingSpin(velocity, radius) + Vec3(0.0, 0.0, spin.z);
}

/// A substep of slipping: q is uniformly accelerated whatever friction does, and the scheme integrates the slip u,
/// model.md 3.6. Changes the spin; slipPath (m): or nullptr.
template<class Scheme>
Advance<Vec2> slip(const phys_params &params, double radius, double h, const Vec2 &velocity, Vec3 &spin,
                   double *slipPath) {
    const Vec2 w = spinSpeed(spin, radius);
    const Vec2 q = (5.0 * velocity + 2.0 * w) / 7.0;
    const Vec2 qDrive = 5.0 / 7.0 * inPlane(params.gravity);
    const Vec2 qNext = q + h * qDrive;
    const Law<Vec2> law = slippingLaw(params);
    const Advance<Vec2> u = Scheme::advance(law, velocity - w, h);
    if (slipPath) *slipPath = resistedWay<Scheme>(law, velocity - w, u, h);
    spin = rollingSpin(qNext - 5.0 / 7.0 * u.velocity, radius) + Vec3(0.0, 0.0, spin.z);
    return {qNext + 2.0 / 7.0 * u.velocity, h * q + 0.5 * h * h * qDrive + 2.0 / 7.0 * u.displacement};
}

} // namespace phys
