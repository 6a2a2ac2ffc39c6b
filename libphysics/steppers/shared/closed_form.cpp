// SPDX-License-Identifier: MIT
#include "shared/closed_form.h"

#include "base/elementary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace phys {

namespace {

/// Two numbers that are computed together, in one SIMD register where processors have them.
using Two = double __attribute__((vector_size(16)));

inline double sum(Two numbers) { return numbers[0] + numbers[1]; }

inline Two pairOf(const Vec2 &v) { return Two{v.x, v.y}; }
/// Stored together, as a processor stalls if it loads together what was just stored separately.
inline Vec2 vectorOf(Two pair) { return std::bit_cast<Vec2>(pair); }
/// From the axes along and across e to x and y.
inline Two turned(const Vec2 &e, double along, double across) { return along * pairOf(e) + across * Two{-e.y, e.x}; }

/// Most steps are short compared with the time in which velocities change, so a few terms suffice.
bool isShort(double z) { return std::abs(z) <= 0.3; }

/// (exp(z) - 1)/z for small z: the sum of z^k/(k + 1)!, in groups of four, so that terms are computed in parallel.
template<class N>
inline N growth(N z) {
    const N z2 = z * z, z4 = z2 * z2;
    const N first = (1.0 + z * (1.0 / 2.0)) + z2 * (1.0 / 6.0 + z * (1.0 / 24.0));
    const N second = (1.0 / 120.0 + z * (1.0 / 720.0)) + z2 * (1.0 / 5040.0 + z * (1.0 / 40320.0));
    const N third = (1.0 / 362880.0 + z * (1.0 / 3628800.0)) + z2 * (1.0 / 39916800.0 + z * (1.0 / 479001600.0));
    return first + z4 * (second + z4 * (third + z4 * (1.0 / 6227020800.0)));
}

/// I(c) = integral of exp(c s) from 0 to xi.
double integral(double c, double xi) {
    const double z = c * xi;
    return isShort(z) ? xi * growth(z) : elementary::expm1(z) / c;
}

/// The integrals of two exponentials.
struct Integrals {
    static double of(double c, double xi) { return integral(c, xi); }
    static Two of(Two c, double xi) { return Two{integral(c[0], xi), integral(c[1], xi)}; }
};
/// The same if all c xi are small.
struct ShortIntegrals {
    template<class N>
    static N of(N c, double xi) {
        return xi * growth(c * xi);
    }
};

/// An integral at xi - back, where back^3 is negligible, so that the computation needn't wait for `back`.
template<class N>
inline N shifted(N c, N integral, double back) {
    return integral - back * (1.0 + c * integral) * (1.0 - 0.5 * c * back);
}

/// xi at which share * I(c) = t, where share * I(c) is one of the two positive parts of t(xi): an upper bound for xi.
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
    const double top = rate / -acceleration; // the products underflow: use times instead
    return top + std::sqrt(top * top + 2.0 * (gap / -acceleration));
}

ResistedLaw::ResistedLaw(const Vec2 &v0, const Vec2 &A, double B) { begin(v0, A, B); }

/// Where the constructor is called instead, the most frequent step takes 25 instructions more.
inline void ResistedLaw::begin(const Vec2 &v0, const Vec2 &A, double B) {
    m_v0 = v0;
    m_a = length(A);
    m_B = B;
    m_speed = length(v0);
    m_drive = A.x * v0.x + A.y * v0.y;
    if (m_speed < std::numeric_limits<double>::min()) {
        // From rest, or a speed without digits, the motion is straight along A, model.md 3.2.
        m_fromRest = true;
        if (m_a > 0.0) m_e = A / m_a;
        if (m_a <= B) m_stopTime = 0.0;
        return;
    }
    m_e = m_a > 0.0 ? A / m_a : v0 / m_speed;
    const double along = v0.x * m_e.x + v0.y * m_e.y;
    m_vt = m_e.x * v0.y - m_e.y * v0.x;
    // The smaller of P and M follows from P M = v_t^2/4, without cancellation.
    const double larger = 0.5 * (m_speed + std::abs(along));
    const double smaller = larger > 0.0 ? 0.25 * m_vt * (m_vt / larger) : 0.0;
    m_P = along >= 0.0 ? larger : smaller;
    m_M = along >= 0.0 ? smaller : larger;
    // model.md 3.2: if the drive is below the resistance, the ball stops; above it, only if it moves exactly against A.
    if (m_B > m_a) {
        m_stopTime = m_P / (m_B - m_a) + m_M / (m_B + m_a);
    } else if (m_P == 0.0) {
        m_stopTime = m_M / (m_B + m_a);
    }
}

