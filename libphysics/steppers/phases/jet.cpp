// SPDX-License-Identifier: MIT
#include "phases/jet.h"

#include <algorithm>

namespace phys {

namespace {

constexpr double kStalls = 0x1p-7; // if a slip loses this share while its series are valid, its direction is rounding
constexpr double kMostStalled = 128.0; // by which the speed that is none grows, the more the more series it would take

} // namespace

End zeroOfSpeed(const Jet &speed, double until, const Reach &reach, double small, Cause cause, uint32_t contact,
                Work &work) {
    const double time = firstFall(speed, until, work);
    const double share = -speed[1] * reach.length / speed[0];
    if (share < kStalls) small *= std::min(8.0 * kStalls / share, kMostStalled);
    if (time != kNever || speed[0] > small || speed[1] >= 0.0) return {time, cause, contact};
    return {0.0, cause, contact, reach.unit * speed[0] / -speed[1]};
}

End endOfSlip(const Jet &speed, double until, const Reach &reach, double small, double noise, uint32_t contact,
              Work &work) {
    const double good = 0.8 * Validity(kOrder).add(speed, noise).until();
    End end = zeroOfSpeed(speed, std::min(until, good), reach, small, Cause::grip, contact, work);
    if (good < until) end.cut({good, Cause::time, 0});
    return end;
}

} // namespace phys
