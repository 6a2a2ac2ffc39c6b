// SPDX-License-Identifier: MIT
// Two doubles at once, for the checks that every step makes: half the instructions.
#pragma once

#include <algorithm>
#include <cstddef>

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

/// 2^100: squares and products of numbers below it, as a step makes them, stay finite.
inline constexpr double kLargestNumber = 0x1p100;

/// Whether all lie between -kLargestNumber and kLargestNumber: times 2^924 these stay finite, others and NaN don't, and
/// x - x is 0 for a finite x and NaN otherwise.
template<size_t Count>
inline bool allModerate(const double *values) {
    static_assert(Count % 2 == 0);
#if defined(__SSE2__)
    const __m128d scale = _mm_set1_pd(0x1p924);
    __m128d sum = _mm_setzero_pd();
    for (size_t i = 0; i < Count; i += 2) {
        const __m128d pair = _mm_mul_pd(scale, _mm_loadu_pd(values + i));
        sum = _mm_add_pd(sum, _mm_sub_pd(pair, pair));
    }
    return _mm_movemask_pd(_mm_cmpeq_pd(sum, _mm_setzero_pd())) == 3;
#else
    double sum = 0.0;
    for (size_t i = 0; i < Count; ++i) sum += 0x1p924 * values[i] - 0x1p924 * values[i];
    return sum == 0.0;
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

/// Whether two points (x, y) both lie in the rectangle between two corners, its border included.
inline bool bothInRectangle(const double *p, const double *q, const double *low, const double *high) {
#if defined(__SSE2__)
    const __m128d a = _mm_loadu_pd(p);
    const __m128d b = _mm_loadu_pd(q);
    const __m128d above = _mm_cmpge_pd(_mm_min_pd(a, b), _mm_loadu_pd(low));
    return _mm_movemask_pd(_mm_and_pd(above, _mm_cmple_pd(_mm_max_pd(a, b), _mm_loadu_pd(high)))) == 3;
#else
    return std::min(p[0], q[0]) >= low[0] && std::max(p[0], q[0]) <= high[0] && std::min(p[1], q[1]) >= low[1] &&
           std::max(p[1], q[1]) <= high[1];
#endif
}

} // namespace phys
