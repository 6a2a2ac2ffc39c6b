// SPDX-License-Identifier: MIT
// Two doubles at once, for the checks that every step makes: half the instructions.
#pragma once

#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace phys {

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
