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

/// Friction that ends the slip, or as much of it as Coulomb's cone allows against the mean slip.
Vec3 frictionOf(Lasting &contact, const Motion &motion, double radius) {
    contact.isSpent = false;
    if (contact.reaction == 0.0 || (contact.friction == 0.0 && !contact.isGlued)) return Vec3(0.0);
    const Vec3 slip = slipAt(motion, contact.limit, radius);
    // An impulse of 1 changes the slip by 7/2.
    const Vec3 sticking = across(contact.rubbing - 2.0 / 7.0 * slip, contact.lever);
    const double most = contact.friction * contact.reaction;
    if (contact.isGlued || glm::dot(sticking, sticking) <= most * most) return sticking;
    contact.isSpent = true;
    return clipped(across(contact.rubbing - 2.0 / 7.0 * (contact.slipBefore + slip), contact.lever), most);
}

/// Resistance against the mean spin, at most what ends it.
Vec3 resistanceOf(const Lasting &contact, const Motion &motion, double most) {
    const Vec3 holding = across(contact.resisting - motion.spin, contact.lever);
    if (glm::dot(holding, holding) <= most * most) return holding;
    return clipped(across(contact.resisting - contact.spinBefore - motion.spin, contact.lever), most);
}

} // namespace

/// One round of Gauss-Seidel, each contact in closed form. Returns the largest change, m/s.
double LastingContacts::sweep(double rollingFriction, Motion &motion) {
    double largest = 0.0;
    for (Lasting &contact : *this) {
        const double reaction = reactionOf(contact, motion);
        const double pushed = reaction - contact.reaction;
        motion.velocity += pushed * contact.lever;
        contact.reaction = reaction;

        const Vec3 rubbing = frictionOf(contact, motion, m_radius);
        const Vec3 rubbed = rubbing - contact.rubbing;
        motion.velocity += rubbed;
        motion.spin -= 2.5 / m_radius * glm::cross(contact.lever, rubbed);
        contact.rubbing = rubbing;
        largest = std::max({largest, std::abs(pushed), size(rubbed)});

        if (rollingFriction == 0.0 || !contact.rolls) continue;
        const double most = 2.5 * rollingFriction * contact.reaction / m_radius;
        const Vec3 resisting = resistanceOf(contact, motion, most);
        const Vec3 resisted = resisting - contact.resisting;
        motion.spin += resisted;
        contact.resisting = resisting;
        largest = std::max(largest, m_radius * size(resisted));
    }
    return largest;
}

/// False if that comes to no end.
bool LastingContacts::settle(double rollingFriction, double negligible, bool releases, Motion &motion) {
    for (int i = 0; i < kMostSweeps; ++i) {
        const bool isSettled = sweep(rollingFriction, motion) <= negligible;
        const bool isReleased = releases && releaseOpposite(negligible);
        if (isSettled && !isReleased) return true;
    }
    return false;
}

void LastingContacts::unload() {
    for (Lasting &contact : *this) {
        contact.reaction = 0.0;
        contact.rubbing = Vec3(0.0);
    }
}

/// driven: the motion without any impulse. Where friction feeds on itself sweeps may come to no end: then a squeeze
/// stays, and if that doesn't help nothing rubs.
void LastingContacts::settleWithoutResistance(double negligible, const Motion &driven, Motion &motion) {
    if (settle(0.0, negligible, true, motion)) return;
    unload();
    motion = driven;
    if (settle(0.0, negligible, false, motion)) return;
    unload();
    motion = driven;
    for (Lasting &contact : *this) contact.friction = 0.0;
    settle(0.0, negligible, true, motion);
}

/// Faces as far apart as the ball is wide may squeeze it without moving anything, but friction feeds on that. The law
/// takes the least reactions, model.md 14.1. Returns whether there was any squeeze.
bool LastingContacts::releaseOpposite(double negligible) {
    bool any = false;
    for (Lasting *a = begin(); a != end(); ++a) {
        for (Lasting *b = a + 1; b != end(); ++b) {
            const double squeeze = std::min(a->reaction, b->reaction);
            if (squeeze <= negligible || size(a->lever + b->lever) > kSameNormal) continue;
            a->reaction -= squeeze;
            b->reaction -= squeeze;
            any = true;
        }
    }
    return any;
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

void LastingContacts::solve(double rollingFriction, Motion &motion) {
    const double negligible = kNegligible * (size(motion.velocity) + m_radius * size(motion.spin));
    const Motion driven = motion;
    for (Lasting &contact : *this) {
        contact.rubbing = across(contact.rubbing, contact.lever);
        motion.velocity += contact.reaction * contact.lever + contact.rubbing;
        motion.spin -= 2.5 / m_radius * glm::cross(contact.lever, contact.rubbing);
    }
    settleWithoutResistance(negligible, driven, motion);
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
        settle(rollingFriction, negligible, true, motion);
        if (relieve() <= negligible) return;
    }
}

} // namespace phys
