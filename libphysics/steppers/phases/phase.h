// SPDX-License-Identifier: MIT
// The common interface of smooth phases of a ball between two events: model.md 8.
#pragma once

#include "base/vec.h"
#include "shared/closed_form.h"

#include <cstdint>

namespace phys {

inline Vec2 quarterTurn(const Vec2 &v) { return {-v.y, v.x}; }

/// The motion since the start of the phase.
struct Way {
    Vec3 way, velocity;
};

/// The ball's complete state in a phase.
struct Place {
    Vec3 way, velocity, spin;
    Vec3 turning; ///< integral of the spin over the time
};

/// How a phase ends by itself, regardless of obstacles.
enum class Cause : uint8_t {
    time,    ///< it doesn't end, or its series aren't valid any longer
    stop,    ///< resistance has stopped the ball
    grip,    ///< a slip has ended
    release, ///< a contact no longer presses
    spent,   ///< a contact's friction is spent
    border,  ///< the feature of a lasting contact ends
    touch    ///< the ball meets a box
};

struct End {
    double after = kNever; ///< s
    Cause cause = Cause::time;
    uint32_t contact = 0; ///< at which it happens
    double rest = 0.0;    ///< s until a vanishing speed has ended; the ball's own velocity is constant until then

    void cut(const End &other) {
        if (other.after < after) *this = other;
    }
};

/// Energy per mass that a phase has dissipated, J/kg.
struct Losses {
    double slip = 0.0, rolling = 0.0;
};

} // namespace phys