/// A moment: xi - back, and the integrals at xi of which the time is composed.
struct ResistedLaw::Passed {
    double xi, back; ///< s^2/m
    Two integrals;   ///< s^2/m: I(a - B), I(-a - B)
    double excess;   ///< s, of the time at xi; far from the zero, `back` may have the other sign
};

/// The two parts of the time, of the speed and of the way.
struct ResistedLaw::Shares {
    Two times, speeds, ways;
};

/// A starting value for short times: the inverse of the first four terms of t(xi). -1 if the time isn't short.
inline double ResistedLaw::shortXi(double t) const {
    const double perSpeed = 1.0 / m_speed, tau = t * perSpeed;
    if (!((m_a + m_B) * tau < 0.3)) return -1.0;
    // The derivatives of |v| with respect to xi at the start, in units of |v| and tau.
    const double damping = 2.0 * m_B * tau, growing = (m_a - m_B) * (m_a + m_B) * (tau * tau);
    const double first = (m_drive * perSpeed - m_B) * tau, second = growing - damping * first;
    const double third = growing * first - damping * second;
    const double q = first * (1.0 / 2.0), w = second * (1.0 / 6.0), y = third * (1.0 / 24.0);
    return tau * ((1.0 - q) + (2.0 * q * q - w) + (5.0 * q * (w - q * q) - y));
}

/// One of Chebyshev's steps for t(xi), which is strictly increasing, dt/dxi = |v|.
template<class Of>
inline ResistedLaw::Passed ResistedLaw::improve(double xi, double t) const {
    const Two share{m_P, m_M}, c{m_a - m_B, -(m_a + m_B)}, integrals = Of::of(c, xi);
    const double excess = sum(share * integrals) - t;
    const Two parts = share + share * (c * integrals); // of |v|
    const double perSpeed = 1.0 / sum(parts), newton = excess * perSpeed;
    return {xi, newton * (1.0 + 0.5 * newton * sum(c * parts) * perSpeed), integrals, excess};
}

/// Most steps: short compared with the time in which velocities change.
inline bool ResistedLaw::passShortTime(double t, Passed &out) const {
    double xi = shortXi(t);
    for (int iteration = 0; iteration < 3; ++iteration) {
        if (!(xi >= 0.0 && isShort((m_a + 2.0 * m_B) * xi))) return false;
        out = improve<ShortIntegrals>(xi, t);
        if (isLast(out)) return true;
        xi -= out.back;
    }
    return false;
}

/// Chebyshev's method inside the bracket of model.md 3.4.
ResistedLaw::Passed ResistedLaw::passAnyTime(double t) const {
    const double c1 = m_a - m_B, c2 = -(m_a + m_B);
    double low = 0.0, high = kNever, xi = shortXi(t);
    if (xi < 0.0) {
        high = std::min(xiOfShare(m_P, c1, t), xiOfShare(m_M, c2, t));
        // The remaining time to the stop decreases at least like e^(-(B-a) xi).
        if (m_B > m_a) high = std::min(high, elementary::log1p(-t / m_stopTime) / c1);
        xi = high;
    }
    for (int iteration = 0; iteration < 60; ++iteration) {
        const Passed passed = improve<Integrals>(xi, t);
        if (isLast(passed)) return passed;
        (passed.excess > 0.0 ? high : low) = xi;
        const double next = xi - passed.back;
        xi = next > low && next < high ? next : 0.5 * (low + high);
    }
    return {xi, 0.0, Integrals::of(Two{c1, c2}, xi), 0.0};
}

/// Convergence is cubic: after a step this small the next one is below rounding.
inline bool ResistedLaw::isLast(const Passed &passed) const {
    const double size = std::abs(passed.back);
    return passed.back <= passed.xi && size <= 4e-6 * passed.xi && size * (m_a + m_B) <= 4e-6;
}

