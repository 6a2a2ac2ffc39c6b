// SPDX-License-Identifier: MIT
// Four numbers that are computed together, for processors with AVX; like Pair (base/pair.h). Included only by sources
// that are compiled for them.
#pragma once

#include "base/pair.h"

#include <immintrin.h>

namespace phys {

struct QuadMask {
    __m256d bits; ///< all bits of each quarter are set, or none
};

struct Quad {
    __m256d numbers;

    Quad(double number) // NOLINT(google-explicit-constructor): numbers mix with quads as with numbers
        : numbers(_mm256_set1_pd(number)) {}
    explicit Quad(__m256d all)
        : numbers(all) {}
};

inline Quad operator+(Quad a, Quad b) { return Quad(_mm256_add_pd(a.numbers, b.numbers)); }
inline Quad operator-(Quad a, Quad b) { return Quad(_mm256_sub_pd(a.numbers, b.numbers)); }
inline Quad operator*(Quad a, Quad b) { return Quad(_mm256_mul_pd(a.numbers, b.numbers)); }
inline Quad operator/(Quad a, Quad b) { return Quad(_mm256_div_pd(a.numbers, b.numbers)); }
inline Quad operator-(Quad a) { return Quad(_mm256_xor_pd(a.numbers, _mm256_set1_pd(-0.0))); }
inline QuadMask operator<(Quad a, Quad b) { return {_mm256_cmp_pd(a.numbers, b.numbers, _CMP_LT_OQ)}; }
inline QuadMask operator<=(Quad a, Quad b) { return {_mm256_cmp_pd(a.numbers, b.numbers, _CMP_LE_OQ)}; }
inline QuadMask operator>(Quad a, Quad b) { return b < a; }
inline QuadMask operator>=(Quad a, Quad b) { return b <= a; }
inline QuadMask operator==(Quad a, Quad b) { return {_mm256_cmp_pd(a.numbers, b.numbers, _CMP_EQ_OQ)}; }

template<>
inline constexpr uint32_t kWidth<Quad> = 4;
template<>
struct MaskType<Quad> {
    using Type = QuadMask;
};

template<>
inline Quad load<Quad>(const double *place) {
    return Quad(_mm256_loadu_pd(place));
}
inline void store(Quad quad, double *place) { _mm256_storeu_pd(place, quad.numbers); }
inline Quad squareRoot(Quad a) { return Quad(_mm256_sqrt_pd(a.numbers)); }
inline Quad magnitude(Quad a) { return Quad(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.numbers)); }
inline QuadMask all(QuadMask a, QuadMask b) { return {_mm256_and_pd(a.bits, b.bits)}; }
inline QuadMask any(QuadMask a, QuadMask b) { return {_mm256_or_pd(a.bits, b.bits)}; }
/// Bit i is the number i's.
inline uint32_t bitsOf(QuadMask mask) { return static_cast<uint32_t>(_mm256_movemask_pd(mask.bits)); }
/// condition ? a : b for each number. Both sides are evaluated.
inline Quad choose(QuadMask condition, Quad a, Quad b) {
    return Quad(_mm256_blendv_pd(b.numbers, a.numbers, condition.bits));
}

} // namespace phys
