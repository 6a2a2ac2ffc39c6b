// SPDX-License-Identifier: MIT
#include "base/elementary.h"

#include "base/elementary_tables.h"
#include "base/ieee_doubles.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace phys::elementary {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastNormal = std::numeric_limits<double>::min();
constexpr int kMantissaBits = 52;

/// A number as the sum of a double and a much smaller one.
struct Pair {
    double high, tail;
};

/// a + b exactly, |a| >= |b| or a = 0.
Pair sumOfOrdered(double a, double b) {
    const double sum = a + b;
    return {sum, (a - sum) + b};
}

/// a + b exactly.
Pair sum(double a, double b) {
    const double sum = a + b;
    const double partOfB = sum - a;
    return {sum, (a - (sum - partOfB)) + (b - partOfB)};
}

/// The leading 26 bits of a number, and the remainder: products of such parts are exact. |x| < 2^995.
Pair halves(double x) {
    const double shifted = 0x1.000002p27 * x;
    const double high = shifted - (shifted - x);
    return {high, x - high};
}

/// a b exactly, unless the tail underflows.
Pair product(double a, double b) {
    const Pair p = halves(a), q = halves(b);
    const double high = a * b;
    return {high, ((p.high * q.high - high) + p.high * q.tail + p.tail * q.high) + p.tail * q.tail};
}

/// Rounds x to the nearest integer, |x| < 2^51: the sum has no bits left for a fraction.
double nearestWhole(double x) {
    constexpr double kShift = 0x1.8p52;
    return (x + kShift) - kShift;
}

/// c0 + c1 x + c2 x^2 + ...
double series(double, double last) { return last; }
template<class... Rest>
double series(double x, double first, Rest... rest) {
    return first + x * series(x, rest...);
}

double powerOfTwo(int exponent) { // -1022 .. 1023
    return std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << kMantissaBits);
}

/// x 2^exponent for x near 1; rounded once where the result is subnormal.
double scaled(double x, int exponent) {
    if (exponent > -1021) return x * powerOfTwo(exponent - 1) * 2.0;
    return x * powerOfTwo(exponent + 1000) * powerOfTwo(-1000);
}

/// exp(x) = 2^exponent (entry + share), with 2^(i/32) = power and log(2)/32 as the step between entries.
struct Exponential {
    int exponent;
    Pair power;
    double growth; ///< exp(remainder) - 1
};

/// |x| < 800. The remainder is at most log(2)/64; the truncation error of the Taylor polynomial is below 2^-57.
Exponential exponential(double x, double tail) {
    const double steps = nearestWhole(x * kStepsPerUnit);
    const double r = ((x - steps * kStepHigh) - steps * kStepLow) + tail;
    const double polynomial = series(r, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720);
    const int n = static_cast<int>(steps);
    const double *power = kPowers[n & 31];
    return {n >> 5, {power[0], power[1]}, r + r * r * polynomial};
}

double expOf(double x, double tail) {
    const Exponential e = exponential(x, tail);
    return scaled(e.power.high + (e.power.tail + e.power.high * e.growth), e.exponent);
}

/// log((x + tail) 2^exponent) for a normal x, before rounding: with x = 2^k z and z near c of the table it is k log 2 +
/// log c + log(z/c).
Pair logOfNormal(double x, double tail, int exponent) {
    constexpr uint64_t kLeastBits = 0x3fe6a09e00000000; // of sqrt(1/2): z is from there to sqrt(2)
    const uint64_t bits = std::bit_cast<uint64_t>(x);
    const int shift = static_cast<int>(static_cast<int64_t>(bits - kLeastBits) >> kMantissaBits);
    const double z = std::bit_cast<double>(bits - (static_cast<uint64_t>(shift) << kMantissaBits));
    const double *entry = kLogarithms[static_cast<int>(64.0 * z + 0.5) - 45]; // NOLINT(bugprone-incorrect-roundings)
    const double inverse = entry[0], k = exponent + shift;
    // z/c - 1 in two exact parts, as the products have few bits; the tail is that of x, in units of 2^shift.
    const Pair parts = halves(z);
    const double scaledTail = tail != 0.0 ? tail * powerOfTwo(-shift) : 0.0;
    const Pair r = sumOfOrdered(parts.high * inverse - 1.0, (parts.tail + scaledTail) * inverse);
    const double y = r.high; // at most 1/90: the Taylor polynomial's truncation error is below 2^-58, relative
    const double polynomial = series(y, 1.0 / 2, -1.0 / 3, 1.0 / 4, -1.0 / 5, 1.0 / 6, -1.0 / 7, 1.0 / 8);
    const Pair whole = sumOfOrdered(k * kLog2High + entry[1], y); // the first term is exact
    return {whole.high, (k * kLog2Low + entry[2]) + (r.tail + whole.tail) - y * y * polynomial};
}

