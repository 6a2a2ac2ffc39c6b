// SPDX-License-Identifier: MIT
// How long contacts of the general phase stick, and which of them open or slip immediately: model.md 14.1, 14.2.
#include "contact/held.h"
#include "phases/series.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kLookAhead = 0x1p-6; // share of the horizon after which the sign of a force that is zero now shows
constexpr double kParallel = 1e-12;   // square of the sine of the angle between normals

/// Whether a quantity that is zero up to rounding falls from now on: the sign of its first value that isn't zero.
bool falls(const Jet &f, double zero, double end) {
    double s = 0x1p-30 * end;
    while (s < end && std::abs(f.at(s)) <= 2.0 * zero) s *= 2.0;
    return f.at(std::min(s, end)) < -zero;
}

/// (limit times the square root of mu2)^2 minus the square of the required friction. Its last term isn't known.
Jet squaresApart(double mu2, const Jet &limit2, const Jet &needed2) {
    Jet left = sum(0.0, -1.0, needed2, sum(0.0, mu2, limit2));
    left[kOrder] = 0.0;
    return left;
}

/// The range of forces along the line between two contacts that bring the force at one of them into its cone.
struct Range {
    double least, most;
};
constexpr Range kNone{kNever, -kNever};

/// r, n: force and normal at the contact. along: the force on it per unit of force along the line.
Range rangeOfCone(double mu, const Vec3 &r, const Vec3 &n, const Vec3 &along) {
    // |r + s along|^2 = (1 + mu^2) (n.(r + s along))^2
    const double most = 1.0 + mu * mu, rn = glm::dot(r, n), ln = glm::dot(along, n);
    const double q2 = glm::dot(along, along) - most * ln * ln, q1 = glm::dot(r, along) - most * rn * ln;
    const double q0 = glm::dot(r, r) - most * rn * rn, discriminant = q1 * q1 - q2 * q0;
    if (discriminant < 0.0) return kNone;
    const double q = -(q1 + std::copysign(std::sqrt(discriminant), q1));
    if (q == 0.0) return q2 <= 0.0 ? Range{0.0, kNever} : Range{0.0, 0.0};
    const double near = q0 / q, far = q2 != 0.0 ? q / q2 : near;
    if (q2 <= 0.0) return {std::max(near, far), kNever}; // the friction suffices for any such pressure
    const double low = std::min(near, far), high = std::max(near, far);
    return rn - q1 / q2 * ln >= 0.0 ? Range{low, high} : kNone;
}

} // namespace

/// Without the friction that rolling resistance needs: model.md 2.2.
VecJet Series::frictionOf(const Contact &contact) const {
    VecJet friction;
    for (int k = 0; k <= kOrder; ++k) {
        friction[k] = contact.r[k] - (contact.isFlat ? contact.N[k] * contact.n[0] : termOf(contact.N, contact.n, k));
    }
    if (rolls(contact)) {
        const double share = frictionOfResistance(contact);
        for (int k = 0; k <= kOrder; ++k) {
            friction[k] += share * glm::cross(termOf(contact.N, m_rolling, k), contact.held.normal);
        }
    }
    return friction;
}

/// The friction that resistance needs at the contact where it acts, per N. Another contact that sticks takes part of
/// it: model.md 14.1.
double Series::frictionOfResistance(const Contact &contact) const {
    const Contact *other = otherSticking(contact);
    if (!other) return 5.0 / 7.0 * contact.held.resistance;
    const double inertia = 4.5 + 2.5 * glm::dot(contact.n[0], other->n[0]);
    return (1.0 - 1.0 / inertia) * contact.held.resistance;
}

/// The other sticking contact if exactly two stick.
const Series::Contact *Series::otherSticking(const Contact &contact) const {
    const Contact *other = nullptr;
    for (const Contact &one : contacts()) {
        if (one.mode != Mode::sticking || &one == &contact) continue;
        if (other) return nullptr;
        other = &one;
    }
    return other;
}

/// A reserve that is zero up to rounding.
double Series::noReserve(const Contact &contact, double pressure) const {
    const double mu = contact.held.friction;
    return 2.0 * (m_noForce + roundingOfLimit(m_moment, mu)) * mu * pressure;
}

/// Whether a contact with a normal that never turns has friction left until s units: it is the only one that sticks,
/// and the friction that it needs is certainly less than that of its least pressure.
bool Series::holdsUntil(const Contact &contact, double s) const {
    constexpr double kCertain = 0.9;
    if (!contact.isFlat || otherSticking(contact)) return false;
    double friction = 0.0, change = 0.0; // bounds
    for (int k = m_last; k >= 0; --k) {
        const Vec3 across = glm::abs(contact.r[k] - contact.N[k] * contact.n[0]);
        friction = friction * s + (across.x + across.y + across.z);
        if (k > 0) change = (change + std::abs(contact.N[k])) * s;
    }
    const double resistance = 5.0 / 7.0 * contact.held.resistance; // which needs none of it, or that much less
    return friction + resistance * (contact.N[0] + change) < kCertain * contact.held.friction * (contact.N[0] - change);
}

