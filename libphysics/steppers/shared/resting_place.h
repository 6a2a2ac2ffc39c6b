// SPDX-License-Identifier: MIT
// The cheapest step there is: a ball that rests stays as it is.
#pragma once

#include "base/vec.h"

#include <physics/physics.h>

#include <cstring>

namespace phys {

inline bool standsStill(const phys_state &state) {
    return toVec(state.velocity) == Vec3(0.0) && toVec(state.spin) == Vec3(0.0);
}

/// The state after a step in which the ball stays as it is: all but the time and the number of the step.
inline void leaveResting(const phys_state &in, uint64_t flags, phys_state &out) {
    if (&out != &in) {
        out.position = in.position;
        out.velocity = in.velocity;
        out.spin = in.spin;
        std::memcpy(out.orientation, in.orientation, sizeof out.orientation);
    }
    out.flags = flags;
}

/// Whether the ball is where it was and moves as it did, to the bit: a zero has a sign.
inline bool isSameMotion(const phys_state &a, const phys_state &b) {
    return std::memcmp(&a.position, &b.position, sizeof a.position) == 0 &&
           std::memcmp(&a.velocity, &b.velocity, sizeof a.velocity) == 0 &&
           std::memcmp(&a.spin, &b.spin, sizeof a.spin) == 0;
}

/// The state in which a ball was last found to stay as it is, and under which parameters. That it does follows from
/// both and the scene, so that no answer depends on what is kept.
class RestingPlace {
public:
    void keep(const phys_params &params, const phys_state &state) {
        m_state = state;
        m_params = params;
    }

    /// The flags of the ball if it is known to stay, or 0.
    uint64_t flagsOf(const phys_params &params, const phys_state &state) const {
        const bool isKnown = (state.flags & PHYS_AT_REST) && isSameMotion(state, m_state) &&
                             std::memcmp(&params, &m_params, sizeof params) == 0;
        return isKnown ? m_state.flags : 0;
    }

private:
    phys_state m_state{}; ///< without flags: none yet
    phys_params m_params{};
};

} // namespace phys