Pair logOf(double x) { return x < kLeastNormal ? logOfNormal(x * 0x1p54, 0.0, -54) : logOfNormal(x, 0.0, 0); }

/// An angle minus quarter turns: |rest| <= pi/4 up to rounding.
struct Reduced {
    int quarter;
    Pair rest;
};

/// pi/2 has 152 bits here, so that the remainder keeps its digits next to every multiple of it.
Reduced reduced(double angle) {
    if (std::abs(angle) <= 0x1.921fb54442d18p-1) return {0, {angle, 0.0}};
    const double quarters = nearestWhole(angle * kQuartersPerRadian);
    const Pair first = sum(angle - quarters * kQuarter1, -quarters * kQuarter2);
    const Pair second = sum(first.high, -quarters * kQuarter3);
    const double tail = first.tail + second.tail;
    const Pair rest = sum(second.high, tail - quarters * kQuarter4);
    return {static_cast<int>(quarters) & 3, rest};
}

/// Sine of an angle up to pi/4; truncation error below 2^-62.
double sineOf(const Pair &angle) {
    const double x = angle.high, s = x * x;
    const double polynomial = series(s, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
                                     1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000);
    return x + (angle.tail * (1.0 - 0.5 * s) + x * s * polynomial);
}

/// Cosine of an angle up to pi/4; truncation error below 2^-58.
double cosineOf(const Pair &angle) {
    const double x = angle.high, s = x * x, half = 0.5 * s;
    const double polynomial = series(s, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600,
                                     -1.0 / 87178291200, 1.0 / 20922789888000);
    const double most = 1.0 - half;
    return most + (((1.0 - most) - half) + (s * s * polynomial - x * angle.tail));
}

/// The angle whose tangent is y/x, 0 <= y <= x, x > 0, before rounding.
Pair arcOf(double y, double x) {
    const double quotient = y / x;
    if (!(quotient >= 0x1p-30)) return {quotient, 0.0}; // its cube is below rounding; or NaN
    // With x in the middle of the range no product overflows and no tail underflows.
    const double unit = x > 0x1p500 ? 0x1p-600 : x < 0x1p-400 ? 0x1p600 : 1.0;
    y *= unit, x *= unit;
    if (quotient < 0x1p-3) { // truncation error of the Taylor polynomial below 2^-57, relative
        const Pair back = product(quotient, x);
        const double tail = ((y - back.high) - back.tail) / x;
        const double s = quotient * quotient;
        const double polynomial =
            series(s, 1.0 / 3, -1.0 / 5, 1.0 / 7, -1.0 / 9, 1.0 / 11, -1.0 / 13, 1.0 / 15, -1.0 / 17);
        return {quotient, tail - quotient * s * polynomial};
    }
    // atan(t) = atan(c) + atan((t - c) / (1 + t c)); c has so few bits that its products with halves are exact.
    const double entry = nearestWhole(32.0 * quotient), c = entry / 32.0;
    const Pair parts = halves(x);
    const double d = ((y - c * parts.high) - c * parts.tail) / (x + c * y);
    const double s = d * d;
    const double *arc = kArcs[static_cast<int>(entry)];
    return {arc[0], arc[1] + (d - d * s * series(s, 1.0 / 3, -1.0 / 5, 1.0 / 7, -1.0 / 9))};
}

} // namespace

double exp(double x) {
    if (!(x < 0x1.62e42fefa39f0p9)) return x >= 0.0 ? kInfinity : x; // log of the largest double; NaN
    if (x < -746.0) return 0.0;
    return expOf(x, 0.0);
}

