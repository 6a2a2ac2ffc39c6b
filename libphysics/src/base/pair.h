// SPDX-License-Identifier: MIT
// Two numbers that are computed together, in one SIMD register where processors have them; the bits are those of each
// computed separately. Code for a number type N, double or Pair, uses `choose` instead of branches, and combines
// conditions, which are a MaskOf<N>, by `all` and `any`.
#pragma once

#include "base/ieee_doubles.h"

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace phys {

template<class N>
inline constexpr uint32_t kWidth = 1;
template<class N>
struct MaskType {
    using Type = bool;
};
template<class N>
using MaskOf = typename MaskType<N>::Type;

template<class N>
N load(const double *place) {
    return *place;
}
inline void store(double number, double *place) { *place = number; }
inline double squareRoot(double a) { return std::sqrt(a); }
inline double magnitude(double a) { return std::abs(a); }
inline bool all(bool a, bool b) { return a && b; }
inline bool any(bool a, bool b) { return a || b; }
inline uint32_t bitsOf(bool mask) { return mask ? 1 : 0; }
inline bool areAll(bool mask) { return mask; }
inline double choose(bool condition, double a, double b) { return condition ? a : b; }

#if defined(__SSE2__) // GCC 12 splits generic vectors where they are compared

struct PairMask {
    __m128d bits; ///< all bits of each half are set, or none
};

struct Pair {
    __m128d numbers;

    Pair(double number) // NOLINT(google-explicit-constructor): numbers mix with pairs as with numbers
        : numbers(_mm_set1_pd(number)) {}
    explicit Pair(__m128d both)
        : numbers(both) {}
};

inline Pair operator+(Pair a, Pair b) { return Pair(_mm_add_pd(a.numbers, b.numbers)); }
inline Pair operator-(Pair a, Pair b) { return Pair(_mm_sub_pd(a.numbers, b.numbers)); }
inline Pair operator*(Pair a, Pair b) { return Pair(_mm_mul_pd(a.numbers, b.numbers)); }
inline Pair operator/(Pair a, Pair b) { return Pair(_mm_div_pd(a.numbers, b.numbers)); }
inline Pair operator-(Pair a) { return Pair(_mm_xor_pd(a.numbers, _mm_set1_pd(-0.0))); }
inline PairMask operator<(Pair a, Pair b) { return {_mm_cmplt_pd(a.numbers, b.numbers)}; }
inline PairMask operator<=(Pair a, Pair b) { return {_mm_cmple_pd(a.numbers, b.numbers)}; }
inline PairMask operator>(Pair a, Pair b) { return b < a; }
inline PairMask operator>=(Pair a, Pair b) { return b <= a; }
inline PairMask operator==(Pair a, Pair b) { return {_mm_cmpeq_pd(a.numbers, b.numbers)}; }

template<>
inline constexpr uint32_t kWidth<Pair> = 2;
template<>
struct MaskType<Pair> {
    using Type = PairMask;
};

template<>
inline Pair load<Pair>(const double *place) {
    return Pair(_mm_loadu_pd(place));
}
inline void store(Pair pair, double *place) { _mm_storeu_pd(place, pair.numbers); }
inline Pair squareRoot(Pair a) { return Pair(_mm_sqrt_pd(a.numbers)); }
inline Pair magnitude(Pair a) { return Pair(_mm_andnot_pd(_mm_set1_pd(-0.0), a.numbers)); }
inline PairMask all(PairMask a, PairMask b) { return {_mm_and_pd(a.bits, b.bits)}; }
inline PairMask any(PairMask a, PairMask b) { return {_mm_or_pd(a.bits, b.bits)}; }
/// Bit 0 is the first number's, bit 1 that of the second.
inline uint32_t bitsOf(PairMask mask) { return static_cast<uint32_t>(_mm_movemask_pd(mask.bits)); }
inline bool areAll(PairMask mask) { return bitsOf(mask) == 3; }
/// condition ? a : b for each number. Both sides are evaluated.
inline Pair choose(PairMask condition, Pair a, Pair b) {
    return Pair(_mm_or_pd(_mm_and_pd(condition.bits, a.numbers), _mm_andnot_pd(condition.bits, b.numbers)));
}

#else

using Pair = double; ///< one at a time

#endif

template<class Mask, class... Masks>
Mask all(Mask first, Mask second, Mask third, Masks... others) {
    return all(all(first, second), third, others...);
}

/// One vector in the plane for each number.
template<class N>
struct Planar {
    N x, y;

    Planar(N alongX, N alongY)
        : x(alongX)
        , y(alongY) {}
    // Stored one by one, as a processor stalls if it loads together what was just stored separately.
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
