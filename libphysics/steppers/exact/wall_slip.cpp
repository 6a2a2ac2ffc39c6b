// SPDX-License-Identifier: MIT
#include "wall_slip.h"

#include "closed_form.h"

#include <array>
#include <cmath>

namespace phys {

namespace {

constexpr int kOrder = 24;
using Coefficients = std::array<double, kOrder + 1>;

double valueAt(const Coefficients &c, double s) {
    double sum = 0.0;
    for (int k = kOrder; k >= 0; --k) sum = sum * s + c[k];
    return sum;
}

double productTerm(const Coefficients &a, const Coefficients &b, int k) {
    double sum = 0.0;
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
}

/// With ds = friction dt/|u|, in units of the first |u| and of the friction: r = |u|, y = u along the wall, k = y/r
/// obey
///     y' = drive r - (7/2) y     r' = drive y - (5/2) r - y k     t' = r     way' = y r     path' = r^2.
struct Series {
    Coefficients y{}, r{}, k{}, t{}, way{}, path{};

    Series(double y0, double r0, double drive) {
        y[0] = y0;
        r[0] = r0;
        for (int n = 0; n < kOrder; ++n) {
            double ratio = y[n];
            for (int j = 0; j < n; ++j) ratio -= k[j] * r[n - j];
            k[n] = ratio / r[0];
            const double next = 1.0 / (n + 1);
            y[n + 1] = next * (drive * r[n] - 3.5 * y[n]);
            r[n + 1] = next * (drive * y[n] - 2.5 * r[n] - productTerm(y, k, n));
            t[n + 1] = next * r[n];
            way[n + 1] = next * productTerm(y, r, n);
            path[n + 1] = next * productTerm(r, r, n);
        }
    }

    /// Longest step whose last terms are below rounding.
    double goodFor() const {
        double h = 1.0;
        const auto last = [&](const Coefficients &c) { return std::abs(c[kOrder] * std::pow(h, kOrder)); };
        while (last(r) + last(y) > 1e-18 * r[0] || last(path) + last(way) > 1e-18 * r[0] * r[0]) h *= 0.5;
        return h;
    }
};

/// s in [0, high] at which a rising function of it becomes zero.
template<class Function>
double rise(Function f, double high) {
    double low = 0.0;
    for (int halving = 0; halving < 100; ++halving) {
        const double s = 0.5 * (low + high);
        if (s == low || s == high) break;
        (f(s) < 0.0 ? low : high) = s;
    }
    return high;
}

} // namespace

WallSlip::WallSlip(double across, double along, double drive, double away, double friction)
    : m_speed(length({across, along}))
    , m_friction(friction) {
    m_across = across / m_speed;
    m_along = along / m_speed;
    m_drive = drive / friction;
    // The wall's force is friction hat(u) . n - away: it vanishes at one size of hat(u) . n.
    const double part = away / friction * (across < 0.0 ? -1.0 : 1.0);
    if (part >= 0.0 && part <= 1.0) m_leaves = std::sqrt((1.0 - part) * (1.0 + part));
    m_last = integrate(kNever);
}

WallSlip::Point WallSlip::at(double t) const { return t < m_last.time ? integrate(t) : m_last; }

WallSlip::Point WallSlip::integrate(double time) const {
    const double unitTime = m_speed / m_friction;
    const double sign = m_across < 0.0 ? -1.0 : 1.0;
    double y = m_along, r = 1.0, t = 0.0, way = 0.0, path = 0.0;
    const auto point = [&](double across) -> Point {
        return {t * unitTime, sign * across * m_speed, y * m_speed, way * m_speed * unitTime,
                path * m_speed * unitTime};
    };
    while (r > 1e-18) {
        const Series series(y, r, m_drive);
        double step = series.goodFor();
        const double target = time / unitTime - t;
        // The direction turns to one side only, so that the wall's force vanishes once at most.
        const double start = std::abs(y / r) - m_leaves;
        const double change = std::abs(valueAt(series.k, step)) - m_leaves;
        const bool leaves = std::abs(start) > 1e-14 && start * change < 0.0 && (sign > 0.0) == (start < 0.0);
        if (leaves)
            step =
                rise([&](double s) { return (std::abs(valueAt(series.k, s)) - m_leaves) * (start < 0.0 ? 1.0 : -1.0); },
                     step);
        const bool done = valueAt(series.t, step) >= target;
        if (done) step = rise([&](double s) { return valueAt(series.t, s) - target; }, step);
        t += valueAt(series.t, step);
        way += valueAt(series.way, step);
        path += valueAt(series.path, step);
        y = valueAt(series.y, step);
        r = valueAt(series.r, step);
        if (done || leaves) {
            if (done) t = time / unitTime;
            const double k = y / r;
            return point(r * std::sqrt((1.0 - k) * (1.0 + k)));
        }
        // Nothing across is left: from here on the slip is along the wall, which is another law.
        if (std::abs(y / r) >= 1.0 && r > 1e-17) return point(0.0);
    }
    t += r / 2.5;
    y = 0.0;
    return point(0.0);
}

} // namespace phys