inline ResistedLaw::Shares ResistedLaw::sharesAt(const Passed &passed, double t) const {
    const Two share{m_P, m_M}, c{m_a - m_B, -(m_a + m_B)};
    Two times = share * shifted(c, passed.integrals, passed.back);
    // Computed from the time itself: after a long growth e^(c xi) has lost digits.
    if (m_a > m_B && times[1] < 0.5 * t) times[0] = t - times[1];
    const Two speeds = share + c * times;
    // P^2 I(2c) = (P I(c)) (P + P e^(c xi))/2: time share times mean speed, which neither overflows nor underflows.
    return {times, speeds, times * (0.5 * (share + speeds))};
}

template<class Of>
inline ResistedLaw::Point ResistedLaw::atXi(const Passed &passed, double t) const {
    const double xi = passed.xi, back = passed.back;
    const auto [times, speeds, ways] = sharesAt(passed, t);
    const Two share{m_P, m_M}, c{m_a - m_B, -(m_a + m_B)}, c3{m_a - 2.0 * m_B, -(m_a + 2.0 * m_B)};
    const Two x = turned(m_e, ways[0] - ways[1], m_vt * sum(share * shifted(c3, Of::of(c3, xi), back)));
    if (!((m_a + m_B) * xi < 0.5)) {
        const Two v = turned(m_e, speeds[0] - speeds[1], m_vt * elementary::exp(-m_B * (xi - back)));
        return {vectorOf(x), vectorOf(v)};
    }
    // While the velocity changes little, its change is known more accurately than itself: many short phases keep their
    // digits.
    const Two change = c * times;
    const double damping = shifted(-m_B, Of::of(-m_B, xi), back);
    const Two v = pairOf(m_v0) + turned(m_e, change[0] - change[1], m_vt * (-m_B * damping));
    return {vectorOf(x), vectorOf(v)};
}

template<class Of>
inline double ResistedLaw::pathAtXi(const Passed &passed, double t) const {
    const Two ways = sharesAt(passed, t).ways;
    const double damping = shifted(-m_B, Of::of(-m_B, passed.xi), passed.back);
    return ways[0] + 2.0 * m_P * m_M * (damping * (1.0 - 0.5 * m_B * damping)) + ways[1];
}

ResistedLaw::Point ResistedLaw::at(double t) const {
    if (t >= m_stopTime) return atStop();
    if (m_fromRest) {
        const double speed = (m_a - m_B) * t;
        return {0.5 * t * speed * m_e, speed * m_e};
    }
    Passed passed;
    return passShortTime(t, passed) ? atXi<ShortIntegrals>(passed, t) : atXi<Integrals>(passAnyTime(t), t);
}

double ResistedLaw::pathUntil(double t) const {
    if (t >= m_stopTime) return pathToStop();
    if (m_fromRest) return 0.5 * t * ((m_a - m_B) * t);
    Passed passed;
    if (passShortTime(t, passed)) return pathAtXi<ShortIntegrals>(passed, t);
    return pathAtXi<Integrals>(passAnyTime(t), t);
}

bool ResistedLaw::goesOn(const Vec2 &v0, const Vec2 &A, double B, double t, Point &out) {
    ResistedLaw law;
    law.begin(v0, A, B);
    if (law.m_fromRest || !(t < law.m_stopTime)) return false;
    Passed passed; // the usual law needs no address, only registers
    out = law.passShortTime(t, passed) ? law.atXi<ShortIntegrals>(passed, t) : ResistedLaw(v0, A, B).at(t);
    return true;
}

ResistedLaw::Point ResistedLaw::atStop() const {
    const Vec2 zero{0.0, 0.0};
    if (m_fromRest) return {zero, zero};
    const double alongSlow = m_M * m_M / (2.0 * (m_B + m_a));
    if (!(m_B > m_a)) return {vectorOf(turned(m_e, -alongSlow, 0.0)), zero};
    const double alongFast = m_P * m_P / (2.0 * (m_B - m_a));
    const double across = m_vt * (m_P / (2.0 * m_B - m_a) + m_M / (2.0 * m_B + m_a));
    return {vectorOf(turned(m_e, alongFast - alongSlow, across)), zero};
}

double ResistedLaw::pathToStop() const {
    if (m_fromRest) return 0.0;
    const double alongSlow = m_M * m_M / (2.0 * (m_B + m_a));
    return m_B > m_a ? m_P * m_P / (2.0 * (m_B - m_a)) + m_P * m_M / m_B + alongSlow : alongSlow;
}

} // namespace phys
