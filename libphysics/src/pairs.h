// SPDX-License-Identifier: MIT
// Two doubles at once, for the checks that every step makes: half the instructions.
#pragma once

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

/// Whether all are finite: x - x is 0 for those and NaN for others.
template<size_t Count>
inline bool allFinite(const double *values) {
    static_assert(Count % 2 == 0);
#if defined(__SSE2__)
    __m128d sum = _mm_setzero_pd();
    for (size_t i = 0; i < Count; i += 2) {
        const __m128d pair = _mm_loadu_pd(values + i);
        sum = _mm_add_pd(sum, _mm_sub_pd(pair, pair));
    }
    return _mm_movemask_pd(_mm_cmpeq_pd(sum, _mm_setzero_pd())) == 3;
#else
    double sum = 0.0;
    for (size_t i = 0; i < Count; ++i) sum += values[i] - values[i];
    return sum == 0.0;
#endif
}

} // namespace phys
