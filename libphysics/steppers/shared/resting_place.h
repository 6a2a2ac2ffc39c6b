// SPDX-License-Identifier: MIT
// The cheapest step there is: a ball that rests stays as it is.
#pragma once

#include "base/vec.h"

#include <physics/physics.h>

#include <cmath>
#include <cstring>

namespace phys {

inline bool standsStill(const phys_state &state) {
    return toVec(state.velocity) == Vec3(0.0) && toVec(state.spin) == Vec3(0.0);
}

/// The state after a step in which a ball that stands still stays: all but the time and the number of the step.
inline void leaveResting(const phys_state &in, uint64_t flags, phys_state &out) {
    if (&out != &in) {
        out.position = in.position;
        std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    }
    out.velocity = out.spin = {0.0, 0.0, 0.0};
    out.flags = flags;
}

/// The place at which a ball that stands still was last found to stay, and under which parameters. That it does follows
/// from both and the scene, so that no answer depends on what is kept.
class RestingPlace {
public:
    void keep(const phys_params &params, const phys_state &state) {
        m_place = toVec(state.position);
        m_params = params;
        m_flags = state.flags;
    }

    /// The flags of the ball if it is known to stay, or 0.
    uint64_t flagsOf(const phys_params &params, const phys_state &state) const {
        const bool isKnown = (state.flags & PHYS_AT_REST) && toVec(state.position) == m_place &&
                             std::memcmp(&params, &m_params, sizeof params) == 0;
        return isKnown ? m_flags : 0;
    }

private:
    Vec3 m_place{NAN}; ///< nowhere yet
    phys_params m_params{};
    uint64_t m_flags = 0;
};

} // namespace phys
