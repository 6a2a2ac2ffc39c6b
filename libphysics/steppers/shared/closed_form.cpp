// SPDX-License-Identifier: MIT
#include "shared/closed_form.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace phys {

namespace {

/// exp(z) - 1. Most steps are short against the times in which velocities change: there a few terms do.
double expm1(double z) {
    if (std::abs(z) > 0.04) return elementary::expm1(z);
    double sum = 1.0 / 362880.0; // of z^k / (k + 1)!
    for (const double factorial : {40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0}) sum = sum * z + 1.0 / factorial;
    return z * sum;
}

/// I(c) = integral of exp(c s) from 0 to xi, given expm1(c xi).
double integral(double c, double xi, double expm1OfCXi) {
    const double z = c * xi;
    // Below, expm1(z)/z is 1 to the last bit, and c may be 0.
    return std::abs(z) < 1e-17 ? xi : expm1OfCXi / c;
}

double integral(double c, double xi) { return integral(c, xi, expm1(c * xi)); }

/// xi at which share * I(c) = t, where share * I(c) is one of the two positive parts of t(xi): an upper bound of xi.
double xiOfShare(double share, double c, double t) {
    const double z = c * t / share;
    if (!(share > 0.0) || z <= -1.0) return kNever;
    return std::abs(z) < 1e-17 ? t / share : elementary::log1p(z) / c;
}

} // namespace

double length(const Vec2 &v) {
    const double squares = v.x * v.x + v.y * v.y;
    if (squares > 1e-280 && squares < 1e280) return std::sqrt(squares);
    return elementary::hypot(v.x, v.y);
}

double firstFall(double gap, double rate, double acceleration) {
    if (rate < 0.0) {
        const double discriminant = rate * rate - 2.0 * acceleration * gap;
        return discriminant < 0.0 ? kNever : 2.0 * gap / (std::sqrt(discriminant) - rate);
    }
    if (acceleration >= 0.0) return kNever;
    const double squaredEnd = rate * rate - 2.0 * acceleration * gap;
    if (squaredEnd >= std::numeric_limits<double>::min()) return (rate + std::sqrt(squaredEnd)) / -acceleration;
    const double top = rate / -acceleration; // the products underflow: by times instead
    return top + std::sqrt(top * top + 2.0 * (gap / -acceleration));
}

ResistedLaw::ResistedLaw(const Vec2 &v0, const Vec2 &A, double B)
    : m_v0(v0)
    , m_a(length(A))
    , m_B(B) {
    const double speed = length(v0);
    if (speed == 0.0) {
        // From rest the way is straight along A, model.md 3.2.
        m_fromRest = true;
        if (m_a > 0.0) m_e = A / m_a;
        if (m_a <= B) m_stopTime = 0.0;
        return;
    }
    m_e = m_a > 0.0 ? A / m_a : v0 / speed;
    const double along = v0.x * m_e.x + v0.y * m_e.y;
    m_vt = m_e.x * v0.y - m_e.y * v0.x;
    // The smaller of P and M from P M = v_t^2/4: no cancellation.
    const double larger = 0.5 * (speed + std::abs(along));
    const double smaller = larger > 0.0 ? 0.25 * m_vt * (m_vt / larger) : 0.0;
    m_P = along >= 0.0 ? larger : smaller;
    m_M = along >= 0.0 ? smaller : larger;
    // model.md 3.2: below its resistance the ball stops, above it only if it runs exactly against A.
    if (m_B > m_a) {
        m_stopTime = m_P / (m_B - m_a) + m_M / (m_B + m_a);
    } else if (m_P == 0.0) {
        m_stopTime = m_M / (m_B + m_a);
    }
}

ResistedLaw::Point ResistedLaw::at(double t) const {
    if (t >= m_stopTime) return atStop();
    if (m_fromRest) {
        const double speed = (m_a - m_B) * t;
        return {0.5 * t * speed * m_e, speed * m_e, 0.5 * t * speed};
    }
    return atXi(xiAt(t), t);
}

/// A start for a time that is short: the inverse of t = s xi + q xi^2/2 + w xi^3/6. -1 for a time that isn't.
double ResistedLaw::shortXi(double t) const {
    const double c1 = m_a - m_B, c2 = -(m_a + m_B), s = m_P + m_M;
    const double tau = t / s;
    if (!(-c2 * tau < 0.1)) return -1.0;
    const double q = (c1 * m_P + c2 * m_M) / s, w = (c1 * c1 * m_P + c2 * c2 * m_M) / s;
    return tau * (1.0 + tau * (-0.5 * q + tau * (0.5 * q * q - w / 6.0)));
}