/// (mu N)^2 less the square of the friction.
const Series::Reserve &Series::reserveOf(const Contact &contact) const {
    const auto i = static_cast<uint32_t>(&contact - m_contacts.data());
    if (!(m_knownReserves >> i & 1U)) m_reserves[i] = findReserve(contact);
    m_knownReserves |= 1U << i;
    return m_reserves[i];
}

Series::Reserve Series::findReserve(const Contact &contact) const {
    const VecJet friction = frictionOf(contact);
    Reserve beside;
    if (const Contact *other = otherSticking(contact); other && takeReserve(contact, *other, friction, beside)) {
        return beside;
    }
    const double mu = contact.held.friction;
    return {squaresApart(mu * mu, product(contact.N, contact.N), dot(friction, friction)),
            noReserve(contact, contact.N[0])};
}

/// For two sticking contacts: the friction reserve of the first in the direction in which the other leaves it free to
/// slip, without the forces between both that act across that direction; times a factor that is 1 at the start. False
/// if it would have to pull. model.md 14.1.
bool Series::takeReserve(const Contact &contact, const Contact &other, const VecJet &friction, Reserve &reserve) const {
    const Jet cosine = dot(contact.n, other.n), more = sum(1.0, 1.0, cosine), inertia = sum(4.5, 2.5, cosine);
    VecJet free, tangent;
    for (int k = 0; k <= kOrder; ++k) {
        free[k] = contact.crossNormal(other.n, k);
        tangent[k] = termOf(cosine, contact.n, k) - other.n[k];
    }
    const Jet squaredSine = dot(free, free), slide = dot(friction, tangent);
    const Jet most = sum(0.0, -1.0, slide, product(more, contact.N));
    if (!(more[0] > kParallel) || !(squaredSine[0] > kParallel) || !(most[0] > 0.0)) return false;
    const Jet limit = product(inertia, most);
    Jet needed = product(inertia, product(more, dot(friction, free)));
    if (rolls(other)) {
        needed = sum(0.0, -other.held.resistance, product(slide, dot(m_rolling, contact.n)), needed);
    }
    const double mu = contact.held.friction, unit = inertia[0] * more[0];
    reserve.left = squaresApart(mu * mu, product(squaredSine, product(limit, limit)), product(needed, needed));
    for (double &term : reserve.left.c) term /= unit * unit * squaredSine[0];
    reserve.none = noReserve(contact, std::max(contact.N[0], most[0] / more[0]));
    return true;
}

bool Series::slipsBack(uint32_t spent) const {
    const double soon = kLookAhead * length();
    for (uint32_t i = 0; i < m_count; ++i) {
        if ((spent >> given(i) & 1U) && !(slipSpeed(m_contacts[i]).at(soon) > 0.0)) return true;
    }
    return false;
}

/// Whether a contact is one of two that stick by prestress alone: its pressure is due to forces that aren't in the
/// series. Those of a contact whose friction is spent now, but which doesn't start, are the least with which it sticks.
bool Series::isPrestressed(const Contact &contact) const {
    constexpr double kSpent = 1e-9; // relative to the largest friction, squared
    const Contact *other = contact.mode == Mode::sticking ? otherSticking(contact) : nullptr;
    if (!other || contact.held.isGlued) return false;
    const double most = contact.held.friction * contact.N[0];
    const Vec3 friction = contact.r[0] - contact.N[0] * contact.n[0];
    return contact.isKept || other->isKept || glm::dot(friction, friction) >= (1.0 - kSpent) * most * most;
}

/// Of two contacts that stick by the least prestress, on which resistance depends, the one with no friction left.
void Series::findPrestressed(const Response &response) {
    m_prestressed = kMostHeld;
    if (!response.isPrestressed || m_rolls == kMostHeld) return;
    double least = kNever;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.mode != Mode::sticking || contact.held.isGlued) continue;
        const Vec3 friction = contact.r[0] - contact.N[0] * contact.n[0] + contact.N[0] * resisting(contact, 0);
        const double most = contact.held.friction * contact.N[0], left = 1.0 - squared(friction) / (most * most);
        if (!(left < least)) continue;
        least = left;
        m_prestressed = i;
    }
}

/// Term k of the friction that resistance doesn't need at a contact, per N.
Vec3 Series::resisting(const Contact &contact, int k) const {
    if (!rolls(contact)) return Vec3(0.0);
    return frictionOfResistance(contact) * glm::cross(m_rolling[k], contact.held.normal);
}

