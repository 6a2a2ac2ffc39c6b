// SPDX-License-Identifier: MIT
// The modes of all lasting contacts of a moment: which press, stick, slip or open, and the ball's accelerations.
// model.md 14.
#pragma once

#include "base/vec.h"
#include "contact/work.h"

#include <array>
#include <cstdint>
#include <span>

namespace phys {

/// More simultaneous lasting contacts than this aren't considered together.
inline constexpr uint32_t kMostHeld = 6;

/// A lasting contact: gap 0, no velocity along its normal.
struct Held {
    Vec3 normal;          ///< n, unit, from the box to the centre
    Vec3 across;          ///< diagonal of P: 1 along the axes on which the feature bounds the box, 0 along it
    double friction;      ///< mu
    double resistance;    ///< mu_r; 0 except for top faces
    bool isGlued;         ///< top face in the rolling model: sticks without a cone
    bool isStill = false; ///< its slip counts as zero; a discrete step ends it
};

enum class Mode : uint8_t {
    open,     ///< no force
    smooth,   ///< a normal force, no friction
    slipping, ///< friction mu N opposing the slip
    sticking, ///< as much friction as keeps the slip at zero
    starting, ///< the slip begins: friction mu N opposing the slip's acceleration
    spent     ///< sticking with friction that just reached mu N: the slip begins, but without an acceleration
};

/// The effect of one contact.
struct Reaction {
    Mode mode;
    double pressure; ///< N, per mass
    Vec3 force;      ///< r = N n + friction, per mass
    Vec3 direction;  ///< direction of the slip, or of its acceleration when it starts
    Vec3 slip;       ///< u, velocity of the ball's surface at the contact
};

/// The ball's motion as it enters the law of contact.
struct Moment {
    Vec3 velocity{0.0}, spin{0.0};
    Vec3 gravity{0.0};
    double radius = 0.0;
    double rounding = 16.0 * 0x1p-52; ///< relative, of the normals
    double settled = 4e-15;           ///< change of a direction that counts as rounding
    uint32_t mostPressing = 4;        ///< contacts with different normals that press, model.md 14.1
};

/// The modes that hold, and the resulting accelerations.
struct Response {
    std::array<Reaction, kMostHeld> reactions; ///< the first `count` are valid
    uint32_t count = 0;
    Vec3 acceleration{0.0}, spinAcceleration{0.0};
    Vec3 rolling{0.0};   ///< unit vector hat(om_t), which rolling resistance opposes; 0 if there is no resistance
    double noise = 0.0;  ///< m/s^2: accelerations up to this are rounding
    bool isFound = true; ///< false: no combination of modes fits, model.md 14.1
    /// Two contacts stick only as they press each other, and resistance depends on that.
    bool isPrestressed = false;

    std::span<const Reaction> list() const { return {reactions.data(), count}; }
};

/// Slip velocity of the ball's surface at a contact.
Vec3 slipAt(const Moment &moment, const Vec3 &normal);

/// Whether a slip is zero up to rounding.
bool isNoSlip(const Moment &moment, const Vec3 &slip);

/// Modes known not to last beyond this moment: bits of the contacts that open now, and of those that begin to slip.
struct Excluded {
    uint32_t closed = 0, sticking = 0;
};

/// Of all combinations of modes that fit, the one with the smallest sum of N; of equal sums the one with the most
/// contacts. The result is meaningless once the work limit is exceeded.
Response respond(const Moment &moment, std::span<const Held> held, Work &work, const Excluded &excluded = {});

/// Ends slips at once where no combination of modes fits, by impulses within Coulomb's cones: the ball jams, model.md
/// 14.1. Never adds energy. False if there are no such impulses.
bool endSlips(Moment &moment, std::span<const Held> held, Work &work);

/// Ends all slips at rough contacts, whatever friction that requires. Never adds energy.
void stopSlips(Moment &moment, std::span<const Held> held, Work &work);

/// Magnitude of the accelerations at a moment, to which rounding is relative: |g| + v^2/R + R om^2.
double accelerationScale(const Moment &moment);

/// Magnitude of the speeds at a moment: |v| + R |om| + sqrt(R |g|).
double speedScale(const Moment &moment);

/// Rounding error of a contact's friction limit mu N due to N: it grows with the friction, m/s^2.
double roundingOfLimit(const Moment &moment, double friction);

} // namespace phys