/// Newton's method inside the bracket of model.md 3.4: t(xi) rises strictly, dt/dxi = |v|.
double ResistedLaw::xiAt(double t) const {
    const double c1 = m_a - m_B, c2 = -(m_a + m_B);
    double low = 0.0, high = kNever, xi = shortXi(t);
    if (xi < 0.0) {
        high = std::min(xiOfShare(m_P, c1, t), xiOfShare(m_M, c2, t));
        // What is left of the time to the stop shrinks at least like e^(-(B-a) xi).
        if (m_B > m_a) high = std::min(high, elementary::log1p(-t / m_stopTime) / c1);
        xi = high;
    }
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double e1 = expm1(c1 * xi), e2 = expm1(c2 * xi);
        const double excess = m_P * integral(c1, xi, e1) + m_M * integral(c2, xi, e2) - t;
        const double fast = m_P * (1.0 + e1), slow = m_M * (1.0 + e2); // |v| and A.v - B|v| are made of them
        const double speed = fast + slow;
        (excess > 0.0 ? high : low) = xi;
        // Halley's step: t'' = c1 P e^(c1 xi) + c2 M e^(c2 xi).
        const double newton = excess / speed;
        const double halley = newton / (1.0 - 0.5 * newton * (c1 * fast + c2 * slow) / speed);
        const double next = xi - halley;
        // Convergence is cubic: the step after one so small is below rounding.
        if (std::abs(halley) <= 1e-6 * std::min(xi, -1.0 / c2)) return std::max(0.0, next);
        xi = next > low && next < high ? next : 0.5 * (low + high);
    }
    return xi;
}

ResistedLaw::Point ResistedLaw::atXi(double xi, double t) const {
    const double c1 = m_a - m_B, c2 = -(m_a + m_B);
    const double e1 = expm1(c1 * xi), e2 = expm1(c2 * xi);
    const double slow = m_M + m_M * e2, slowTime = m_M * integral(c2, xi, e2);
    double fastTime = m_P * integral(c1, xi, e1), fast = m_P + m_P * e1;
    if (c1 > 0.0 && slowTime < 0.5 * t) {
        // The same from the time itself: after a long growth e^(c1 xi) has lost digits.
        fastTime = t - slowTime;
        fast = m_P + c1 * fastTime;
    }
    // P^2 I(2c) = (P I(c)) (P + P e^(c xi))/2: time share times mean speed, which neither over- nor underflows.
    const double alongFast = fastTime * (0.5 * (m_P + fast));
    const double alongSlow = slowTime * (0.5 * (m_M + slow));
    const double across = m_vt * (m_P * integral(m_a - 2.0 * m_B, xi) + m_M * integral(-m_a - 2.0 * m_B, xi));
    const double mixed = 2.0 * m_P * m_M * integral(-2.0 * m_B, xi);
    // While the velocity changes little, its change is known better than itself: many short phases keep their digits.
    const Vec2 v = -c2 * xi < 0.5 ? m_v0 + turned(c1 * fastTime - c2 * slowTime, m_vt * expm1(-m_B * xi))
                                  : turned(fast - slow, m_vt * elementary::exp(-m_B * xi));
    return {turned(alongFast - alongSlow, across), v, alongFast + mixed + alongSlow};
}

ResistedLaw::Point ResistedLaw::atStop() const {
    const Vec2 zero{0.0, 0.0};
    if (m_fromRest) return {zero, zero, 0.0};
    const double alongSlow = m_M * m_M / (2.0 * (m_B + m_a));
    if (!(m_B > m_a)) return {turned(-alongSlow, 0.0), zero, alongSlow};
    const double alongFast = m_P * m_P / (2.0 * (m_B - m_a));
    const double across = m_vt * (m_P / (2.0 * m_B - m_a) + m_M / (2.0 * m_B + m_a));
    return {turned(alongFast - alongSlow, across), zero, alongFast + m_P * m_M / m_B + alongSlow};
}

Vec2 ResistedLaw::turned(double along, double across) const {
    return {along * m_e.x - across * m_e.y, along * m_e.y + across * m_e.x};
}

} // namespace phys
