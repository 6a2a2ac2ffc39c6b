// SPDX-License-Identifier: MIT
// Compiled for processors with AVX. It must define no function that another source may define as well, as a linker
// could choose this one for all processors: everything here depends on Quad, or is defined here alone.
#include "lane_step_by_four.h"

#if defined(PHYS_AVX_SOURCES) && defined(__AVX__) // else a build of all sources with the same options

#include "base/quad.h"
#include "schemes.h"

namespace phys {

template<class Scheme, RegionRule kRule>
uint32_t stepByFour(Lanes &lanes) {
    return stepInLanes<Scheme, kRule, Quad>(lanes);
}

template uint32_t stepByFour<ExplicitEuler, RegionRule::Substeps>(Lanes &);
template uint32_t stepByFour<SymplecticEuler, RegionRule::Substeps>(Lanes &);
template uint32_t stepByFour<VelocityVerlet, RegionRule::Substeps>(Lanes &);
template uint32_t stepByFour<RungeKutta4, RegionRule::Substeps>(Lanes &);
template uint32_t stepByFour<VelocityVerlet, RegionRule::Swept>(Lanes &);

} // namespace phys

#endif
