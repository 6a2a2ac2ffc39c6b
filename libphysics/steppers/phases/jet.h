// SPDX-License-Identifier: MIT
// Taylor series in one variable, of numbers and vectors.
#pragma once

#include "base/elementary.h"
#include "base/vec.h"
#include "contact/work.h"
#include "phases/phase.h"
#include "shared/first_zero.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace phys {

inline constexpr int kOrder = 24;
inline constexpr double kTail = 1e-17;     ///< relative size of the last terms
inline constexpr double kNoise = 1e-25;    ///< relative to the speeds: smaller terms are rounding
inline constexpr double kSlipEnds = 2e-13; ///< relative to the velocities whose difference a slip is

template<class T>
struct JetOf {
    std::array<T, kOrder + 1> c; ///< coefficients

    const T &operator[](int k) const { return c[static_cast<size_t>(k)]; }
    T &operator[](int k) { return c[static_cast<size_t>(k)]; }

    /// last: order of the last term that isn't zero.
    T at(double s, int last = kOrder) const {
        T sum = c[static_cast<size_t>(last)];
        for (int k = last - 1; k >= 0; --k) sum = sum * s + c[static_cast<size_t>(k)];
        return sum;
    }
    T rateAt(double s) const {
        T sum = double(kOrder) * c[kOrder];
        for (int k = kOrder - 1; k >= 1; --k) sum = sum * s + double(k) * c[static_cast<size_t>(k)];
        return sum;
    }
    /// An upper bound from 0 to s.
    double most(double s) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 0; --k) sum = sum * s + glm::length(c[static_cast<size_t>(k)]);
        return sum;
    }
    /// Integral from 0 to s.
    T integralAt(double s) const {
        T sum(0.0);
        for (int k = kOrder; k >= 0; --k) sum = s * (sum + c[static_cast<size_t>(k)] / (k + 1.0));
        return sum;
    }
};

using Jet = JetOf<double>;
using VecJet = JetOf<Vec3>;

/// Term k of a product; of vectors of their dot product.
template<class V>
V termOf(const Jet &a, const JetOf<V> &b, int k) {
    V sum(0.0);
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
}
inline double dotTerm(const VecJet &a, const VecJet &b, int k) {
    double sum = 0.0;
    for (int j = 0; j <= k; ++j) sum += glm::dot(a[j], b[k - j]);
    return sum;
}

/// constant + factor * a + b
inline Jet sum(double constant, double factor, const Jet &a, const Jet &b = {}) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = factor * a[k] + b[k];
    all[0] += constant;
    return all;
}
inline Jet product(const Jet &a, const Jet &b) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = termOf(a, b, k);
    return all;
}
inline Jet dot(const VecJet &a, const VecJet &b) {
    Jet all;
    for (int k = 0; k <= kOrder; ++k) all[k] = dotTerm(a, b, k);
    return all;
}

/// Term k of 1/f; inverse: its terms below.
inline double reciprocalTerm(const Jet &f, const Jet &inverse, int k) {
    if (k == 0) return 1.0 / f[0];
    double sum = 0.0;
    for (int j = 1; j <= k; ++j) sum += f[j] * inverse[k - j];
    return -sum / f[0];
}

/// Term k of the length of a vector with terms v[0], v[1], ...
template<class V>
double lengthTerm(const V *v, const Jet &length, int k) {
    if (k == 0) return glm::length(v[0]);
    // Twice the product of the length's first term and term k: v.v minus the known terms, in which pairs occur twice.
    double twice = glm::dot(v[0], v[k]);
    for (int j = 1; 2 * j < k; ++j) twice += glm::dot(v[j], v[k - j]) - length[j] * length[k - j];
    twice *= 2.0;
    if (k % 2 == 0) twice += glm::dot(v[k / 2], v[k / 2]) - length[k / 2] * length[k / 2];
    return 0.5 * twice / length[0];
}