double expm1(double x) {
    if (std::abs(x) < 0x1p-54) return x;
    if (std::abs(x) < 0.25) { // truncation error of the Taylor polynomial below 2^-61, relative
        return x + x * x *
                       series(x, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040, 1.0 / 40320,
                              1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800);
    }
    if (x < -40.0) return -1.0;
    if (!(x < 40.0)) return exp(x); // 1 is below half a unit there
    const Exponential e = exponential(x, 0.0);
    const Pair less = sum(e.power.high, -powerOfTwo(-e.exponent));
    return (less.high + (less.tail + (e.power.tail + e.power.high * e.growth))) * powerOfTwo(e.exponent);
}

double log(double x) {
    if (!(x > 0.0 && x < kInfinity)) return x == 0.0 ? -kInfinity : x < 0.0 ? kNaN : x;
    const Pair l = logOf(x);
    return l.high + l.tail;
}

double log1p(double x) {
    if (std::abs(x) < 0x1p-54) return x;
    if (std::abs(x) < 0x1p-7) {
        return x - x * x * series(x, 1.0 / 2, -1.0 / 3, 1.0 / 4, -1.0 / 5, 1.0 / 6, -1.0 / 7, 1.0 / 8);
    }
    if (!(x > -1.0)) return x == -1.0 ? -kInfinity : x < -1.0 ? kNaN : x;
    if (x >= 0x1p54) return log(x); // 1 is below half a unit there
    const Pair whole = x < 1.0 ? sumOfOrdered(1.0, x) : sumOfOrdered(x, 1.0);
    const Pair l = logOfNormal(whole.high, whole.tail, 0);
    return l.high + l.tail;
}

double root(double x, int degree) {
    if (!(x > 0.0 && x < kInfinity) || degree == 1) return x;
    const Pair l = logOf(x);
    const double share = l.high / degree;
    const Pair back = product(share, degree);
    return expOf(share, (((l.high - back.high) - back.tail) + l.tail) / degree);
}

double sin(double angle) {
    if (std::abs(angle) < 0x1p-27) return angle;
    if (!(std::abs(angle) <= kLargestAngle)) return kNaN;
    const Reduced r = reduced(angle);
    const double value = r.quarter & 1 ? cosineOf(r.rest) : sineOf(r.rest);
    return r.quarter & 2 ? -value : value;
}

double cos(double angle) {
    if (!(std::abs(angle) <= kLargestAngle)) return kNaN;
    const Reduced r = reduced(angle);
    const double value = r.quarter & 1 ? sineOf(r.rest) : cosineOf(r.rest);
    return (r.quarter + 1) & 2 ? -value : value;
}

double atan2(double y, double x) {
    const double height = std::abs(y), width = std::abs(x);
    const bool isSteep = height > width, isBehind = std::signbit(x);
    if (height == 0.0) return std::copysign(isBehind ? 2.0 * kQuarterHigh : 0.0, y);
    const Pair arc = isSteep ? arcOf(width, height) : arcOf(height, width);
    // Counted from the nearest axis: that of y is a quarter turn, that of negative x two.
    const double quarters = isSteep ? 1.0 : isBehind ? 2.0 : 0.0;
    const double sign = isSteep == isBehind ? 1.0 : -1.0;
    const Pair whole = sumOfOrdered(quarters * kQuarterHigh, sign * arc.high);
    return std::copysign(whole.high + (whole.tail + (quarters * kQuarterLow + sign * arc.tail)), y);
}

double hypot(double x, double y) {
    const double a = std::abs(x), b = std::abs(y);
    const double larger = a > b ? a : b, smaller = a > b ? b : a;
    if (!(smaller > 0.0 && larger < kInfinity)) return larger + smaller;
    const double unit = larger > 0x1p500 ? 0x1p600 : larger < 0x1p-400 ? 0x1p-600 : 1.0;
    const double p = larger / unit, q = smaller / unit;
    const Pair pp = product(p, p), qq = product(q, q);
    const Pair squares = sumOfOrdered(pp.high, qq.high);
    const double length = std::sqrt(squares.high);
    const Pair back = product(length, length);
    const double missing = ((squares.high - back.high) - back.tail) + (squares.tail + (pp.tail + qq.tail));
    return (length + missing / (2.0 * length)) * unit;
}

} // namespace phys::elementary
