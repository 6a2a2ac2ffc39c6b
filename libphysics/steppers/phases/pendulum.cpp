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

Pendulum::Pendulum(const Moment &moment, const Edge &edge, double acceleration, double wanted)
    : m_moment(moment)
    , m_edge(edge)
    , m_lasting(moment.spin)
    , m_acceleration(acceleration)
    , m_gravity(glm::length(across(moment.gravity))) {
    expand(1.0, wanted);
}

Pendulum::Pendulum(const Moment &moment, const Edge &edge, const Track &track, const Vec3 &heading, double wanted)
    : m_moment(moment)
    , m_edge(edge)
    , m_track(track)
    , m_lasting(glm::dot(moment.spin, track.normal) * track.normal)
    , m_gravity(glm::length(across(moment.gravity))) {
    m_resistance = std::copysign(track.resistance, glm::dot(quarterTurn(across(edge.normal)), across(heading)));
    expand(5.0 / 7.0, wanted);
}

// With the normal n, the tangent t, the rate w, gravity g across the edge and resistance r along t: n' = w t and
// R w' = g.t - r, of a ball that rolls 5/7 of that. While the edge presses R w^2 < -g.n <= g, so that in units in which
// g + |r|, or 5/7 of it, is 1, all terms have the bounds that they have without resistance.
void Pendulum::expand(double share, double wanted) {
    const double R = m_moment.radius;
    m_strength = share * drive();
    m_reach.unit = std::sqrt(R / m_strength);
    m_start = across(m_edge.normal);
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
    Validity validity(kOrder);
    validity.add(m_turned, 1.0);
    validity.add(m_rate, 1.0);
    m_reach.measure(validity.until());
}

Vec3 Pendulum::inSpace(const Vec2 &v, double along) const {
    Vec3 all;
    all[m_edge.axis] = along;
    all[(m_edge.axis + 1) % 3] = v.x;
    all[(m_edge.axis + 2) % 3] = v.y;
    return all;
}

Way Pendulum::at(double t) const {
    const double s = t / m_reach.unit, R = m_moment.radius, speed = m_moment.velocity[m_edge.axis];
    const Vec2 way = m_turned.at(s, m_last);
    return {inSpace(R * way, t * (speed + 0.5 * m_acceleration * t)),
            inSpace(R / m_reach.unit * m_rate.at(s, m_last) * quarterTurn(m_start + way), speed + m_acceleration * t)};
}

Place Pendulum::placeAt(double t) const {
    const auto [way, velocity] = at(t);
    if (!rolls()) return {way, velocity, m_lasting, t * m_lasting};
    const double R = m_moment.radius;
    return {way, velocity, m_lasting + glm::cross(m_track.normal, velocity) / R,
            t * m_lasting + glm::cross(m_track.normal, way) / R};
}

/// The acceleration changes by at most three times the strength times w, and w is largest at one of the ends: the ball
/// is slowest where it turns round or passes the top.
double Pendulum::least(const Vec3 &n, double, double t, double until) const {
    const double s = t / m_reach.unit, rate = m_rate.at(s, m_last);
    const double fastest = std::max(std::abs(rate), std::abs(m_rate.at(until / m_reach.unit, m_last)));
    const Vec2 normal = m_start + m_turned.at(s, m_last), tangent = quarterTurn(normal), along = across(n);
    const Vec2 acceleration = m_strength * ((glm::dot(m_pull, tangent) - m_against) * tangent - rate * rate * normal);
    return glm::dot(along, acceleration) + n[m_edge.axis] * m_acceleration -
           3.0 * m_strength * glm::length(along) * fastest * (until - t) / m_reach.unit;
}

/// By the conservation of energy the pressure changes by -3 g.(n - n0), and twice the work of resistance per radius.
End Pendulum::end(double until, Work &work) const {
    const double s = std::min(until / m_reach.unit, m_reach.length);
    Jet pressure{};
    pressure[0] = m_edge.pressure;
    for (int k = 1; k <= m_last; ++k) pressure[k] = -3.0 * drive() * glm::dot(m_pull, m_turned[k]);
    if (m_resistance != 0.0) {
        for (int k = 1; k <= m_last; ++k) pressure[k] += 2.0 * m_resistance * m_rate[k - 1] / k;
    }
    End end{horizon(), Cause::time, 0};
    end.cut({m_reach.unit * firstFall(pressure, s, work), Cause::release, m_edge.contact});
    if (m_resistance == 0.0) return end;
    Jet speed;
    for (int k = 0; k <= kOrder; ++k) speed[k] = std::copysign(1.0, m_resistance) * m_rate[k];
    end.cut({m_reach.unit * firstFall(speed, s, work), Cause::stop, m_track.contact});
    return end;
}

Losses Pendulum::losses(double t) const {
    return {0.0, m_moment.radius * m_resistance * m_rate.integralAt(t / m_reach.unit)};
}

} // namespace phys
