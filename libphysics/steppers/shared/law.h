// SPDX-License-Identifier: MIT
// The one law of smooth motion, v' = A - B hat(v), with three sets of constants: model.md 3.1.
#pragma once

#include "base/vec.h"

#include <cmath>

namespace phys {

/// V is Vec2 for a ball supported by the floor and Vec3 for one in flight.
template<class V>
struct Law {
    V A;          ///< constant acceleration, m/s^2
    double B;     ///< constant resistance against the motion, m/s^2
    bool resists; ///< whether to compute with B at all; may be left out where B = 0
};

/// Rolling on the floor, model.md 2.1 R1 and 2.2 F2: the unknown is the velocity.
inline Law<Vec2> rollingLaw(const phys_params &params) {
    const double normal = -params.gravity.z;
    return {5.0 / 7.0 * inPlane(params.gravity), 5.0 / 7.0 * (params.rolling_friction * normal),
            params.rolling_friction != 0.0};
}

/// Slipping on the floor, model.md 3.6: the unknown is the slip velocity u.
inline Law<Vec2> slippingLaw(const phys_params &params) {
    return {inPlane(params.gravity), 3.5 * (params.sliding_friction * -params.gravity.z), true};
}

/// Flight, model.md 3.7: the unknown is the velocity.
inline Law<Vec3> flightLaw(const phys_params &params) { return {toVec(params.gravity), 0.0, false}; }

/// Right-hand side of the law; at v = 0 the resistance has no direction and is left to the clamp.
template<class V>
V acceleration(const Law<V> &law, const V &v) {
    if (!law.resists) return law.A;
    const double speed = glm::length(v);
    return speed > 0.0 ? law.A - law.B / speed * v : law.A;
}

/// One step of the velocity with stiction exact and without chatter (backward Euler of the resistance): model.md 10.5.
template<class V>
V clampedVelocity(const Law<V> &law, const V &v, double dt) {
    const V driven = v + dt * law.A;
    if (!law.resists) return driven;
    const double speed = glm::length(driven);
    // Divided last: what is exact in binary stays exact.
    return speed > law.B * dt ? (speed - law.B * dt) * driven / speed : V(0.0);
}

/// Whether resistance may stop the ball within h: from here on the clamp takes over from every scheme, model.md 10.5.
/// Where the drive outweighs it the ball turns back rather than stop, and only the step of the turn itself needs that.
template<class V>
bool nearStop(const Law<V> &law, const V &velocity, double h) {
    if (!law.resists || law.B == 0.0) return false;
    // The usual no, without a root: the sum of components is never smaller than the length.
    double most = law.B;
    for (int axis = 0; axis < V::length(); ++axis) most += std::abs(law.A[axis]);
    most *= 4.0 * h;
    if (glm::dot(velocity, velocity) > most * most) return false;
    const double drive = glm::length(law.A);
    const double margin = (law.B < drive ? 1.0 : 4.0) * (drive + law.B) * h;
    return glm::dot(velocity, velocity) <= margin * margin;
}

} // namespace phys
