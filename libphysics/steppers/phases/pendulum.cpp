// SPDX-License-Identifier: MIT
#include "phases/pendulum.h"

#include <algorithm>

namespace phys {

namespace {

/// A quarter turn.
Vec2 quarterTurn(const Vec2 &v) { return {-v.y, v.x}; }

} // namespace

// With the normal n, the tangent t, the rate w and gravity g across the edge: n' = w t, R w' = g.t. As long as the edge
// presses, R w^2 < -g.n <= g, which bounds all that follows.
Pendulum::Pendulum(const Moment &moment, uint32_t contact, const Vec3 &normal, double pressure, int axis,
                   double acceleration, double wanted)
    : m_moment(moment)
    , m_contact(contact)
    , m_axis(axis)
    , m_pressure(pressure)
    , m_acceleration(acceleration)
    , m_pull(glm::length(across(moment.gravity)))
    , m_down(across(moment.gravity) / m_pull)
    , m_start(across(normal)) {
    constexpr double kSoon = 0.05; // units, for which the terms of order 13 are below 1e-17: |n_k| < k (2/pi)^k
    constexpr int kFew = 12;
    m_reach.unit = std::sqrt(moment.radius / m_pull);
    const bool isSoon = wanted <= kSoon * m_reach.unit;
    const int last = isSoon ? kFew : kOrder;
    m_turned.c.fill(Vec2(0.0));
    m_rate.c.fill(0.0);
    m_rate[0] = glm::dot(quarterTurn(m_start), across(moment.velocity)) * m_reach.unit / moment.radius;
    for (int k = 0; k < last; ++k) {
        Vec2 sum = m_rate[k] * m_start;
        for (int j = 1; j <= k; ++j) sum += m_rate[k - j] * m_turned[j];
        m_turned[k + 1] = quarterTurn(sum) / (k + 1.0);
        m_rate[k + 1] = glm::dot(m_down, quarterTurn(k == 0 ? m_start : m_turned[k])) / (k + 1.0);
    }
    Validity validity(kOrder);
    validity.add(m_turned, 1.0);
    validity.add(m_rate, 1.0);
    if (isSoon)
        m_reach.length = kSoon;
    else
        m_reach.measure(validity.until());
}

Vec3 Pendulum::inSpace(const Vec2 &v, double along) const {
    Vec3 all;
    all[m_axis] = along;
    all[(m_axis + 1) % 3] = v.x;
    all[(m_axis + 2) % 3] = v.y;
    return all;
}

Way Pendulum::at(double t) const {
    const double s = t / m_reach.unit, R = m_moment.radius, speed = m_moment.velocity[m_axis];
    const Vec2 way = m_turned.at(s);
    return {inSpace(R * way, t * (speed + 0.5 * m_acceleration * t)),
            inSpace(R / m_reach.unit * m_rate.at(s) * quarterTurn(m_start + way), speed + m_acceleration * t)};
}

/// The acceleration changes by at most 3 g w per time, and w is largest at one of the ends: the ball is slowest where
/// it turns round or passes the top.
double Pendulum::least(const Vec3 &n, double, double t, double until) const {
    const double s = t / m_reach.unit, rate = m_rate.at(s);
    const double fastest = std::max(std::abs(rate), std::abs(m_rate.at(until / m_reach.unit)));
    const Vec2 normal = m_start + m_turned.at(s), tangent = quarterTurn(normal), along = across(n);
    const Vec2 acceleration = m_pull * (glm::dot(m_down, tangent) * tangent - rate * rate * normal);
    return glm::dot(along, acceleration) + n[m_axis] * m_acceleration -
           3.0 * m_pull * glm::length(along) * fastest * (until - t) / m_reach.unit;
}

/// By the conservation of energy the pressure changes by -3 g.(n - n0).
End Pendulum::end(double until, Work &work) const {
    Jet pressure;
    for (int k = 1; k <= kOrder; ++k) pressure[k] = -3.0 * m_pull * glm::dot(m_down, m_turned[k]);
    pressure[0] = m_pressure;
    End end{horizon(), Cause::time, 0};
    const double opens = firstFall(pressure, std::min(until / m_reach.unit, m_reach.length), work);
    end.cut({m_reach.unit * opens, Cause::release, m_contact});
    return end;
}

} // namespace phys
