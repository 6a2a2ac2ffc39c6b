// SPDX-License-Identifier: MIT
// The law of smooth motion, v' = A - B hat(v), with three sets of constants: model.md 3.1.
#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace phys {

/// V is Vec2 for a ball supported by the floor and Vec3 for one in flight.
template<class V>
struct Law {
    V A;      ///< constant acceleration, m/s^2
    double B; ///< constant resistance against the motion, m/s^2
};

/// Rolling on the floor, model.md 2.1 R1 and 2.2 F2: the variable is the velocity.
inline Law<Vec2> rollingLaw(const phys_params &params) {
    const double normal = -params.gravity.z;
    return {5.0 / 7.0 * inPlane(params.gravity), 5.0 / 7.0 * (params.rolling_friction * normal)};
}

/// Slipping on the floor, model.md 3.6: the variable is the slip velocity u.
inline Law<Vec2> slippingLaw(const phys_params &params) {
    return {inPlane(params.gravity), 3.5 * (params.sliding_friction * -params.gravity.z)};
}

/// Flight, model.md 3.7: the variable is the velocity.
inline Law<Vec3> flightLaw(const phys_params &params) { return {toVec(params.gravity), 0.0}; }

/// Right-hand side of the law; at v = 0 the resistance has no direction and is left to the clamp. Without resistance A
/// is returned as it is: subtracting 0 v would turn its negative zeros into positive ones.
template<class V>
V acceleration(const Law<V> &law, const V &v) {
    if (law.B == 0.0) return law.A;
    const double speed = glm::length(v);
    return speed > 0.0 ? law.A - law.B / speed * v : law.A;
}

/// One step of the velocity, with exact stiction and without chatter (backward Euler for the resistance): model.md
/// 10.5.
template<class V>
V clampedVelocity(const Law<V> &law, const V &v, double dt) {
    const V driven = v + dt * law.A;
    if (law.B == 0.0) return driven;
    const double speed = glm::length(driven);
    // The division comes last, so that short binary numbers stay exact.
    return speed > law.B * dt ? (speed - law.B * dt) * driven / speed : V(0.0);
}

/// When resistance has stopped a ball that moves straight on, s: |v + t A| = B t; 0 if squares of its speed underflow.
/// The clamp stops it in a step at least as long.
template<class V>
double timeToStop(const Law<V> &law, const V &v) {
    const double speed = glm::length(v);
    if (speed == 0.0) return 0.0;
    const double along = glm::dot(law.A, v) / speed;
    const double across = along * along - glm::dot(law.A, law.A);
    const double slowing = std::sqrt(std::max(0.0, law.B * law.B + across)) - along;
    return slowing > 0.0 ? speed / slowing : INFINITY;
}

/// Whether resistance may stop the ball within h: then the clamp replaces every scheme, model.md 10.5. If the drive
/// exceeds the resistance, the ball reverses instead of stopping, and only the step of the reversal needs the clamp.
template<class V>
bool nearStop(const Law<V> &law, const V &velocity, double h) {
    if (law.B == 0.0) return false;
    // The usual case, without a square root: the sum of components is never smaller than the length.
    double most = law.B;
    for (int axis = 0; axis < V::length(); ++axis) most += std::abs(law.A[axis]);
    most *= 4.0 * h;
    if (glm::dot(velocity, velocity) > most * most) return false;
    const double drive = glm::length(law.A);
    const double margin = (law.B < drive ? 1.0 : 4.0) * (drive + law.B) * h;
    return glm::dot(velocity, velocity) <= margin * margin;
}

} // namespace phys
