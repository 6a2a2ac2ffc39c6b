// SPDX-License-Identifier: MIT
// A ball on one face that rolls against resistance or slips: the law v' = A - B hat(v) in the face's plane. model.md
// 3.1 and 3.6.
#pragma once

#include "phases/phase.h"

#include <array>

namespace phys {

class Resisted {
public:
    static constexpr uint64_t lookWork() { return 75; }

    struct Face {
        uint32_t contact;
        int axis; ///< of its normal
        Vec3 normal;
    };

    /// B: m/s^2.
    static Resisted rolling(const Moment &moment, const Face &face, double B);
    /// friction: mu N, m/s^2.
    static Resisted slipping(const Moment &moment, const Face &face, const Vec3 &slip, double friction);

    Way at(double t) const;
    Place placeAt(double t) const;
    Vec3 spinAt(double t) const { return placeAt(t).spin; }
    double least(const Vec3 &n, double rate, double t, double until) const;
    double mostAcceleration() const { return m_most; }
    /// Whether the velocity along any direction changes its sign at most once: model.md 3.5.
    bool turnsOnce() const { return !m_slips; }
    /// At a moment, of a ball with this velocity then.
    Vec3 accelerationAt(double t, const Vec3 &velocity) const;
    /// At least that along n, from a moment on at which it moves there at this rate.
    double leastAcceleration(const Vec3 &n, double rate) const;
    End end(double, Work &) const { return {m_law.stopTime(), m_slips ? Cause::grip : Cause::stop, m_face.contact}; }
    Losses losses(double t) const;

private:
    bool m_slips = false;
    Face m_face;
    Vec3 m_velocity, m_spin;
    Vec3 m_q{0.0}, m_qRate{0.0}; // slip: the velocity of rolling, and its rate; otherwise unused
    Vec3 m_A;
    double m_B, m_radius, m_most = 0.0;
    ResistedLaw m_law;
    struct Known {
        double time = -1.0; ///< s; below 0: none
        ResistedLaw::Point point;
    };
    mutable std::array<Known, 2> m_known; ///< the last ones: a search asks for each time, and for its end, again
    mutable uint32_t m_newest = 0;
    Vec2 m_slipStart{0.0}, m_slipEnd{0.0};

    Resisted(const Moment &moment, const Face &face, double B, const Vec3 &A);

    const ResistedLaw::Point &lawAt(double t) const;
    Vec2 onFace(const Vec3 &v) const;
    Vec3 inSpace(const Vec2 &v) const;
    bool leaves(const Vec3 &n, double t, double until) const;
    double mostSlipAlong(const Vec2 &n) const;
};

} // namespace phys
