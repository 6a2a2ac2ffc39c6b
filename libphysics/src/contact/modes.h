// SPDX-License-Identifier: MIT
// Lasting contacts of a moment, all together: which press, stick, slip or open, and how the ball accelerates.
// model.md 14.
#pragma once

#include "base/vec.h"
#include "contact/work.h"

#include <array>
#include <cstdint>
#include <span>

namespace phys {

/// More lasting contacts than this at once are not looked at together.
inline constexpr uint32_t kMostHeld = 6;

/// A contact that lasts: gap 0, no velocity across it.
struct Held {
    Vec3 normal;       ///< n, unit, from the box to the centre
    Vec3 across;       ///< diagonal of P: 1 along the axes on which the feature bounds the box, 0 along it
    double friction;   ///< mu
    double resistance; ///< mu_r; only top faces have it
    bool isGlued;      ///< rolling model's top face: sticks without a cone
};

enum class Mode : uint8_t {
    open,     ///< no force
    smooth,   ///< a normal force, no friction
    slipping, ///< friction mu N against the slip
    sticking, ///< as much friction as keeps the slip at zero
    starting, ///< the slip begins: friction mu N against the slip's acceleration
    spent     ///< sticking whose friction just reached mu N: the slip begins, but without an acceleration
};

/// What one contact does.
struct Reaction {
    Mode mode;
    double pressure; ///< N, per mass
    Vec3 force;      ///< r = N n + friction, per mass
    Vec3 direction;  ///< of the slip, or of its acceleration when it starts
    Vec3 slip;       ///< u, velocity of the ball's surface at the contact
};

/// The ball's motion as the contacts see it.
struct Moment {
    Vec3 velocity{0.0}, spin{0.0};
    Vec3 gravity{0.0};
    double radius = 0.0;
    double rounding = 16.0 * 0x1p-52; ///< relative, of the normals
};

/// The modes that hold, and the accelerations that follow.
struct Response {
    std::array<Reaction, kMostHeld> reactions; ///< the first `count` are meant
    uint32_t count = 0;
    Vec3 acceleration{0.0}, spinAcceleration{0.0};
    Vec3 rolling{0.0};   ///< unit: what rolling resistance acts against, hat(om_t); 0 where there is none
    double noise = 0.0;  ///< m/s^2: accelerations up to this are rounding
    bool isFound = true; ///< false: no modes fit, model.md 14.1

    std::span<const Reaction> list() const { return {reactions.data(), count}; }
};

/// Slip velocity of the ball's surface at a contact.
Vec3 slipAt(const Moment &moment, const Vec3 &normal);

/// Whether a slip is none but for rounding.
bool isNoSlip(const Moment &moment, const Vec3 &slip);

/// Modes that are known not to last beyond this moment: bits of the contacts that open now, and of those that slip.
struct Excluded {
    uint32_t closed = 0, sticking = 0;
};

/// Of all modes that fit, those with the smallest sum of N; at equal sums those with most contacts.
/// What is found once the work is too much means nothing.
Response respond(const Moment &moment, std::span<const Held> held, Work &work, const Excluded &excluded = {});

/// Ends slips at once where no modes fit, by impulses that Coulomb's cones allow: the ball jams, model.md 14.1. Never
/// adds energy.
/// False if none do.
bool endSlips(Moment &moment, std::span<const Held> held, Work &work);

/// Ends all slips at rough contacts, whatever friction it takes. Never adds energy.
void stopSlips(Moment &moment, std::span<const Held> held, Work &work);

/// Size of accelerations at a moment, for what counts as zero: |g| + v^2/R + R om^2.
double accelerationScale(const Moment &moment);

/// Size of speeds at a moment: |v| + R |om| + sqrt(R |g|).
double speedScale(const Moment &moment);

/// Rounding error of a contact's friction limit mu N that comes from N: it grows with the friction, m/s^2.
double roundingOfLimit(const Moment &moment, double friction);

/// Friction that a contact has in reserve, (mu N)^2 - |f|^2, where the friction that rolling resistance needs isn't
/// counted: model.md 2.2.
double reserve(const Held &held, const Reaction &reaction, const Vec3 &rolling);

} // namespace phys
