// SPDX-License-Identifier: MIT
#include "motion.h"

#include <algorithm>
#include <cmath>

namespace phys {

Motion::Motion(const Vec3 &p, const Vec3 &v, const Vec3 &a)
    : m_p(p)
    , m_v(v)
    , m_a(a) {}

Motion Motion::parabola(const Vec3 &p, const Vec3 &v, const Vec3 &a, double end) {
    Motion motion(p, v, a);
    motion.m_end = end;
    motion.m_most = glm::length(a);
    return motion;
}

Motion Motion::rolling(const Vec3 &p, const Vec3 &v, const Vec2 &A, double B) {
    if (B == 0.0) return parabola(p, v, Vec3(A, 0.0));
    Motion motion(p, v, Vec3(A, 0.0));
    motion.m_kind = Kind::rolling;
    motion.m_B = B;
    motion.m_law = ResistedLaw(inPlane(v), A, B);
    motion.m_end = motion.m_law.stopTime();
    motion.m_most = length(A) + B;
    return motion;
}

// model.md 3.6: v = q + (2/7) u, where q falls freely with (5/7) g_t whatever friction does, and u obeys the one law.
Motion Motion::slipping(const Vec3 &p, const Vec3 &v, const Vec2 &u, const Vec2 &A, double B) {
    Motion motion(p, v - 2.0 / 7.0 * Vec3(u, 0.0), 5.0 / 7.0 * Vec3(A, 0.0));
    motion.m_kind = Kind::slipping;
    motion.m_B = B;
    motion.m_law = ResistedLaw(u, A, B);
    motion.m_end = motion.m_law.stopTime();
    motion.m_most = length(A) + 2.0 / 7.0 * B;
    const double a = length(A), speed = length(u);
    motion.m_slipEnd = a > 0.0 ? A / a : u / speed;
    motion.m_slipStart = speed > 0.0 ? u / speed : motion.m_slipEnd;
    return motion;
}

ResistedLaw::Point Motion::slipAt(double t) const { return m_law.at(t); }

Motion::Point Motion::at(double t) const {
    const Point moved = since(t);
    return {m_p + moved.position, moved.velocity};
}

Motion::Point Motion::since(double t) const {
    if (t == 0.0 && m_kind == Kind::rolling) return {Vec3(0.0), m_v};
    if (m_kind == Kind::rolling) {
        const ResistedLaw::Point moved = m_law.at(t);
        return {Vec3(moved.x, 0.0), Vec3(moved.v, 0.0)};
    }
    const Point moved{t * (m_v + 0.5 * t * m_a), m_v + t * m_a};
    if (m_kind == Kind::parabola) return moved;
    const ResistedLaw::Point slip = slipAt(t);
    return {moved.position + 2.0 / 7.0 * Vec3(slip.x, 0.0), moved.velocity + 2.0 / 7.0 * Vec3(slip.v, 0.0)};
}

double Motion::path(double t) const {
    if (m_kind == Kind::rolling) return m_law.at(t).path;
    // Straight and without turning back: the way is the displacement.
    return glm::length(t * (m_v + 0.5 * t * m_a));
}

Vec3 Motion::startAcceleration() const {
    if (m_kind == Kind::parabola) return m_a;
    const double speed = glm::length(m_v);
    if (m_kind == Kind::rolling) return speed > 0.0 ? m_a - m_B / speed * m_v : m_a;
    return 7.0 / 5.0 * m_a - 2.0 / 7.0 * m_B * Vec3(m_slipStart, 0.0);
}

double Motion::leastAcceleration(const Vec3 &n, double rate) const {
    const double free = glm::dot(m_a, n);
    if (m_kind == Kind::parabola) return free;
    if (m_kind == Kind::slipping) return 7.0 / 5.0 * free - 2.0 / 7.0 * m_B * mostSlipAlong(inPlane(n));
    // n.v changes its sign at most once (model.md 3.5), and resistance helps a velocity towards n's back: while rate <=
    // 0 it only slows the fall, and a rate >= 0 under free >= 0 never falls.
    return rate <= 0.0 || free >= 0.0 ? free : free - m_B;
}

/// The direction of slip turns from where it starts towards A by the smaller angle, model.md 3.1: the largest part
/// along n that it takes on this way.
double Motion::mostSlipAlong(const Vec2 &n) const {
    const auto cross = [](const Vec2 &a, const Vec2 &b) { return a.x * b.y - a.y * b.x; };
    const double turn = cross(m_slipStart, m_slipEnd);
    const bool passes = turn == 0.0 ? glm::dot(m_slipStart, m_slipEnd) < 0.0
                                    : cross(m_slipStart, n) * turn >= 0.0 && cross(n, m_slipEnd) * turn >= 0.0;
    return passes ? 1.0 : std::max(glm::dot(m_slipStart, n), glm::dot(m_slipEnd, n));
}

} // namespace phys
