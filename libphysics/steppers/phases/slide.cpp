// SPDX-License-Identifier: MIT
#include "phases/slide.h"

#include <algorithm>

namespace phys {

// The pressure on the rough face is constant, the smooth face balances the forces across it. Friction -B d, B = mu N,
// changes the slip by (-5/2 B d_x, g - 7/2 B d_y), and v = q + (2/7) u along both, where q grows by (5/7) g. With
// dt = |u| dxi as in 3.1, du/dxi = (-5/2 B u_x, g |u| - 7/2 B u_y): the end of the slip is infinitely far away in xi,
// where it limits no series.
Slide::Slide(const Moment &moment, const Bearing &rough, const Bearing &smooth)
    : m_rough(rough.contact)
    , m_smooth(smooth.contact)
    , m_across(axisOf(smooth.held))
    , m_along(3 - axisOf(rough.held) - m_across)
    , m_normal(rough.held.normal)
    , m_spin(moment.spin)
    , m_radius(moment.radius)
    , m_small(kSlipEnds * speedScale(moment))
    , m_limitOfFriction(rough.friction())
    , m_g(moment.gravity[m_along]) {
    const double B = m_limitOfFriction;
    m_u[0] = {rough.reaction.slip[m_across], rough.reaction.slip[m_along]};
    m_speed[0] = glm::length(m_u[0]);
    m_push = smooth.reaction.pressure;
    m_side = smooth.reaction.force[m_across] > 0.0 ? B : -B;
    m_rolling = moment.velocity[m_along] - 2.0 / 7.0 * m_u[0].y;
    m_start = m_g - B * rough.reaction.direction[m_along];
    m_limit = m_g - std::clamp(m_g, -B, B);
    m_fast = std::min(glm::length(moment.velocity), m_radius * glm::length(m_spin));
    m_reach.unit = 1.0 / (3.5 * B + std::abs(m_g));
    for (int k = 0; k <= kOrder; ++k) {
        m_speed[k] = lengthTerm(m_u.c.data(), m_speed, k);
        if (k == kOrder) break;
        const double share = unit() / (k + 1);
        m_u[k + 1] = share * (Vec2(0.0, m_g * m_speed[k]) - B * Vec2(2.5, 3.5) * m_u[k]);
        m_time[k + 1] = share * m_speed[k];
        Vec2 way(0.0);
        for (int j = 0; j <= k; ++j) way += m_speed[j] * m_u[k - j];
        m_way[k + 1] = share * way;
    }
    // The slip needs only the accuracy of the velocities whose difference it is.
    const double time = m_fast * unit();
    Validity validity(kOrder);
    validity.add(m_u, m_fast).add(m_speed, m_fast).add(m_time, time).add(m_way, m_fast * time);
    m_reach.measure(validity.until());
    m_horizon = m_time.at(m_reach.length);
}

/// xi in units.
double Slide::xiAt(double t) const {
    return t == m_horizon ? m_reach.length : placeOf(m_time, m_speed, unit(), t, m_reach.length);
}

Way Slide::at(double t) const { return wayAt(t, xiAt(t)); }

Way Slide::wayAt(double t, double s) const {
    Way now{Vec3(0.0), Vec3(0.0)};
    now.way[m_along] = t * (m_rolling + 5.0 / 14.0 * m_g * t) + 2.0 / 7.0 * m_way.at(s).y;
    now.velocity[m_along] = m_rolling + 5.0 / 7.0 * m_g * t + 2.0 / 7.0 * m_u.at(s).y;
    return now;
}

Place Slide::placeAt(double t) const {
    const double s = xiAt(t);
    const Way now = wayAt(t, s);
    const auto without = [&](Vec3 rolls, const Vec2 &slip) {
        rolls[m_across] -= slip.x;
        rolls[m_along] -= slip.y;
        return rolls;
    };
    const Way rolls{without(now.way, m_way.at(s)), without(now.velocity, m_u.at(s))};
    return rolledPlace(now, rolls, m_normal, glm::dot(m_spin, m_normal) * m_normal, m_radius, t);
}

/// The slip's direction turns monotonically to where friction balances gravity along both faces.
double Slide::least(const Vec3 &n, double, double, double) const {
    return std::min(n[m_along] * m_start, n[m_along] * m_limit);
}

/// Whether the smooth face's pressure may fall to zero: of |u_x|/|u| is known that it remains above the smaller of its
/// start and its limit.
bool Slide::mayOpen() const {
    constexpr double kLeast = 1e-6; // of the friction
    const double across = std::abs(m_u[0].x) / m_speed[0], along = (m_g - m_limit) / m_limitOfFriction; // of the limit
    const double limit = std::sqrt(std::max(0.0, 1.0 - along * along));
    const double change = m_side * m_u[0].x >= 0.0 ? std::min(0.0, limit - across) : across - 1.0;
    return !(m_push + m_limitOfFriction * change > kLeast * m_limitOfFriction);
}

/// In units; kNever if not before s.
double Slide::opensAt(double s, Work &work) const {
    Jet pressure;
    for (int k = 0; k <= kOrder; ++k) pressure[k] = quotientTerm(m_side * m_u[k].x, m_speed, pressure, k);
    pressure[0] = m_push; // which contains gravity's part
    return firstFall(pressure, s, work);
}

End Slide::end(double until, Work &work) const {
    End end{m_horizon, Cause::time, 0};
    const double opens = mayOpen() ? opensAt(until < m_horizon ? xiAt(until) : m_reach.length, work) : kNever;
    if (opens != kNever) end.cut({m_time.at(opens), Cause::release, m_smooth});
    // What is left of a small slip falls at its present rate.
    const double slows = -m_speed[1] / (unit() * m_speed[0]);
    const bool ends = m_limitOfFriction > 0.0 && slows > 0.0 && m_speed[0] <= m_small;
    if (ends) end.cut({0.0, Cause::grip, m_rough, m_speed[0] / slows});
    return end;
}

Losses Slide::losses(double t) const {
    const Jet squares = product(m_speed, m_speed); // of the slip's speed: |u| dt = |u|^2 dxi
    return {m_limitOfFriction * squares.integralAt(xiAt(t)) * unit(), 0.0};
}

} // namespace phys
