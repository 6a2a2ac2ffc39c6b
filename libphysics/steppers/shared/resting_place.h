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

/// The same bytes: a zero has a sign, and nothing needs to be a number.
template<class T>
bool isSame(const T &a, const T &b) {
    const void *const first = &a, *const second = &b;
    return std::memcmp(first, second, sizeof a) == 0;
}

/// Whether the ball is where it was and moves as it did.
inline bool isSameMotion(const phys_state &a, const phys_state &b) {
    return isSame(a.position, b.position) && isSame(a.velocity, b.velocity) && isSame(a.spin, b.spin);
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
        const bool isKnown = (state.flags & PHYS_AT_REST) && isSameMotion(state, m_state) && isSame(params, m_params);
        return isKnown ? m_state.flags : 0;
    }

private:
    phys_state m_state{}; ///< without flags: none yet
    phys_params m_params{};
};

} // namespace phys