/// Term k of quotient = v/f, if the ones below are known.
template<class V>
V quotientTerm(V rest, const Jet &f, const JetOf<V> &quotient, int k) {
    for (int j = 1; j <= k; ++j) rest -= f[j] * quotient[k - j];
    return rest / f[0];
}

/// Term k of the length of a vector with terms v[0], v[1], ..., and of its direction, whose term 0 is unchanged.
template<class V>
void addDirectionTerm(const V *v, int k, Jet &length, JetOf<V> &direction) {
    length[k] = lengthTerm(v, length, k);
    if (k > 0) direction[k] = quotientTerm(v[k], length, direction, k);
}

/// First s in [0, end] at which a polynomial falls through zero; kNever if there is none.
inline double firstFall(const Jet &g, double end, Work &work) {
    double others = 0.0, bend = 0.0;
    for (int k = kOrder; k >= 1; --k) others = (others + std::abs(g[k])) * end;
    if (g[0] > others) return kNever;
    for (int k = kOrder; k >= 2; --k) bend = bend * end + double(k * (k - 1)) * std::abs(g[k]);
    const double zero = 4.0 * 0x1p-52 * (std::abs(g[0]) + others);
    const auto look = [&](double s, double) {
        work.add(Work::kJet);
        return Look{g.at(s), g.rateAt(s), -bend};
    };
    return firstZero(look, 0.0, end, zero);
}

/// Where in [0, end] an increasing series of the time has the value t: Newton's method within a bracket, outside of
/// which the series mean nothing. pace: its rate in `unit`.
inline double placeOf(const Jet &time, const Jet &pace, double unit, double t, double end) {
    double low = 0.0, high = end, s = std::min(t / time[1], end);
    for (int i = 0; i < 60; ++i) {
        const double off = time.at(s) - t;
        (off < 0.0 ? low : high) = s;
        double next = s - off / (unit * pace.at(s));
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        if (std::abs(next - s) <= 0x1p-50 * s) return next;
        s = next;
    }
    return s;
}

/// How long series are valid, in units.
class Validity {
public:
    /// last: the order of the last terms.
    explicit Validity(int last)
        : m_last(last) {}

    /// noise: smaller terms are certainly rounding.
    template<class V>
    Validity &add(const JetOf<V> &f, double noise) {
        const double scale = std::max({noise, glm::length(f[0]), glm::length(f[1]), glm::length(f[2])});
        for (const int i : {0, 1}) {
            const double size = glm::length(f[m_last - i]);
            if (!std::isfinite(size)) m_powers[i] = 0.0; // the unit is much too long
            if (size > 0.0) m_powers[i] = std::min(m_powers[i], kTail * scale / size);
        }
        return *this;
    }

    double until() const {
        return std::min(elementary::root(m_powers[0], m_last), elementary::root(m_powers[1], m_last - 1));
    }

private:
    int m_last;
    double m_powers[2] = {kNever, kNever}; ///< of the last two orders
};

/// The time unit of series, and how far they are accurate to rounding.
struct Reach {
    double unit = 1.0;   ///< s, at the start
    double length = 0.0; ///< units

    /// valid: how far they would be valid, in units.
    void measure(double valid) { length = std::min(0.8 * valid, 4.0); }
};

/// When a speed falls to zero, in units. If its direction turns until the end, the series never reach that time: the
/// remainder of a sufficiently small speed is assumed to fall at the present rate.
End zeroOfSpeed(const Jet &speed, double until, const Reach &reach, double small, Cause cause, uint32_t contact,
                Work &work);

/// When a slip ends, in units. If the slip passes close to zero and friction hardly turns it, the series of its speed
/// are valid for a shorter time than those of the slip: the phase ends with them. noise: as for Validity::add.
End endOfSlip(const Jet &speed, double until, const Reach &reach, double small, double noise, uint32_t contact,
              Work &work);

} // namespace phys
