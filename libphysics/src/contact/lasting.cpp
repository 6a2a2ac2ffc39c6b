// SPDX-License-Identifier: MIT
#include "contact/lasting.h"

#include <cmath>

namespace phys {

namespace {

constexpr int kMostSweeps = 3000;

/// Changes below this share of the speeds are rounding.
constexpr double kNegligible = 1e-15;

Vec3 across(const Vec3 &v, const Vec3 &normal) { return v - glm::dot(v, normal) * normal; }

Vec3 clipped(const Vec3 &v, double most) {
    const double size = glm::length(v);
    return size > most ? most / size * v : v;
}

double size(const Vec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The least reaction that keeps the ball from approaching.
double reactionOf(const Lasting &contact, const Motion &motion) {
    const double missing = contact.slow - glm::dot(contact.limit, motion.velocity);
    return std::max(0.0, contact.reaction + missing / glm::dot(contact.limit, contact.lever));
}

bool isWithinCone(const Lasting &contact, const Vec3 &rubbing) {
    const double most = contact.friction * contact.reaction;
    return glm::dot(rubbing, rubbing) <= most * most;
}

/// Friction that ends the slip, or as much of it as Coulomb's cone allows against the mean slip.
Vec3 frictionOf(const Lasting &contact, const Motion &motion, double radius) {
    if (contact.reaction == 0.0 || (contact.friction == 0.0 && !contact.isGlued)) return Vec3(0.0);
    const Vec3 slip = slipAt(motion, contact.limit, radius);
    // An impulse of 1 changes the slip by 7/2.
    const Vec3 sticking = across(contact.rubbing - 2.0 / 7.0 * slip, contact.lever);
    if (contact.isGlued || isWithinCone(contact, sticking)) return sticking;
    return clipped(across(contact.rubbing - 2.0 / 7.0 * (contact.slipBefore + slip), contact.lever),
                   contact.friction * contact.reaction);
}

struct Rolling {
    Vec3 rubbing, resisting;
};

/// Friction and rolling resistance of a top face that sticks, both at once. One after the other they would take a
/// hundred rounds to agree: with the slip ended, a resistance of 1 changes the spin by 2/7, and friction by 2R/7 across
/// it. `before` shares in the direction, as in resistanceOf.
Rolling rollingOf(const Lasting &contact, const Motion &before, const Motion &motion, double radius, double most) {
    const Vec3 &normal = contact.lever;
    const Vec3 slip = slipAt(motion, normal, radius);
    const Vec3 ended = contact.rubbing - 2.0 / 7.0 * (slip + radius * glm::cross(contact.resisting, normal));
    const Vec3 turned = glm::cross(normal, ended - contact.rubbing);
    const Vec3 spin = across(motion.spin - contact.resisting - 2.5 / radius * turned, normal);
    Vec3 resisting = -3.5 * spin;
    if (glm::dot(resisting, resisting) > most * most) {
        const Vec3 mean = across(before.spin, normal) + spin;
        const double length = glm::length(mean);
        resisting = length > 0.0 ? -most / length * mean : Vec3(0.0);
    }
    return {across(ended + 2.0 / 7.0 * radius * glm::cross(resisting, normal), normal), resisting};
}

/// Resistance against the mean spin, at most what ends it.
Vec3 resistanceOf(const Lasting &contact, const Motion &before, const Motion &motion, double most) {
    const Vec3 holding = across(contact.resisting - motion.spin, contact.lever);
    if (glm::dot(holding, holding) <= most * most) return holding;
    return clipped(across(contact.resisting - before.spin - motion.spin, contact.lever), most);
}

} // namespace

/// One round of Gauss-Seidel, each contact in closed form.
void LastingContacts::sweep(const Motion &before, double rollingFriction, Motion &motion) {
    for (Lasting &contact : *this) {
        const double reaction = reactionOf(contact, motion);
        const double pushed = reaction - contact.reaction;
        motion.velocity += pushed * contact.lever;
        contact.reaction = reaction;

        const double most = 2.5 * rollingFriction * contact.reaction / m_radius;
        const bool resists = rollingFriction > 0.0 && contact.rolls;
        Rolling answer{contact.rubbing, contact.resisting};
        if (resists) answer = rollingOf(contact, before, motion, m_radius, most);
        const bool sticks = resists && (contact.isGlued || isWithinCone(contact, answer.rubbing));
        if (!sticks) answer = {frictionOf(contact, motion, m_radius), contact.resisting};
        const Vec3 rubbed = answer.rubbing - contact.rubbing;
        motion.velocity += rubbed;
        motion.spin -= 2.5 / m_radius * glm::cross(contact.lever, rubbed);
        contact.rubbing = answer.rubbing;
        if (resists && !sticks) answer.resisting = resistanceOf(contact, before, motion, most);
        const Vec3 resisted = answer.resisting - contact.resisting;
        motion.spin += resisted;
        contact.resisting = answer.resisting;
    }
}

/// Rounds until the motion stays: contacts with nearly the same normal may pass their load to and fro for ever.
/// negligible: m/s; changes below it are rounding.
bool LastingContacts::settle(const Motion &before, double rollingFriction, double negligible, Motion &motion) {
    for (int i = 0; i < kMostSweeps; ++i) {
        const Motion previous = motion;
        sweep(before, rollingFriction, motion);
        const double changed =
            std::max(size(motion.velocity - previous.velocity), m_radius * size(motion.spin - previous.spin));
        if (changed <= negligible) return true;
    }
    return false;
}

/// Two contacts that stick can be pressed against each other without moving anything, along the line between their
/// points. Of all such answers the one with the least friction holds, model.md 13.3: this changes to it, where the
/// cones allow. Returns the largest change, m/s.
double LastingContacts::relieve() {
    double largest = 0.0;
    for (Lasting *a = begin(); a != end(); ++a) {
        for (Lasting *b = a + 1; b != end(); ++b) {
            if (!a->sticks() || !b->sticks()) continue;
            const Vec3 line = a->lever - b->lever;
            const Vec3 acrossA = across(line, a->lever);
            const Vec3 acrossB = across(line, b->lever);
            const double size = glm::dot(acrossA, acrossA) + glm::dot(acrossB, acrossB);
            if (size <= kNegligible) continue; // parallel normals
            const double share = (glm::dot(b->rubbing, acrossB) - glm::dot(a->rubbing, acrossA)) / size;
            Lasting relievedA = *a;
            Lasting relievedB = *b;
            relievedA.reaction += share * glm::dot(line, a->lever);
            relievedA.rubbing += share * acrossA;
            relievedB.reaction -= share * glm::dot(line, b->lever);
            relievedB.rubbing -= share * acrossB;
            if (!relievedA.sticks() || !relievedB.sticks()) continue;
            *a = relievedA;
            *b = relievedB;
            largest = std::max(largest, std::abs(share));
        }
    }
    return largest;
}

void LastingContacts::solve(double rollingFriction, const Motion &before, Motion &motion) {
    // Of the motion that gravity alone would give: contacts may leave next to nothing of it, but its rounding.
    const double negligible = kNegligible * (size(motion.velocity) + m_radius * size(motion.spin));
    settle(before, 0.0, negligible, motion);
    if (rollingFriction == 0.0) return;
    relieve();
    bool anyRolls = false;
    for (Lasting &contact : *this) {
        contact.rolls = contact.isTop && contact.reaction > 0.0 && (contact.isGlued || contact.sticks());
        anyRolls = anyRolls || contact.rolls;
    }
    if (!anyRolls) return;
    // The resistance depends on how contacts share their load.
    constexpr int kMostShares = 20;
    for (int i = 0; i < kMostShares; ++i) {
        settle(before, rollingFriction, negligible, motion);
        if (relieve() <= negligible) return;
    }
}

} // namespace phys
