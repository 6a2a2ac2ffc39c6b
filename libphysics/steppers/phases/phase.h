// SPDX-License-Identifier: MIT
// What all smooth phases of a ball between two events have in common: model.md 8.
#pragma once

#include "base/vec.h"
#include "shared/closed_form.h"

#include <cstdint>

namespace phys {

/// Since the start of the phase.
struct Way {
    Vec3 way, velocity;
};

/// All that has become of the ball.
struct Place {
    Vec3 way, velocity, spin;
};

/// How a phase ends by itself, whatever is in its way.
enum class Cause : uint8_t {
    time,    ///< it doesn't, or its series are good no longer
    stop,    ///< resistance has stopped the ball
    grip,    ///< a slip has ended
    release, ///< a contact presses no longer
    spent,   ///< a contact's friction is spent
    border,  ///< the feature of a lasting contact ends
    touch    ///< the ball meets a box
};

struct End {
    double after = kNever; ///< s
    Cause cause = Cause::time;
    uint32_t contact = 0; ///< that it happens at
    double rest = 0.0;    ///< s that a vanishing speed still takes to its end: the ball's own velocity lasts so long

    void cut(const End &other) {
        if (other.after < after) *this = other;
    }
};

/// Energy per mass that a phase has taken, J/kg.
struct Losses {
    double slip = 0.0, rolling = 0.0;
};

} // namespace phys
