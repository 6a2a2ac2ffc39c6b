// SPDX-License-Identifier: MIT
// Taylor series in one variable, built term by term: the recurrences of a product, a quotient and a square root.
#pragma once

#include "base/elementary.h"
#include "scene/scene.h"
#include "shared/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace phys {

struct Taylor {
    static constexpr int kOrder = 24;

    std::array<double, kOrder + 1> c{};

    double operator[](int k) const { return c[static_cast<size_t>(k)]; }
    double &operator[](int k) { return c[static_cast<size_t>(k)]; }

    double at(double s) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 0; --k) sum = sum * s + c[static_cast<size_t>(k)];
        return sum;
    }
    double rateAt(double s) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 1; --k) sum = sum * s + k * c[static_cast<size_t>(k)];
        return sum;
    }
    /// Bound of |f''| on [0, s].
    double mostBend(double s) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 2; --k) sum = sum * s + k * (k - 1) * std::abs(c[static_cast<size_t>(k)]);
        return sum;
    }
    /// Bound of |f| on [0, s].
    double most(double s) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 0; --k) sum = sum * s + std::abs(c[static_cast<size_t>(k)]);
        return sum;
    }
    /// Longest s up to which the last two terms stay below `size`.
    double goodFor(double size) const {
        const double last = std::abs(c[kOrder]), next = std::abs(c[kOrder - 1]);
        return std::min(last > 0.0 ? elementary::root(size / last, kOrder) : kNever,
                        next > 0.0 ? elementary::root(size / next, kOrder - 1) : kNever);
    }
};

inline Taylor operator*(double factor, const Taylor &f) {
    Taylor product;
    for (int k = 0; k <= Taylor::kOrder; ++k) product[k] = factor * f[k];
    return product;
}

/// What f leaves of a whole.
inline Taylor remains(double whole, const Taylor &f) {
    Taylor left = -1.0 * f;
    left[0] += whole;
    return left;
}

/// The largest power of two up to a size: a unit for it that costs no rounding.
inline double unitOf(double size) { return size > 0.0 ? std::ldexp(1.0, std::ilogb(size)) : 1.0; }

/// Term k of a b.
inline double productTerm(const Taylor &a, const Taylor &b, int k) {
    double sum = 0.0;
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
}

/// Term k of a / b = quotient, whose terms before k are known; b[0] != 0.
inline double quotientTerm(const Taylor &a, const Taylor &b, const Taylor &quotient, int k) {
    double sum = a[k];
    for (int j = 0; j < k; ++j) sum -= quotient[j] * b[k - j];
    return sum / b[0];
}

/// Term k > 0 of the root of a square, whose terms before k are known; root[0] != 0.
inline double rootTerm(const Taylor &square, const Taylor &root, int k) {
    double sum = square[k];
    for (int j = 1; j < k; ++j) sum -= root[j] * root[k - j];
    return sum / (2.0 * root[0]);
}

/// First s in [0, end] at which f falls through zero, f(0) >= 0; kNever if it doesn't. By the advancement of
/// model.md 5.2, which passes no crossing over; the bound of f'' holds for a window that is as wide as steps allow.
inline double firstFall(const Taylor &f, double end) {
    double window = end, bend = f.mostBend(window);
    for (double s = 0.0; s <= end;) {
        const double value = f.at(s), rate = f.rateAt(s);
        const bool isZero = value <= 4.0 * kRounding * f.most(s);
        const double step = firstFall(std::max(0.0, value), rate, -bend);
        if (rate < 0.0 && (isZero || s + step == s)) return std::min(end, s + step);
        if (step < 0x1p-6 * window && window > 2.0 * s && window > 0x1p-60 * end) {
            window *= 0.5;
            bend = f.mostBend(window);
            continue;
        }
        // A start from zero and at rest is left by a step too short to matter.
        s = std::min(s + std::max(step, s + step > s ? 0.0 : 0x1p-12 * end), window < end ? window : kNever);
        if (s < window) continue;
        window = std::min(end, 2.0 * window);
        bend = f.mostBend(window);
    }
    return kNever;
}

} // namespace phys
