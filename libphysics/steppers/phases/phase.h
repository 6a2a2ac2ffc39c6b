// SPDX-License-Identifier: MIT
// The common interface of smooth phases of a ball between two events: model.md 8.
#pragma once

#include "base/vec.h"
#include "contact/modes.h"
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

/// The place of a ball that turns as if it had come the way `rolls` rolling on a face with normal n. lasting: the part
/// of the spin that nothing changes.
inline Place rolledPlace(const Way &now, const Way &rolls, const Vec3 &n, const Vec3 &lasting, double radius,
                         double t) {
    return {now.way, now.velocity, lasting + glm::cross(n, rolls.velocity) / radius,
            t * lasting + glm::cross(n, rolls.way) / radius};
}

/// A lasting contact as a phase takes it.
struct Bearing {
    uint32_t contact; ///< its number
    const Held &held;
    const Reaction &reaction;

    double friction() const { return held.friction * reaction.pressure; }     ///< the most, m/s^2
    double resistance() const { return held.resistance * reaction.pressure; } ///< m/s^2
};

/// The axis of a face's normal.
inline int axisOf(const Held &face) { return face.across.x != 0.0 ? 0 : face.across.y != 0.0 ? 1 : 2; }

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
