// SPDX-License-Identifier: MIT
// Two doubles at once, for the checks that every step makes: half the instructions.
#pragma once

#include <physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace phys {

/// Whether low[i] <= values[i] <= high[i] for all; false for a NaN.
template<size_t Count>
inline bool allWithin(const double *values, const double *low, const double *high) {
    static_assert(Count % 2 == 0);
#if defined(__SSE2__)
    __m128d within = _mm_cmpeq_pd(_mm_setzero_pd(), _mm_setzero_pd());
    for (size_t i = 0; i < Count; i += 2) {
        const __m128d pair = _mm_loadu_pd(values + i);
        within = _mm_and_pd(within, _mm_cmpge_pd(pair, _mm_loadu_pd(low + i)));
        within = _mm_and_pd(within, _mm_cmple_pd(pair, _mm_loadu_pd(high + i)));
    }
    return _mm_movemask_pd(within) == 3;
#else
    for (size_t i = 0; i < Count; ++i) {
        if (!(values[i] >= low[i] && values[i] <= high[i])) return false;
    }
    return true;
#endif
}

/// Whether two objects have the same bytes.
template<class T>
inline bool haveSameBytes(const T &a, const T &b) {
#if defined(__SSE2__)
    static_assert(sizeof(T) % sizeof(__m128i) == 0);
    const auto load = [](const T &object, size_t i) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i *>(&object) + i);
    };
    __m128i same = _mm_set1_epi8(-1);
    for (size_t i = 0; i < sizeof(T) / sizeof(__m128i); ++i) {
        same = _mm_and_si128(same, _mm_cmpeq_epi8(load(a, i), load(b, i)));
    }
    return _mm_movemask_epi8(same) == 0xffff;
#else
    return std::memcmp(&a, &b, sizeof(T)) == 0;
#endif
}

/// 2^100: squares and products of numbers below it, as a step makes them, stay finite.
inline constexpr double kLargestNumber = 0x1p100;

/// Sum of the squares of an even number of values side by side.
template<size_t Count>
inline double sumOfSquares(const double *values) {
    static_assert(Count % 2 == 0);
#if defined(__SSE2__)
    __m128d sum = _mm_setzero_pd();
    for (size_t i = 0; i < Count; i += 2) {
        const __m128d pair = _mm_loadu_pd(values + i);
        sum = _mm_add_pd(sum, _mm_mul_pd(pair, pair));
    }
    return _mm_cvtsd_f64(_mm_add_sd(sum, _mm_unpackhi_pd(sum, sum)));
#else
    double sum = 0.0;
    for (size_t i = 0; i < Count; ++i) sum += values[i] * values[i];
    return sum;
#endif
}

/// False for NaN.
inline bool isModerate(const phys_vec3 &v) {
    return std::abs(v.x) <= kLargestNumber && std::abs(v.y) <= kLargestNumber && std::abs(v.z) <= kLargestNumber;
}

/// Stores (x, y) in one piece and z in another. A step later they are read so: a processor hands a number on from a
/// store to a load at once only if one store has all of it.
inline void storeVector(double x, double y, double z, double *out) {
#if defined(__SSE2__)
    _mm_storeu_pd(out, _mm_set_pd(y, x));
    _mm_store_sd(out + 2, _mm_set_sd(z));
#else
    out[0] = x;
    out[1] = y;
    out[2] = z;
#endif
}

/// Sum of the squares of three vectors that storeVector stored, and of one more number.
inline double sumOfSquares(const double *a, const double *b, const double *c, double more) {
#if defined(__SSE2__)
    const auto square = [](__m128d pair) { return _mm_mul_pd(pair, pair); };
    const __m128d planes =
        _mm_add_pd(_mm_add_pd(square(_mm_loadu_pd(a)), square(_mm_loadu_pd(b))), square(_mm_loadu_pd(c)));
    const __m128d others = _mm_add_pd(square(_mm_loadh_pd(_mm_load_sd(a + 2), b + 2)),
                                      square(_mm_unpacklo_pd(_mm_load_sd(c + 2), _mm_set_sd(more))));
    const __m128d sum = _mm_add_pd(planes, others);
    return _mm_cvtsd_f64(_mm_add_sd(sum, _mm_unpackhi_pd(sum, sum)));
#else
    double sum = more * more;
    for (int i = 0; i < 3; ++i) sum += a[i] * a[i] + b[i] * b[i] + c[i] * c[i];
    return sum;
#endif
}

/// Square of the distance from the point (x, y) to the rectangle between two corners.
inline double squaredDistanceToRectangle(const double *point, const double *low, const double *high) {
#if defined(__SSE2__)
    const __m128d p = _mm_loadu_pd(point);
    const __m128d d = _mm_sub_pd(p, _mm_min_pd(_mm_max_pd(p, _mm_loadu_pd(low)), _mm_loadu_pd(high)));
    const __m128d square = _mm_mul_pd(d, d);
    return _mm_cvtsd_f64(_mm_add_sd(square, _mm_unpackhi_pd(square, square)));
#else
    const double dx = point[0] - std::min(std::max(point[0], low[0]), high[0]);
    const double dy = point[1] - std::min(std::max(point[1], low[1]), high[1]);
    return dx * dx + dy * dy;
#endif
}

/// Whether the rectangle between two corners (x, y) lies within another one, borders included; false for a NaN.
inline bool isWithinRectangle(const double *low, const double *high, const double *outerLow, const double *outerHigh) {
#if defined(__SSE2__)
    const __m128d above = _mm_cmpge_pd(_mm_loadu_pd(low), _mm_loadu_pd(outerLow));
    const __m128d below = _mm_cmple_pd(_mm_loadu_pd(high), _mm_loadu_pd(outerHigh));
    return _mm_movemask_pd(_mm_and_pd(above, below)) == 3;
#else
    return low[0] >= outerLow[0] && low[1] >= outerLow[1] && high[0] <= outerHigh[0] && high[1] <= outerHigh[1];
#endif
}

} // namespace phys
