// SPDX-License-Identifier: MIT
#include "contact/choice.h"

#include "contact/held.h"

#include <cmath>

namespace phys {

namespace {

constexpr uint32_t kMostChosen = 4;       ///< contacts
constexpr uint64_t kMostChoice = 250'000; ///< work of one choice
constexpr uint64_t kCounted = 2;          ///< of so many units of a choice one counts: its equations are small
constexpr double kSettled = 1e-9;         ///< change of a direction that is left to Newton's method

struct Substep {
    const Moment &moment;
    double rollingFriction;
    double h; ///< s
};

/// How much of contact b's reaction acts along a's normal, at most. None of it counts if their normals are nearly the
/// same, as at a crack in a floor: they share what presses on both.
double couplingOf(const Contact &a, const Contact &b) {
    constexpr double kNearlySame = 1e-4; // rad
    const bool isSameSide = glm::dot(a.normal, b.normal) > 0.0;
    if (isSameSide && glm::length(glm::cross(a.normal, b.normal)) < kNearlySame) return 0.0;
    return mostCoupling(b.normal, b.friction, a.normal);
}

/// Whether friction can't hold what it presses by itself: the reactions of the other contacts always change the speed
/// along a normal by less than its own reaction does.
bool areUncoupled(const Contacts &contacts) {
    if (std::none_of(contacts.begin(), contacts.end(), [](const Contact &contact) { return contact.friction > 0.0; }))
        return true;
    if (contacts.count() == 2) return couplingOf(contacts[0], contacts[1]) * couplingOf(contacts[1], contacts[0]) < 1.0;
    return std::all_of(contacts.begin(), contacts.end(), [&](const Contact &a) {
        double sum = 0.0;
        for (const Contact &b : contacts) sum += &a == &b ? 0.0 : couplingOf(a, b);
        return sum < 1.0;
    });
}

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

/// Whether the law has a single solution. Resistance that holds a ball may press it against other contacts.
bool isOnlySolution(const Substep &substep, const Contacts &contacts) {
    bool isOnTop = false, isGlued = false, leans = false, isRough = false;
    for (const Contact &contact : contacts) {
        isOnTop = isOnTop || contact.isTop;
        isGlued = isGlued || contact.isGlued;
        leans = leans || (!contact.isTop && contact.normal.z != 0.0);
        isRough = isRough || (!contact.isTop && contact.friction > 0.0);
    }
    const bool holds = isOnTop && substep.rollingFriction > 0.0 && mayStop(substep);
    if (holds && (leans || isRough)) return false;
    return areUncoupled(contacts) && !(isGlued && leans);
}

Held heldOf(const Substep &substep, const Contact &contact) {
    const Vec3 slip = slipAt(substep.moment, contact.normal);
    Held held{};
    held.normal = contact.normal;
    held.across = contact.across(Vec3(1.0));
    held.friction = contact.friction;
    held.resistance = contact.isTop ? substep.rollingFriction : 0.0;
    held.isGlued = contact.isGlued;
    held.isStill = glm::length(slip) <= endedSpeed(substep, std::min(1.0, contact.friction));
    return held;
}

/// What rolling resistance adds to the spin, rad/s: that which the forces don't.
Vec3 resistanceIn(const Response &response, std::span<const Held> held, double radius) {
    Vec3 resisting = response.spinAcceleration;
    for (uint32_t i = 0; i < response.count; ++i)
        resisting += kInertia / radius * glm::cross(held[i].normal, response.reactions[i].force);
    return resisting;
}

} // namespace

void choose(const Contacts &contacts, const Moment &moment, double rollingFriction, double h, Work &work,
            LastingContacts &lasting) {
    if (contacts.count() < 2 || contacts.count() > kMostChosen) return;
    Substep substep{moment, rollingFriction, h};
    if (isOnlySolution(substep, contacts)) return;
    Moment stopped = moment;
    stopped.settled = kSettled;
    if (rollingFriction > 0.0 && mayStop(substep)) stopped.spin.x = stopped.spin.y = 0.0;
    std::array<Held, kMostHeld> held;
    std::array<uint32_t, kMostHeld> number;
    uint32_t count = 0;
    const double negligible = negligibleSpeed({moment.velocity, moment.spin}, moment.radius);
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        if (glm::dot(moment.velocity, contacts[i].normal) > std::max(contacts[i].restSpeed, negligible)) continue;
        number[count] = i;
        held[count++] = heldOf(substep, contacts[i]);
    }
    const std::span<const Held> list(held.data(), count);
    Work own(kMostChoice);
    const Response response = respond(stopped, list, own);
    work.add(own.done() / kCounted);
    if (!response.isFound || own.isTooMuch()) return;
    const Vec3 resisting = h * resistanceIn(response, list, moment.radius);
    for (uint32_t i = 0; i < count; ++i) {
        const Reaction &reaction = response.reactions[i];
        Lasting &contact = lasting[number[i]];
        contact.reaction = h * std::max(0.0, reaction.pressure);
        contact.rubbing = h * tangential(reaction.force, held[i].normal);
        contact.isSpent = reaction.mode == Mode::slipping || reaction.mode == Mode::starting;
        contact.isIdle = contact.isGlued && reaction.mode == Mode::open;
        contact.rolls = contact.isTop && reaction.mode == Mode::sticking && contact.reaction > 0.0;
        if (contact.rolls && rollingFriction > 0.0) contact.resisting = tangential(resisting, held[i].normal);
    }
    lasting.setChosen();
}

} // namespace phys
