// SPDX-License-Identifier: MIT
#include "phases/pendulum.h"

#include <algorithm>

namespace phys {

namespace {

/// With terms up to `order` the series are accurate until then: |n_k| < k (2/pi)^k.
struct Truncation {
    int order;
    double until; ///< units
};
constexpr std::array kShort{Truncation{9, 0.02}, Truncation{12, 0.05}, Truncation{16, 0.12}};

} // namespace

Pendulum::Pendulum(const Moment &moment, const Bearing &edge, const Vec3 &lasting)
    : m_moment(moment)
    , m_edge(edge.contact)
    , m_axis(edge.held.across.x == 0.0   ? 0
             : edge.held.across.y == 0.0 ? 1
                                         : 2)
    , m_pressure(edge.reaction.pressure)
    , m_lasting(lasting)
    , m_gravity(glm::length(across(moment.gravity)))
    , m_start(across(edge.held.normal)) {}

Pendulum::Pendulum(const Moment &moment, const Bearing &edge, bool isFree, double wanted)
    : Pendulum(moment, edge, moment.spin) {
    if (isFree) m_acceleration = moment.gravity[m_axis];
    expand(1.0, wanted);
}

Pendulum::Pendulum(const Moment &moment, const Bearing &edge, const Bearing &track, const Vec3 &heading, double wanted)
    : Pendulum(moment, edge, glm::dot(moment.spin, track.held.normal) * track.held.normal) {
    m_track = track.contact;
    m_up = track.held.normal;
    m_resistance = std::copysign(track.resistance(), glm::dot(quarterTurn(m_start), across(heading)));
    expand(5.0 / 7.0, wanted);
}

// With the normal n, the tangent t, the rate w, gravity g across the edge and resistance r along t: n' = w t and
// R w' = g.t - r, of a ball that rolls 5/7 of that. While the edge presses R w^2 < -g.n <= g, so that in units in which
// g + |r|, or 5/7 of it, is 1, all terms have the bounds that they have without resistance.
void Pendulum::expand(double share, double wanted) {
    const double R = m_moment.radius;
    m_strength = share * drive();
    m_reach.unit = std::sqrt(R / m_strength);
    m_pull = across(m_moment.gravity) / drive();
    m_against = m_resistance / drive();
    const auto fits = std::find_if(kShort.begin(), kShort.end(),
                                   [&](const Truncation &each) { return wanted <= each.until * m_reach.unit; });
    m_last = fits == kShort.end() ? kOrder : fits->order;
    m_turned.c.fill(Vec2(0.0));
    m_rate.c.fill(0.0);
    m_turned[0] = m_start;
    m_rate[0] = glm::dot(quarterTurn(m_start), across(m_moment.velocity)) * m_reach.unit / R;
    for (int k = 0; k < m_last; ++k) {
        m_turned[k + 1] = quarterTurn(termOf(m_rate, m_turned, k)) / (k + 1.0);
        m_rate[k + 1] = glm::dot(m_pull, quarterTurn(m_turned[k])) / (k + 1.0);
        if (k == 0) m_rate[1] -= m_against;
    }
    m_turned[0] = Vec2(0.0);
    if (fits != kShort.end()) {
        m_reach.length = fits->until;
        return;
    }
    m_reach.measure(Validity(kOrder).add(m_turned, 1.0).add(m_rate, 1.0).until());
}

Vec3 Pendulum::inSpace(const Vec2 &v, double along) const {
    Vec3 all;
    all[m_axis] = along;
    all[(m_axis + 1) % 3] = v.x;
    all[(m_axis + 2) % 3] = v.y;
    return all;
}

Way Pendulum::at(double t) const {
    const double R = m_moment.radius, speed = m_moment.velocity[m_axis];
    const Vec2 way = turnedAt(t);
    return {inSpace(R * way, t * (speed + 0.5 * m_acceleration * t)),
            inSpace(R / m_reach.unit * rateAt(t) * quarterTurn(m_start + way), speed + m_acceleration * t)};
}

Place Pendulum::placeAt(double t) const {
    const Way now = at(t);
    if (!rolls()) return {now.way, now.velocity, m_lasting, t * m_lasting};
    return rolledPlace(now, now, m_up, m_lasting, m_moment.radius, t);
}

/// The acceleration changes by at most three times the strength times w, and w is largest at one of the ends: the ball
/// is slowest where it turns round or passes the top.
double Pendulum::least(const Vec3 &n, double, double t, double until) const {
    const double rate = rateAt(t), fastest = std::max(std::abs(rate), std::abs(rateAt(until)));
    const Vec2 normal = m_start + turnedAt(t), tangent = quarterTurn(normal), along = across(n);
    const Vec2 acceleration = m_strength * ((glm::dot(m_pull, tangent) - m_against) * tangent - rate * rate * normal);
    return glm::dot(along, acceleration) + n[m_axis] * m_acceleration -
           3.0 * m_strength * glm::length(along) * fastest * (until - t) / m_reach.unit;
}

/// By the conservation of energy the pressure changes by -3 g.(n - n0), and twice the work of resistance per radius.
End Pendulum::end(double until, Work &work) const {
    const double s = std::min(until / m_reach.unit, m_reach.length);
    Jet pressure{};
    pressure[0] = m_pressure;
    for (int k = 1; k <= m_last; ++k) pressure[k] = -3.0 * drive() * glm::dot(m_pull, m_turned[k]);
    if (m_resistance != 0.0) {
        for (int k = 1; k <= m_last; ++k) pressure[k] += 2.0 * m_resistance * m_rate[k - 1] / k;
    }
    End end{horizon(), Cause::time, 0};
    end.cut({m_reach.unit * firstFall(pressure, s, work), Cause::release, m_edge});
    if (m_resistance == 0.0) return end;
    const Jet speed = sum(0.0, std::copysign(1.0, m_resistance), m_rate);
    end.cut({m_reach.unit * firstFall(speed, s, work), Cause::stop, m_track});
    return end;
}

Losses Pendulum::losses(double t) const {
    return {0.0, m_moment.radius * m_resistance * m_rate.integralAt(t / m_reach.unit)};
}

} // namespace phys
