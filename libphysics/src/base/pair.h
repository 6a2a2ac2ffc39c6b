// SPDX-License-Identifier: MIT
// Two numbers that are computed with at once, in one register where processors have such; the bits are those of each by
// itself. What is written for a number type N, Single or Pair, chooses by `choose` where it would branch.
#pragma once

#include "base/ieee_doubles.h"

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace phys {

class SingleMask {
public:
    explicit SingleMask(bool is)
        : m_is(is) {}
    friend SingleMask operator&(SingleMask a, SingleMask b) { return SingleMask(a.m_is & b.m_is); }
    friend SingleMask operator|(SingleMask a, SingleMask b) { return SingleMask(a.m_is | b.m_is); }
    uint32_t bits() const { return m_is ? 1 : 0; }

private:
    bool m_is;
};

/// One number by itself, with what pairs have.
class Single {
public:
    using Mask = SingleMask;
    static constexpr uint32_t kWidth = 1;

    Single(double number) // NOLINT(google-explicit-constructor): a number
        : m_number(number) {}
    static Single load(const double *place) { return *place; }
    void store(double *place) const { *place = m_number; }
    double number() const { return m_number; }

    friend Single operator+(Single a, Single b) { return a.m_number + b.m_number; }
    friend Single operator-(Single a, Single b) { return a.m_number - b.m_number; }
    friend Single operator*(Single a, Single b) { return a.m_number * b.m_number; }
    friend Single operator/(Single a, Single b) { return a.m_number / b.m_number; }
    friend Single operator-(Single a) { return -a.m_number; }
    friend SingleMask operator<(Single a, Single b) { return SingleMask(a.m_number < b.m_number); }
    friend SingleMask operator<=(Single a, Single b) { return SingleMask(a.m_number <= b.m_number); }
    friend SingleMask operator==(Single a, Single b) { return SingleMask(a.m_number == b.m_number); }
    friend Single squareRoot(Single a) { return std::sqrt(a.m_number); }
    friend Single magnitude(Single a) { return std::abs(a.m_number); }

private:
    double m_number;
};

inline SingleMask operator>(Single a, Single b) { return b < a; }
inline SingleMask operator>=(Single a, Single b) { return b <= a; }
inline Single choose(SingleMask condition, Single a, Single b) { return condition.bits() ? a : b; }

#if defined(__SSE2__) // GCC 12 takes generic vectors apart where they are compared

class Pair;

class PairMask {
public:
    explicit PairMask(__m128d bits)
        : m_bits(bits) {}
    friend PairMask operator&(PairMask a, PairMask b) { return PairMask(_mm_and_pd(a.m_bits, b.m_bits)); }
    friend PairMask operator|(PairMask a, PairMask b) { return PairMask(_mm_or_pd(a.m_bits, b.m_bits)); }
    /// Bit 0 is the first number's, bit 1 that of the second.
    uint32_t bits() const { return static_cast<uint32_t>(_mm_movemask_pd(m_bits)); }

private:
    friend Pair choose(PairMask condition, Pair a, Pair b);
    __m128d m_bits; ///< all or none of each half
};

class Pair {
public:
    using Mask = PairMask;
    static constexpr uint32_t kWidth = 2;

    Pair(double both) // NOLINT(google-explicit-constructor): numbers mix with pairs as with numbers
        : m_numbers(_mm_set1_pd(both)) {}
    static Pair load(const double *place) { return Pair(_mm_loadu_pd(place)); }
    void store(double *place) const { _mm_storeu_pd(place, m_numbers); }

    friend Pair operator+(Pair a, Pair b) { return Pair(_mm_add_pd(a.m_numbers, b.m_numbers)); }
    friend Pair operator-(Pair a, Pair b) { return Pair(_mm_sub_pd(a.m_numbers, b.m_numbers)); }
    friend Pair operator*(Pair a, Pair b) { return Pair(_mm_mul_pd(a.m_numbers, b.m_numbers)); }
    friend Pair operator/(Pair a, Pair b) { return Pair(_mm_div_pd(a.m_numbers, b.m_numbers)); }
    friend Pair operator-(Pair a) { return Pair(_mm_xor_pd(a.m_numbers, _mm_set1_pd(-0.0))); }
    friend PairMask operator<(Pair a, Pair b) { return PairMask(_mm_cmplt_pd(a.m_numbers, b.m_numbers)); }
    friend PairMask operator<=(Pair a, Pair b) { return PairMask(_mm_cmple_pd(a.m_numbers, b.m_numbers)); }
    friend PairMask operator==(Pair a, Pair b) { return PairMask(_mm_cmpeq_pd(a.m_numbers, b.m_numbers)); }
    friend Pair choose(PairMask condition, Pair a, Pair b);
    friend Pair squareRoot(Pair a) { return Pair(_mm_sqrt_pd(a.m_numbers)); }
    friend Pair magnitude(Pair a) { return Pair(_mm_andnot_pd(_mm_set1_pd(-0.0), a.m_numbers)); }

private:
    explicit Pair(__m128d numbers)
        : m_numbers(numbers) {}
    __m128d m_numbers;
};

/// condition ? a : b, of each number. Both are computed.
inline Pair choose(PairMask condition, Pair a, Pair b) {
    return Pair(_mm_or_pd(_mm_and_pd(condition.m_bits, a.m_numbers), _mm_andnot_pd(condition.m_bits, b.m_numbers)));
}

inline PairMask operator>(Pair a, Pair b) { return b < a; }
inline PairMask operator>=(Pair a, Pair b) { return b <= a; }

#else

using Pair = Single; ///< one at a time

#endif

/// A vector in the plane of each number; N: Single or Pair.
template<class N>
struct Planar {
    N x, y;

    Planar(N alongX, N alongY)
        : x(alongX)
        , y(alongY) {}
    // Number by number: a processor waits where it reads two at once that were just written one by one.
    Planar(const Planar &other)
        : x(other.x)
        , y(other.y) {}
    Planar &operator=(const Planar &other) {
        x = other.x;
        y = other.y;
        return *this;
    }

    friend Planar operator+(const Planar &a, const Planar &b) { return {a.x + b.x, a.y + b.y}; }
    friend Planar operator-(const Planar &a, const Planar &b) { return {a.x - b.x, a.y - b.y}; }
    friend Planar operator*(N a, const Planar &b) { return {a * b.x, a * b.y}; }
    friend N dot(const Planar &a, const Planar &b) { return a.x * b.x + a.y * b.y; }
    friend N length(const Planar &a) { return squareRoot(dot(a, a)); }
};

} // namespace phys
