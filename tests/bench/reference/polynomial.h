// SPDX-License-Identifier: MIT
// Roots of polynomials of low degree without a formula for them: between the roots of its derivative a polynomial is
// monotone, so that halving finds each root, simple or nearly double, and none is missed.
#pragma once

#include <cmath>
#include <vector>

namespace bench {

// Coefficients of 1, t, t^2, ...
template<class Real>
using Polynomial = std::vector<Real>;

template<class Real>
Real valueAt(const Polynomial<Real> &polynomial, Real t) {
    Real value = 0;
    for (auto coefficient = polynomial.rbegin(); coefficient != polynomial.rend(); ++coefficient)
        value = value * t + *coefficient;
    return value;
}

template<class Real>
Polynomial<Real> derivativeOf(const Polynomial<Real> &polynomial) {
    Polynomial<Real> derivative;
    for (std::size_t power = 1; power < polynomial.size(); ++power)
        derivative.push_back(static_cast<Real>(power) * polynomial[power]);
    return derivative;
}

// The place between low and high where the sign changes, to the last bit.
template<class Real>
Real signChange(const Polynomial<Real> &polynomial, Real low, Real high) {
    const bool below = valueAt(polynomial, low) < 0;
    while (true) {
        const Real middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        ((valueAt(polynomial, middle) < 0) == below ? low : high) = middle;
    }
}

// All sign changes in (0, end), in ascending order.
template<class Real>
std::vector<Real> signChanges(const Polynomial<Real> &polynomial, Real end) {
    if (polynomial.size() < 2) return {};
    std::vector<Real> borders = signChanges(derivativeOf(polynomial), end);
    borders.push_back(end);
    std::vector<Real> changes;
    Real begin = 0;
    for (const Real border : borders) {
        if ((valueAt(polynomial, begin) < 0) != (valueAt(polynomial, border) < 0))
            changes.push_back(signChange(polynomial, begin, border));
        begin = border;
    }
    return changes;
}

// The first place in (0, end) where the polynomial becomes negative; `end` if there is none.
template<class Real>
Real firstDescent(const Polynomial<Real> &polynomial, Real end) {
    bool negative = valueAt(polynomial, Real(0)) < 0;
    for (const Real change : signChanges(polynomial, end)) {
        if (!negative) return change;
        negative = false;
    }
    return end;
}

} // namespace bench
