// SPDX-License-Identifier: MIT
// A ball that goes round one smooth edge, free, on a smooth face across it, or rolling on a rough one: a pendulum, as
// Taylor series in time. model.md 14.2.
#pragma once

#include "contact/modes.h"
#include "phases/jet.h"

namespace phys {

class Pendulum {
public:
    static constexpr uint64_t lookWork() { return 60; }

    /// It glides, along the edge, too, if it is free to. wanted: how long the motion is asked for, s.
    Pendulum(const Moment &moment, const Bearing &edge, bool isFree, double wanted);
    /// It rolls on a face across the edge. heading: in which it moves or starts to.
    Pendulum(const Moment &moment, const Bearing &edge, const Bearing &track, const Vec3 &heading, double wanted);

    Way at(double t) const;
    Place placeAt(double t) const;
    Vec3 spinAt(double t) const { return placeAt(t).spin; }
    double least(const Vec3 &n, double rate, double t, double until) const;
    double mostAcceleration() const { return m_strength + std::abs(m_acceleration); }
    double horizon() const { return m_reach.unit * m_reach.length; }
    End end(double until, Work &work) const;
    Losses losses(double t) const;

private:
    Moment m_moment;
    uint32_t m_edge, m_track = kMostHeld; ///< numbers of the contacts
    int m_axis;                           ///< along the edge
    double m_pressure;                    ///< of the edge at the start
    Vec3 m_up{0.0};                       ///< normal of the face
    Vec3 m_lasting;                       ///< the part of the spin that lasts
    double m_acceleration = 0.0;          ///< along the edge
    double m_gravity;                     ///< across the edge
    double m_resistance = 0.0;            ///< along the tangent, m/s^2
    double m_strength;                    ///< the most that both accelerate the ball, m/s^2
    Vec2 m_pull;                          ///< gravity across the edge, as a share of both
    double m_against;                     ///< resistance, likewise
    Vec2 m_start;                         ///< the normal at the start
    JetOf<Vec2> m_turned;                 ///< the normal minus that
    Jet m_rate;                           ///< at which it turns, per unit
    int m_last;                           ///< order of the last terms
    Reach m_reach;

    Pendulum(const Moment &moment, const Bearing &edge, const Vec3 &lasting);
    void expand(double share, double wanted);
    double drive() const { return m_gravity + std::abs(m_resistance); }
    double rateAt(double t) const { return m_rate.at(t / m_reach.unit, m_last); }
    Vec2 turnedAt(double t) const { return m_turned.at(t / m_reach.unit, m_last); }
    bool rolls() const { return m_track != kMostHeld; }
    /// Components across the edge.
    Vec2 across(const Vec3 &v) const { return {v[(m_axis + 1) % 3], v[(m_axis + 2) % 3]}; }
    Vec3 inSpace(const Vec2 &v, double along) const;
};

} // namespace phys
