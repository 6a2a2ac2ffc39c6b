// SPDX-License-Identifier: MIT
// Steps in lanes by four balls at a time, where the processor has AVX. They give the same bits.
#pragma once

#include "lane_step.h"

namespace phys {

#if defined(PHYS_AVX_SOURCES)

/// Whether this processor can make them.
inline bool mayStepByFour() { return __builtin_cpu_supports("avx"); }

/// LaneSteps::step. Defined for all schemes by a source that is compiled for such processors.
template<class Scheme, RegionRule kRule>
uint32_t stepByFour(Lanes &lanes);

#else

inline bool mayStepByFour() { return false; }

template<class Scheme, RegionRule kRule>
constexpr uint32_t (*stepByFour)(Lanes &) = nullptr;

#endif

} // namespace phys
