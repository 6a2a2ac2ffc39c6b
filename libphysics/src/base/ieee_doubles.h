// SPDX-License-Identifier: MIT
// Stops the compilation if doubles aren't what all guarantees rely on: IEEE 754, each operation rounded to a double
// separately, in the order in which it is written.
#pragma once

#include <cfloat>
#include <limits>

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::radix == 2 &&
                  std::numeric_limits<double>::digits == 53 && std::numeric_limits<double>::max_exponent == 1024,
              "libphysics needs doubles of IEEE 754");

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "libphysics can't be compiled with -ffast-math or a part of it: it changes what every line computes"
#endif

#if FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD < 0
#error "libphysics needs operations that round to double; for x86 of 32 bits compile with -msse2 -mfpmath=sse"
#endif
