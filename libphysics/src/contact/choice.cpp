// SPDX-License-Identifier: MIT
#include "contact/choice.h"

#include "contact/held.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr uint64_t kMostChoice = 412'500; ///< work of one choice
constexpr uint32_t kMany = 5;             ///< contacts, among which at most kFewest are tried together:
constexpr uint32_t kFewest = 3;           ///< as many as there are independent normals
constexpr double kSettled = 1e-9;         ///< change of a direction that is left to Newton's method

struct Substep {
    const Moment &moment;
    double rollingFriction;
    double h; ///< s
};

/// Speed that a share of the weight, or what rounding a feature takes, ends within a substep, m/s.
double endedSpeed(const Substep &substep, double share) {
    const Moment &moment = substep.moment;
    return share * substep.h * (glm::length(moment.gravity) + squared(moment.velocity) / moment.radius);
}

/// Whether resistance may end the spin within the substep, so that it holds the ball.
bool mayStop(const Substep &substep) {
    const Vec3 spin(substep.moment.spin.x, substep.moment.spin.y, 0.0);
    return substep.moment.radius * glm::length(spin) <= endedSpeed(substep, kInertia * substep.rollingFriction);
}

bool isStill(const Substep &substep, const Contact &contact) {
    const double most = endedSpeed(substep, std::min(1.0, contact.friction));
    return glm::length(slipAt(substep.moment, contact.normal)) <= most;
}

/// Whether the law has a single solution. Resistance that holds a ball may press it against other contacts, and depends
/// on the pressure of two that stick while the ball rounds an edge.
bool isOnlySolution(const Substep &substep, const Contacts &contacts) {
    bool isOnTop = false, isGlued = false, leans = false, isRough = false, turns = false;
    uint32_t still = 0;
    for (const Contact &contact : contacts) {
        isOnTop = isOnTop || contact.isTop;
        isGlued = isGlued || contact.isGlued;
        leans = leans || (!contact.isTop && contact.normal.z != 0.0);
        isRough = isRough || (!contact.isTop && contact.friction > 0.0);
        if (substep.rollingFriction == 0.0 || contact.friction == 0.0 || !isStill(substep, contact)) continue;
        turns = turns || !contact.isFace();
        ++still;
    }
    const bool resists = isOnTop && substep.rollingFriction > 0.0;
    if (resists && turns && still > 1) return false;
    if (resists && (leans || isRough) && mayStop(substep)) return false;
    return areUncoupled(contacts) && !(isGlued && leans);
}

Held heldOf(const Substep &substep, const Contact &contact) {
    Held held{};
    held.normal = contact.normal;
    held.across = contact.across(Vec3(1.0));
    held.friction = contact.friction;
    held.resistance = contact.isTop ? substep.rollingFriction : 0.0;
    held.isGlued = contact.isGlued;
    held.isStill = isStill(substep, contact);
    return held;
}

/// The contacts among which modes are chosen.
struct Part {
    std::array<Held, kMostHeld> held;
    std::array<uint32_t, kMostHeld> number; ///< of `contacts`
    uint32_t count = 0;
    bool isFull = false; ///< there are more

    /// Those that the ball leaves at no more than most(contact), m/s.
    template<class Most>
    Part(const Substep &substep, const Contacts &contacts, Most most) {
        const Moment &moment = substep.moment;
        const double negligible = negligibleSpeed({moment.velocity, moment.spin}, moment.radius);
        for (uint32_t i = 0; i < contacts.count(); ++i) {
            if (glm::dot(moment.velocity, contacts[i].normal) > std::max(most(contacts[i]), negligible)) continue;
            if (isFull = count == kMostHeld; isFull) return;
            number[count] = i;
            held[count++] = heldOf(substep, contacts[i]);
        }
    }
    std::span<const Held> list() const { return {held.data(), count}; }
    bool has(uint32_t contact) const {
        return std::find(number.begin(), number.begin() + count, contact) != number.begin() + count;
    }
};

/// Whether the ball doesn't come back within the substep to the contacts of `all` that `some` lacks.
bool staysOff(const Substep &substep, const Contacts &contacts, const Part &all, const Part &some,
              const Vec3 &acceleration) {
    const Moment &moment = substep.moment;
    return std::all_of(all.number.begin(), all.number.begin() + all.count, [&](uint32_t i) {
        const Vec3 velocity = moment.velocity + substep.h * acceleration;
        const double turning = substep.h * contacts[i].curving(moment.velocity, moment.radius);
        return some.has(i) || glm::dot(contacts[i].normal, velocity) + turning >= 0.0;
    });
}

