// SPDX-License-Identifier: MIT
#include "phases/slide.h"

#include <algorithm>

namespace phys {

// The pressure on the rough face is constant, the smooth face balances the forces across it. Friction -B d, B = mu N,
// changes the slip by (-5/2 B d_x, g - 7/2 B d_y), and v = q + (2/7) u along both, where q grows by (5/7) g.
Slide::Slide(const Moment &moment, const Faces &faces, const Vec3 &normal, const Reaction &rough, double friction,
             const Reaction &smooth)
    : m_faces(faces)
    , m_along(3 - faces.roughAxis - faces.smoothAxis)
    , m_normal(normal)
    , m_spin(moment.spin)
    , m_radius(moment.radius)
    , m_small(kSlipEnds * speedScale(moment))
    , m_limitOfFriction(friction * rough.pressure)
    , m_g(moment.gravity[m_along]) {
    const double B = m_limitOfFriction;
    m_u[0] = {rough.slip[faces.smoothAxis], rough.slip[m_along]};
    m_d[0] = {rough.direction[faces.smoothAxis], rough.direction[m_along]};
    m_reach.unit = glm::length(m_u[0]) / (3.5 * B + std::abs(m_g));
    for (int k = 0; k <= kOrder; ++k) {
        addDirectionTerm(m_u.c.data(), k, m_speed, m_d);
        if (k == kOrder) break;
        const Vec2 gravity(0.0, k == 0 ? m_g : 0.0);
        m_u[k + 1] = unit() / (k + 1) * (gravity - B * Vec2(2.5, 3.5) * m_d[k]);
    }
    // The slip needs only the accuracy of the velocities whose difference it is.
    m_fast = std::min(glm::length(moment.velocity), m_radius * glm::length(m_spin));
    m_reach.measure(validUntil(m_u, kOrder, m_fast));
    m_rolling = moment.velocity[m_along] - 2.0 / 7.0 * m_u[0].y;
    m_start = m_g - B * m_d[0].y;
    m_limit = m_g - std::clamp(m_g, -B, B);
    const double side = smooth.force[faces.smoothAxis] > 0.0 ? B : -B;
    for (int k = 0; k <= kOrder; ++k) m_pressure[k] = side * m_d[k].x;
    m_pressure[0] = smooth.pressure;
}

Way Slide::at(double t) const {
    const double s = t / unit();
    Way now{Vec3(0.0), Vec3(0.0)};
    now.way[m_along] = t * (m_rolling + 5.0 / 14.0 * m_g * t) + 2.0 / 7.0 * unit() * m_u.integralAt(s).y;
    now.velocity[m_along] = m_rolling + 5.0 / 7.0 * m_g * t + 2.0 / 7.0 * m_u.at(s).y;
    return now;
}

Place Slide::placeAt(double t) const {
    const auto [way, velocity] = at(t);
    const Vec2 u = m_u.at(t / unit());
    Vec3 rolls = velocity; // the velocity that corresponds to the spin
    rolls[m_faces.smoothAxis] -= u.x;
    rolls[m_along] -= u.y;
    return {way, velocity, glm::dot(m_spin, m_normal) * m_normal + glm::cross(m_normal, rolls) / m_radius};
}

/// The slip's direction turns monotonically to where friction balances gravity along both faces.
double Slide::least(const Vec3 &n, double, double, double) const {
    return std::min(n[m_along] * m_start, n[m_along] * m_limit);
}

End Slide::end(double until, Work &work) const {
    End end{m_reach.horizon, Cause::time, 0};
    const double s = std::min(until, m_reach.horizon) / unit();
    end.cut({unit() * firstFall(m_pressure, s, work), Cause::release, m_faces.smooth});
    if (m_limitOfFriction > 0.0) end.cut(endOfSlip(m_speed, s, m_reach, m_small, m_fast, m_faces.rough, work));
    return end;
}

} // namespace phys
