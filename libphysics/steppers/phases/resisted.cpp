// SPDX-License-Identifier: MIT
#include "phases/resisted.h"

#include <algorithm>
#include <cmath>

namespace phys {

Vec2 Resisted::onFace(const Vec3 &v) const {
    if (m_face.axis == 2) return {v.x, v.y};
    return {m_face.axis == 0 ? v.y : v.x, v.z};
}

Vec3 Resisted::inSpace(const Vec2 &v) const {
    if (m_face.axis == 2) return {v.x, v.y, 0.0};
    return m_face.axis == 0 ? Vec3(0.0, v.x, v.y) : Vec3(v.x, 0.0, v.y);
}

Resisted::Resisted(const Moment &moment, const Face &face, double B, const Vec3 &A)
    : m_face(face)
    , m_velocity(moment.velocity)
    , m_spin(moment.spin)
    , m_A(A)
    , m_B(B)
    , m_radius(moment.radius) {
    m_A[face.axis] = 0.0;
}

Resisted Resisted::rolling(const Moment &moment, const Face &face, double B) {
    Resisted phase(moment, face, B, 5.0 / 7.0 * moment.gravity);
    const Vec2 A = phase.onFace(phase.m_A);
    phase.m_law = ResistedLaw(phase.onFace(moment.velocity), A, B);
    phase.m_most = length(A) + B;
    return phase;
}

// v = q + (2/7) u, where q grows by (5/7) g_t whatever friction does, and u obeys the law of smooth motion.
Resisted Resisted::slipping(const Moment &moment, const Face &face, const Vec3 &slip, double friction) {
    Resisted phase(moment, face, 3.5 * friction, moment.gravity);
    phase.m_slips = true;
    phase.m_q = moment.velocity - 2.0 / 7.0 * slip;
    phase.m_qRate = 5.0 / 7.0 * phase.m_A;
    const Vec2 u = phase.onFace(slip), A = phase.onFace(phase.m_A);
    phase.m_law = ResistedLaw(u, A, phase.m_B);
    const double a = length(A), speed = length(u);
    phase.m_most = a + friction;
    phase.m_slipEnd = a > 0.0 ? A / a : u / speed;
    phase.m_slipStart = speed > 0.0 ? u / speed : phase.m_slipEnd;
    return phase;
}

const ResistedLaw::Point &Resisted::lawAt(double t) const {
    if (m_known[m_newest].time != t) m_newest = 1 - m_newest;
    Known &known = m_known[m_newest];
    if (known.time != t) known = {t, m_law.at(t)};
    return known.point;
}

Way Resisted::at(double t) const {
    if (t == 0.0) return {Vec3(0.0), m_velocity};
    const ResistedLaw::Point &point = lawAt(t);
    if (!m_slips) return {inSpace(point.x), inSpace(point.v)};
    return {t * (m_q + 0.5 * t * m_qRate) + 2.0 / 7.0 * inSpace(point.x),
            m_q + t * m_qRate + 2.0 / 7.0 * inSpace(point.v)};
}

Place Resisted::placeAt(double t) const {
    if (t == 0.0) return {Vec3(0.0), m_velocity, m_spin, Vec3(0.0)};
    const Way now = at(t);
    Way rolls = now;
    if (m_slips) {
        const auto &[x, v] = lawAt(t);
        rolls = {t * (m_q + 0.5 * t * m_qRate) - 5.0 / 7.0 * inSpace(x), m_q + t * m_qRate - 5.0 / 7.0 * inSpace(v)};
    }
    return rolledPlace(now, rolls, m_face.normal, glm::dot(m_spin, m_face.normal) * m_face.normal, m_radius, t);
}

Vec3 Resisted::accelerationAt(double t, const Vec3 &velocity) const {
    if (!m_slips) return m_A - m_B / glm::length(velocity) * velocity;
    const Vec2 slip = t == 0.0 ? m_slipStart : lawAt(t).v;
    return m_A - 2.0 / 7.0 * m_B / length(slip) * inSpace(slip);
}

/// The rate of a rolling ball changes its sign at most once (model.md 3.5), and resistance to a motion against n acts
/// along n: while rate <= 0 it only slows the fall, and with rate >= 0 and A.n >= 0 the ball never moves against n.
double Resisted::leastAcceleration(const Vec3 &n, double rate) const {
    const double free = glm::dot(m_A, n);
    if (m_slips) return free - 2.0 / 7.0 * m_B * mostSlipAlong(onFace(n));
    return rate <= 0.0 || free >= 0.0 ? free : free - m_B;
}

double Resisted::least(const Vec3 &n, double rate, double t, double until) const {
    const double least = leastAcceleration(n, rate);
    if (m_slips) return 32.0 * rate < -least * (until - t) && leaves(n, t, until) ? 0.0 : least;
    if (rate <= 0.0 || least >= 0.0) return least;
    // Nor does it move against n if the end lies ahead along n: tested only where the bound would lead to tiny steps.
    const bool lasts = 32.0 * rate < -least * (until - t) && glm::dot(n, at(until).way - at(t).way) >= 0.0;
    return lasts ? 0.0 : least;
}

/// Whether a slipping ball moves along n throughout: the rolling velocity that it approaches does, and the slip's
/// component along n changes its sign at most once (model.md 3.5).
bool Resisted::leaves(const Vec3 &n, double t, double until) const {
    const auto leavesAt = [&](double moment) {
        const double q = glm::dot(n, m_q + moment * m_qRate);
        return q >= 0.0 && glm::dot(n, inSpace(lawAt(moment).v)) >= 0.0;
    };
    return leavesAt(t) && leavesAt(until);
}

/// The slip's direction turns from its start towards A by the smaller angle, model.md 3.1. This is its largest
/// component along n on the way.
double Resisted::mostSlipAlong(const Vec2 &n) const {
    const auto cross = [](const Vec2 &a, const Vec2 &b) { return a.x * b.y - a.y * b.x; };
    const double turn = cross(m_slipStart, m_slipEnd);
    const bool passes = turn == 0.0 ? glm::dot(m_slipStart, m_slipEnd) < 0.0
                                    : cross(m_slipStart, n) * turn >= 0.0 && cross(n, m_slipEnd) * turn >= 0.0;
    return passes ? glm::length(n) : std::max(glm::dot(m_slipStart, n), glm::dot(m_slipEnd, n));
}

Losses Resisted::losses(double t) const {
    const double path = m_law.pathUntil(t);
    return m_slips ? Losses{m_B / 3.5 * path, 0.0} : Losses{0.0, 1.4 * m_B * path};
}

} // namespace phys
