// SPDX-License-Identifier: MIT
// Two numbers that are computed with at once, in one register where processors have such; the bits are those of each by
// itself. What is written for pairs chooses by `choose` where it would branch.
#pragma once

#include "base/ieee_doubles.h"

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace phys {

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

#else

class Pair;

class PairMask {
public:
    PairMask(bool first, bool second)
        : m_first(first)
        , m_second(second) {}
    friend PairMask operator&(PairMask a, PairMask b) { return {a.m_first && b.m_first, a.m_second && b.m_second}; }
    friend PairMask operator|(PairMask a, PairMask b) { return {a.m_first || b.m_first, a.m_second || b.m_second}; }
    /// Bit 0 is the first number's, bit 1 that of the second.
    uint32_t bits() const { return (m_first ? 1U : 0U) | (m_second ? 2U : 0U); }

private:
    friend Pair choose(PairMask condition, Pair a, Pair b);
    bool m_first, m_second;
};

class Pair {
public:
    Pair(double both) // NOLINT(google-explicit-constructor): numbers mix with pairs as with numbers
        : Pair(both, both) {}
    static Pair load(const double *place) { return {place[0], place[1]}; }
    void store(double *place) const { place[0] = m_first, place[1] = m_second; }

    friend Pair operator+(Pair a, Pair b) { return {a.m_first + b.m_first, a.m_second + b.m_second}; }
    friend Pair operator-(Pair a, Pair b) { return {a.m_first - b.m_first, a.m_second - b.m_second}; }
    friend Pair operator*(Pair a, Pair b) { return {a.m_first * b.m_first, a.m_second * b.m_second}; }
    friend Pair operator/(Pair a, Pair b) { return {a.m_first / b.m_first, a.m_second / b.m_second}; }
    friend Pair operator-(Pair a) { return {-a.m_first, -a.m_second}; }
    friend PairMask operator<(Pair a, Pair b) { return {a.m_first < b.m_first, a.m_second < b.m_second}; }
    friend PairMask operator<=(Pair a, Pair b) { return {a.m_first <= b.m_first, a.m_second <= b.m_second}; }
    friend PairMask operator==(Pair a, Pair b) { return {a.m_first == b.m_first, a.m_second == b.m_second}; }

    friend Pair choose(PairMask condition, Pair a, Pair b);
    friend Pair squareRoot(Pair a) { return {std::sqrt(a.m_first), std::sqrt(a.m_second)}; }
    friend Pair magnitude(Pair a) { return {std::abs(a.m_first), std::abs(a.m_second)}; }

private:
    Pair(double first, double second)
        : m_first(first)
        , m_second(second) {}
    double m_first, m_second;
};

/// condition ? a : b, of each number. Both are computed.
inline Pair choose(PairMask condition, Pair a, Pair b) {
    return {condition.m_first ? a.m_first : b.m_first, condition.m_second ? a.m_second : b.m_second};
}

#endif

inline PairMask operator>(Pair a, Pair b) { return b < a; }
inline PairMask operator>=(Pair a, Pair b) { return b <= a; }

/// Vectors in the plane, one of each number.
struct PairVec2 {
    Pair x, y;

    friend PairVec2 operator+(const PairVec2 &a, const PairVec2 &b) { return {a.x + b.x, a.y + b.y}; }
    friend PairVec2 operator-(const PairVec2 &a, const PairVec2 &b) { return {a.x - b.x, a.y - b.y}; }
    friend PairVec2 operator*(Pair a, const PairVec2 &b) { return {a * b.x, a * b.y}; }
    friend Pair dot(const PairVec2 &a, const PairVec2 &b) { return a.x * b.x + a.y * b.y; }
    friend Pair length(const PairVec2 &a) { return squareRoot(dot(a, a)); }
};

} // namespace phys
