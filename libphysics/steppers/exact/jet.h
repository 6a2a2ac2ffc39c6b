// SPDX-License-Identifier: MIT
// Taylor series in one variable, of numbers and of vectors.
#pragma once

#include "base/vec.h"
#include "contact/work.h"
#include "shared/first_zero.h"

#include <array>
#include <cmath>

namespace phys {

inline constexpr int kOrder = 24;

template<class T>
struct JetOf {
    std::array<T, kOrder + 1> c; ///< coefficients

    const T &operator[](int k) const { return c[static_cast<size_t>(k)]; }
    T &operator[](int k) { return c[static_cast<size_t>(k)]; }

    T at(double s) const {
        T sum = c[kOrder];
        for (int k = kOrder - 1; k >= 0; --k) sum = sum * s + c[static_cast<size_t>(k)];
        return sum;
    }
    T rateAt(double s) const {
        T sum = double(kOrder) * c[kOrder];
        for (int k = kOrder - 1; k >= 1; --k) sum = sum * s + double(k) * c[static_cast<size_t>(k)];
        return sum;
    }
};

using Jet = JetOf<double>;
using VecJet = JetOf<Vec3>;

/// Term k of a product; of vectors: of their dot or cross product.
inline double termOf(const Jet &a, const Jet &b, int k) {
    double sum = 0.0;
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
}
inline double dotTerm(const VecJet &a, const VecJet &b, int k) {
    double sum = 0.0;
    for (int j = 0; j <= k; ++j) sum += glm::dot(a[j], b[k - j]);
    return sum;
}
inline Vec3 termOf(const Jet &a, const VecJet &b, int k) {
    Vec3 sum(0.0);
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
}

/// Term k of square^(-1/2), whose terms before k are known.
inline double inverseRootTerm(const Jet &square, const Jet &root, int k) {
    if (k == 0) return 1.0 / std::sqrt(square[0]);
    double sum = 0.0;
    for (int j = 1; j <= k; ++j) sum += (-0.5 * j - (k - j)) * square[j] * root[k - j];
    return sum / (k * square[0]);
}

/// First s in [0, end] at which a polynomial falls through zero; kNever if it doesn't.
inline double firstFall(const Jet &g, double end, Work &work) {
    double others = 0.0, bend = 0.0;
    for (int k = kOrder; k >= 1; --k) others = (others + std::abs(g[k])) * end;
    if (g[0] > others) return kNever;
    for (int k = kOrder; k >= 2; --k) bend = bend * end + double(k * (k - 1)) * std::abs(g[k]);
    const double zero = 4.0 * 0x1p-52 * (std::abs(g[0]) + others);
    const auto look = [&](double s) {
        work.add(Work::kJet);
        return Look{g.at(s), g.rateAt(s), -bend};
    };
    return firstZero(look, 0.0, end, zero);
}

} // namespace phys
