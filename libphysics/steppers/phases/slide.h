// SPDX-License-Identifier: MIT
// A ball that slips on one face and leans on a smooth one across it: only the slip is unknown, computed as a Taylor
// series in xi, dt = |u| dxi. model.md 14.2.
#pragma once

#include "contact/modes.h"
#include "phases/jet.h"

namespace phys {

class Slide {
public:
    static constexpr uint64_t lookWork() { return 30; }

    Slide(const Moment &moment, const Bearing &rough, const Bearing &smooth);

    Way at(double t) const;
    Place placeAt(double t) const;
    Vec3 spinAt(double t) const { return placeAt(t).spin; }
    double least(const Vec3 &n, double rate, double t, double until) const;
    double mostAcceleration() const { return std::max(std::abs(m_start), std::abs(m_limit)); }
    End end(double until, Work &work) const;
    Losses losses(double t) const;

private:
    uint32_t m_rough, m_smooth; ///< their numbers
    int m_across, m_along;      ///< the axes across the smooth face and along both
    Vec3 m_normal, m_spin;      ///< of the rough face; at the start
    double m_radius, m_small;   ///< m; m/s: speed that is rounding
    double m_limitOfFriction;   ///< mu N, m/s^2
    double m_rolling, m_g;      ///< along both faces: the velocity minus 2/7 of the slip; gravity
    double m_fast;              ///< m/s: of the velocities whose difference the slip is
    double m_push, m_side;      ///< m/s^2: pressure on the smooth face at the start; mu N, or -mu N on its other side
    double m_start, m_limit;    ///< m/s^2: acceleration along both faces at the start, and its limit
    JetOf<Vec2> m_u{};          ///< slip: components across the smooth face and along both
    Jet m_speed{};              ///< of the slip
    Jet m_time{};               ///< s
    JetOf<Vec2> m_way{};        ///< m: integral of the slip over the time
    Reach m_reach;              ///< s^2/m
    double m_horizon;           ///< s

    double unit() const { return m_reach.unit; }
    bool mayOpen() const;
    double opensAt(double s, Work &work) const;
    double xiAt(double t) const;
    Way wayAt(double t, double s) const;
};

} // namespace phys