/// Two contacts whose friction is spent at the same moment, with the smallest forces between both that hold them: bits,
/// the directions of the slips, and those forces.
uint32_t Series::spentTogether(std::span<Reaction> reactions, std::span<Vec3> slips) const {
    constexpr double kTogether = 1e-9; // relative to the largest friction, squared
    if (m_rolls < m_count) return 0;   // resistance ends with the rolling, and the forces jump
    uint32_t bits = 0;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.mode != Mode::sticking) continue;
        const Contact *other = otherSticking(contact);
        if (!other) return 0;
        const Vec3 line = contact.n[0] - other->n[0];
        const double least = std::max(rangeOfCone(contact.held.friction, contact.r[0], contact.n[0], line).least,
                                      rangeOfCone(other->held.friction, other->r[0], other->n[0], -line).least);
        if (!(std::abs(least) < kNever)) return 0;
        const Vec3 force = contact.r[0] + least * line;
        const double pressure = glm::dot(force, contact.n[0]), most = contact.held.friction * pressure;
        const Vec3 friction = force - pressure * contact.n[0];
        if (glm::dot(friction, friction) < (1.0 - kTogether) * most * most) return 0;
        bits |= 1U << given(i);
        slips[given(i)] = m_mirror.back(-hat(friction));
        reactions[given(i)].force = m_mirror.back(force);
        reactions[given(i)].pressure = pressure;
    }
    return bits;
}

/// Friction at a contact, across the line to another one at which resistance acts, per unit of force along that line:
/// what the resistance to the pressure there needs of it.
Vec3 Series::rubbedPerPrestress(const Contact &contact, const Contact &other, double s) const {
    if (!rolls(other)) return Vec3(0.0);
    const Vec3 n = other.n[0];
    const double cosine = glm::dot(contact.n[0], n);
    return other.held.resistance * (1.0 - cosine) / (4.5 + 2.5 * cosine) * glm::cross(m_rolling.at(s), n);
}

/// For two contacts that stick: when no forces between both hold them any longer, or, if they stick by prestress alone,
/// another one of the two determines the smallest. Both then slip, if they can. In units; kNever if not before s.
double Series::endOfPrestress(double s, Work &work) const {
    constexpr int kLooks = 16, kHalvings = 50;
    const Contact *one = nullptr, *other = nullptr;
    bool isKept = false;
    for (const Contact &contact : contacts()) {
        if (contact.mode != Mode::sticking || contact.held.isGlued) continue;
        one = &contact;
        isKept = isKept || contact.isKept;
    }
    if (one) other = otherSticking(*one);
    if (!other) return kNever;
    const VecJet frictions[] = {frictionOf(*one), frictionOf(*other)};
    const auto look = [&](double at) {
        work.add(Work::kJet);
        const Vec3 n = one->n.at(at), m = other->n.at(at), line = n - m;
        const Vec3 toOne = line + rubbedPerPrestress(*one, *other, at);
        const Vec3 toOther = rubbedPerPrestress(*other, *one, at) - line;
        const Range a = rangeOfCone(one->held.friction, frictions[0].at(at) + one->N.at(at) * n, n, toOne);
        const Range b = rangeOfCone(other->held.friction, frictions[1].at(at) + other->N.at(at) * m, m, toOther);
        const bool holds = std::min(a.most, b.most) >= std::max(a.least, b.least);
        return std::array{holds, isKept && a.least < b.least};
    };
    const auto first = look(0.0);
    if (!first[0] && !isKept) return kNever; // they are about to slip, which their reserves tell
    return firstHolding([&](double at) { return look(at) != first; }, s, kLooks, kHalvings);
}

uint32_t Series::opening() const {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Jet &N = m_contacts[i].N;
        if (N[0] <= m_noForce && falls(N, m_noForce, kLookAhead * length())) bits |= 1U << given(i);
    }
    return bits;
}

uint32_t Series::spent(std::span<Vec3> slips) const {
    uint32_t bits = 0, prestressed = 0; // of the latter it was spent before
    const double soon = kLookAhead * length();
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (contact.mode != Mode::sticking || contact.held.isGlued || contact.isKept) continue;
        if (isIdle(contact, soon)) continue; // there is none to be spent
        if (holdsUntil(contact, soon)) continue;
        const auto &[left, none] = reserveOf(contact);
        if (left[0] > none || !falls(left, none, soon)) continue;
        const double most = contact.held.friction * contact.N[0];
        (left[0] < -none ? prestressed : bits) |= 1U << given(i);
        // While all friction is below rounding, it has no direction.
        const VecJet friction = frictionOf(contact);
        slips[given(i)] = m_mirror.back(-hat(2.0 * left[0] < most * most ? friction[0] : friction.at(soon)));
    }
    return bits ? bits : prestressed;
}

} // namespace phys
