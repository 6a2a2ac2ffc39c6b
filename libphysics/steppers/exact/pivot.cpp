// SPDX-License-Identifier: MIT
#include "pivot.h"

#include "base/elementary.h"
#include "shared/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace phys {

namespace {

/// The root of a function that is negative at low and not at high, and crosses zero once: Newton, guarded by halving.
template<class Function, class Slope>
double crossing(Function f, Slope slope, double low, double high) {
    double x = 0.5 * (low + high);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double value = f(x);
        (value < 0.0 ? low : high) = x;
        double next = x - value / slope(x);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (next == x || next == low || next == high) break;
        x = next;
    }
    return x;
}

constexpr int kOrder = 24;

/// Taylor series of the angle in the time.
struct Series {
    std::array<double, kOrder + 1> angle;

    double at(double t) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 0; --k) sum = sum * t + angle[k];
        return sum;
    }
    double rate(double t) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 1; --k) sum = sum * t + k * angle[k];
        return sum;
    }
    double rateSlope(double t) const {
        double sum = 0.0;
        for (int k = kOrder; k >= 2; --k) sum = sum * t + k * (k - 1) * angle[k];
        return sum;
    }
};

/// angle'' = across cos(angle) + pressing sin(angle) - resistance, with recurrences for sine and cosine of a series.
Series expand(const Pendulum &pendulum, double angle, double rate) {
    Series series{};
    std::array<double, kOrder + 1> sine{}, cosine{};
    auto &y = series.angle;
    y[0] = angle;
    y[1] = rate;
    sine[0] = elementary::sin(angle);
    cosine[0] = elementary::cos(angle);
    for (int k = 0; k + 2 <= kOrder; ++k) {
        if (k > 0) {
            double s = 0.0, c = 0.0;
            for (int j = 1; j <= k; ++j) {
                s += j * y[j] * cosine[k - j];
                c -= j * y[j] * sine[k - j];
            }
            sine[k] = s / k;
            cosine[k] = c / k;
        }
        const double force = pendulum.across * cosine[k] + pendulum.pressing * sine[k];
        y[k + 2] = (k == 0 ? force - pendulum.resistance : force) / ((k + 1) * (k + 2));
    }
    return series;
}

constexpr double powerOfHalf(int exponent) { return exponent == 0 ? 1.0 : 0.5 * powerOfHalf(exponent - 1); }

/// Longest step whose last two terms are below rounding.
double goodFor(const Series &series) {
    double h = 1.0, last = std::abs(series.angle[kOrder]), next = std::abs(series.angle[kOrder - 1]);
    for (; last + next > 1e-18; h *= 0.5) {
        last *= powerOfHalf(kOrder);
        next *= powerOfHalf(kOrder - 1);
    }
    return h;
}

} // namespace

double Pendulum::squaredSpeed(double angle) const {
    const double half = elementary::sin(0.5 * angle); // 1 - cos = 2 sin^2 of the half
    const double work = across * elementary::sin(angle) + 2.0 * pressing * half * half - resistance * angle;
    return speed * speed + 2.0 * work;
}

double Pendulum::lift(double angle) const {
    return squaredSpeed(angle) - (pressing * elementary::cos(angle) - across * elementary::sin(angle));
}

double Pendulum::stopAngle(double end) const {
    const auto force = [this](double y) {
        return across * elementary::cos(y) + pressing * elementary::sin(y) - resistance;
    };
    if (force(0.0) >= 0.0) return kNever;
    // The speed falls up to the angle at which gravity outweighs resistance.
    double slowest = end;
    if (resistance < 1.0)
        slowest = std::min(end, elementary::atan2(resistance, std::sqrt((1.0 - resistance) * (1.0 + resistance))) -
                                    elementary::atan2(across, pressing));
    if (squaredSpeed(slowest) > 0.0) return kNever;
    return crossing([this](double y) { return -squaredSpeed(y); }, [&](double y) { return -2.0 * force(y); }, 0.0,
                    slowest);
}

double Pendulum::leaveAngle(double end) const {
    if (lift(end) < 0.0) return kNever;
    const auto slope = [this](double y) {
        return 3.0 * (across * elementary::cos(y) + pressing * elementary::sin(y)) - 2.0 * resistance;
    };
    return crossing([this](double y) { return lift(y); }, slope, 0.0, end);
}

Swing swing(const Pendulum &pendulum, double angle, double time) {
    Swing now{0.0, 0.0, pendulum.speed};
    while (true) {
        const Series series = expand(pendulum, now.angle, now.speed);
        const double step = std::min(goodFor(series), time - now.time);
        const auto turned = [&](double t) { return series.at(t) - angle; };
        const auto rate = [&](double t) { return series.rate(t); };
        const auto slowed = [&](double t) { return -series.rate(t); };
        const bool stops = slowed(step) >= 0.0;
        const double monotone = stops ? crossing(
                                            slowed, [&](double t) { return -series.rateSlope(t); }, 0.0, step)
                                      : step;
        if (turned(monotone) >= 0.0) {
            const double t = crossing(turned, rate, 0.0, monotone);
            return {now.time + t, angle, std::sqrt(std::max(0.0, pendulum.squaredSpeed(angle)))};
        }
        if (stops) return {now.time + monotone, series.at(monotone), 0.0};
        now = {now.time + step, series.at(step), series.rate(step)};
        if (now.time >= time) return {time, now.angle, now.speed};
    }
}

} // namespace phys