/// Speed along the normal at which the ball may approach a contact that modes leave open, m/s, 0 or less: they fit
/// within a tolerance far above that of solving, which would let such a contact press.
double approachOf(const Substep &substep, const Contact &contact, const Response &response) {
    constexpr double kMost = 4e-8; // rad: within it no edge's gap tells it from a face
    const Moment &moment = substep.moment;
    const double turning = contact.curving(moment.velocity, moment.radius);
    const Vec3 velocity = moment.velocity + substep.h * response.acceleration;
    const double speed = glm::dot(contact.normal, velocity) + substep.h * turning;
    return speed >= -kMost * glm::length(velocity) ? std::min(speed, 0.0) : 0.0;
}

/// What rolling resistance adds to the spin, rad/s: that which the forces don't.
Vec3 resistanceIn(const Response &response, std::span<const Held> held, double radius) {
    Vec3 resisting = response.spinAcceleration;
    for (uint32_t i = 0; i < response.count; ++i)
        resisting += kInertia / radius * glm::cross(held[i].normal, response.reactions[i].force);
    return resisting;
}

/// Ends the slips of the contacts that stay. False if none slips: what a substep ends by itself is no jam.
template<class End>
bool endBy(End end, const Contacts &contacts, const Substep &substep, Work &work, Moment &moment) {
    const Part part(substep, contacts, [](const Contact &contact) { return contact.restSpeed; });
    const bool slips = std::any_of(part.list().begin(), part.list().end(),
                                   [](const Held &held) { return held.friction > 0.0 && !held.isStill; });
    if (!slips) return false;
    Work own(kMostChoice);
    const bool ends = end(moment, part.list(), own);
    work.add(2 * own.done() / 3);
    return ends && !own.isTooMuch();
}

} // namespace

bool choose(const Contacts &contacts, const Moment &moment, double rollingFriction, double h, Work &work,
            LastingContacts &lasting) {
    if (contacts.count() < 2) return false;
    Substep substep{moment, rollingFriction, h};
    if (isOnlySolution(substep, contacts)) return false;
    Moment stopped = moment;
    stopped.settled = kSettled;
    if (rollingFriction > 0.0 && mayStop(substep)) stopped.spin.x = stopped.spin.y = 0.0;
    Part part(substep, contacts, [](const Contact &contact) { return contact.restSpeed; });
    if (part.isFull) return false;
    Work own(kMostChoice);
    const auto respondTo = [&](const Part &among) {
        stopped.mostPressing = among.count >= kMany ? kFewest : Moment{}.mostPressing;
        return respond(stopped, among.list(), own);
    };
    // One that the ball leaves slowly takes part only if the others let it come back.
    const Part staying(substep, contacts, [](const Contact &) { return 0.0; });
    Response response;
    response.isFound = false;
    if (staying.count < part.count) response = respondTo(staying);
    if (response.isFound && staysOff(substep, contacts, part, staying, response.acceleration))
        part = staying;
    else
        response = respondTo(part);
    work.add(2 * own.done() / 3); // its equations are small
    if (own.isTooMuch()) return false;
    if (!response.isFound) return true;
    const Vec3 resisting = h * resistanceIn(response, part.list(), moment.radius);
    for (uint32_t i = 0; i < part.count; ++i) {
        const Reaction &reaction = response.reactions[i];
        Lasting &contact = lasting[part.number[i]];
        contact.isIdle = contact.isGlued && reaction.mode == Mode::open;
        if (reaction.mode == Mode::open)
            contact.slow = std::min(contact.slow, approachOf(substep, contacts[part.number[i]], response));
        // Pressure of rounding size might grow by the friction of a very rough contact opposite to another.
        if (reaction.pressure <= response.noise) continue;
        contact.reaction = h * reaction.pressure;
        contact.rubbing = h * tangential(reaction.force, part.held[i].normal);
        contact.isSpent = reaction.mode == Mode::slipping || reaction.mode == Mode::starting;
        contact.rolls = contact.isTop && reaction.mode == Mode::sticking;
        if (contact.rolls && rollingFriction > 0.0) contact.resisting = tangential(resisting, part.held[i].normal);
    }
    lasting.setChosen();
    if (response.isPrestressed) lasting.setPrestressed();
    return false;
}

bool endJam(const Contacts &contacts, double rollingFriction, double h, Work &work, Moment &moment) {
    return endBy(endSlips, contacts, {moment, rollingFriction, h}, work, moment);
}

bool stopJam(const Contacts &contacts, double rollingFriction, double h, Work &work, Moment &moment) {
    const auto stop = [](Moment &jammed, std::span<const Held> held, Work &own) {
        stopSlips(jammed, held, own);
        return true;
    };
    return endBy(stop, contacts, {moment, rollingFriction, h}, work, moment);
}

} // namespace phys
