// SPDX-License-Identifier: MIT
// A ball that glides round one smooth edge, free or on a smooth face across it: a pendulum, as Taylor series in time.
// model.md 14.2.
#pragma once

#include "contact/modes.h"
#include "phases/jet.h"

namespace phys {

class Pendulum {
public:
    static constexpr uint64_t lookWork() { return 60; }

    /// contact, normal, pressure: number of the edge, from it to the ball, of the edge. axis: along the edge, with this
    /// acceleration. wanted: how long the motion is asked for, s.
    Pendulum(const Moment &moment, uint32_t contact, const Vec3 &normal, double pressure, int axis, double acceleration,
             double wanted);

    Way at(double t) const;
    Place placeAt(double t) const {
        const Way now = at(t);
        return {now.way, now.velocity, m_moment.spin, t * m_moment.spin};
    }
    Vec3 spinAt(double) const { return m_moment.spin; }
    double least(const Vec3 &n, double rate, double t, double until) const;
    double mostAcceleration() const { return m_pull + std::abs(m_acceleration); }
    double horizon() const { return m_reach.unit * m_reach.length; }
    End end(double until, Work &work) const;
    Losses losses(double) const { return {}; }

private:
    Moment m_moment;
    uint32_t m_contact;
    int m_axis;
    double m_pressure, m_acceleration;
    double m_pull;        ///< m/s^2: gravity across the edge
    Vec2 m_down;          ///< its direction
    Vec2 m_start;         ///< the normal at the start
    JetOf<Vec2> m_turned; ///< the normal minus that
    Jet m_rate;           ///< at which it turns, per unit
    Reach m_reach;

    /// Components across the edge.
    Vec2 across(const Vec3 &v) const { return {v[(m_axis + 1) % 3], v[(m_axis + 2) % 3]}; }
    Vec3 inSpace(const Vec2 &v, double along) const;
};

} // namespace phys
