// SPDX-License-Identifier: MIT
#include "contact/impact.h"

#include "contact/least_push.h"
#include "contact/slip_energy.h"

#include <cmath>

namespace phys {

namespace {

/// The contacts that take part in a round.
struct Round {
    std::array<Push, Contacts::kMost> pushes;
    std::array<uint32_t, Contacts::kMost> contacts;
    uint32_t count = 0;

    void add(uint32_t contact, const Vec3 &normal, double wanted) {
        contacts[count] = contact;
        pushes[count++] = {normal, wanted};
    }
};

/// NORMAL: the smallest impulses that give every contact its required speed.
void pushApart(Round &round, double negligible, Motion &motion, Work &work) {
    motion.velocity += leastPush({round.pushes.data(), round.count}, negligible, work);
}

/// FRICTION: of all impulses within the cones, those that leave the least energy.
void rub(const Contacts &contacts, const Round &round, double radius, Motion &motion, Work &work) {
    std::array<FrictionDisc, Contacts::kMost> discs;
    uint32_t count = 0;
    for (uint32_t i = 0; i < round.count; ++i) {
        const double most = contacts[round.contacts[i]].friction * round.pushes[i].amount;
        if (most > 0.0) discs[count++] = {round.pushes[i].normal, most, Vec3(0.0)};
    }
    if (count > 0) minimiseSlipEnergy({discs.data(), count}, radius, motion, work);
}

/// The contacts that bounce; if there are none, those that the ball approaches more slowly. These last: together with
/// the others, friction would act there as in an impact.
Round approaching(const Contacts &contacts, const Motion &motion, double negligible) {
    Round round;
    for (const bool bounce : {true, false}) {
        for (uint32_t i = 0; i < contacts.count(); ++i) {
            const Contact &contact = contacts[i];
            const double approach = -glm::dot(motion.velocity, contact.normal);
            if (approach <= (bounce ? std::max(contact.restSpeed, negligible) : negligible)) continue;
            round.add(i, contact.normal, (1.0 + (bounce ? contact.restitution : 0.0)) * approach);
        }
        if (round.count > 0) break;
    }
    return round;
}

/// After the last round, everything that still approaches is stopped.
void stopApproach(const Contacts &contacts, double negligible, Motion &motion, Work &work) {
    Round all;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        all.add(i, contacts[i].normal, -glm::dot(motion.velocity, contacts[i].normal));
    }
    pushApart(all, negligible, motion, work);
}

Impacts resolveInThisOrder(const Contacts &contacts, double radius, Motion &motion, Work &work) {
    Impacts impacts;
    const double negligible = negligibleSpeed(motion, radius);
    double energy = kineticEnergy(motion, radius);
    const auto lost = [&] {
        const double before = std::exchange(energy, kineticEnergy(motion, radius));
        return before - energy;
    };
    for (;; ++impacts.rounds) {
        work.add(Work::kImpact * contacts.count());
        Round round = approaching(contacts, motion, negligible);
        if (round.count == 0) return impacts;
        for (uint32_t i = 0; i < round.count; ++i) {
            double &approach = impacts.approach[round.contacts[i]];
            if (approach == 0.0) approach = glm::dot(motion.velocity, round.pushes[i].normal);
        }
        if (impacts.rounds == kMostImpactRounds) break;
        pushApart(round, negligible, motion, work);
        impacts.lostNormal += lost();
        rub(contacts, round, radius, motion, work);
        impacts.lostSlip += lost();
    }
    stopApproach(contacts, negligible, motion, work);
    impacts.lostNormal += lost();
    return impacts;
}

} // namespace

Impacts resolveImpacts(const Contacts &contacts, double radius, Motion &motion, Work &work) {
    const Motion before = motion;
    Impacts impacts = resolveInThisOrder(contacts, radius, motion, work);
    if (impacts.rounds == 0) return impacts;
    if (contacts.hasTies()) {
        // Contacts that compare equal: the mean of both orders favours none.
        Contacts reversed = contacts;
        reversed.reverseTies();
        Motion other = before;
        const Impacts ofOther = resolveInThisOrder(reversed, radius, other, work);
        motion.velocity = 0.5 * (motion.velocity + other.velocity);
        motion.spin = 0.5 * (motion.spin + other.spin);
        impacts.lostNormal = 0.5 * (impacts.lostNormal + ofOther.lostNormal);
        impacts.lostSlip = 0.5 * (impacts.lostSlip + ofOther.lostSlip);
    }
    dropTraces(before, radius, motion);
    return impacts;
}

} // namespace phys
