// SPDX-License-Identifier: MIT
// Slips whose pressure or direction friction changes so fast that it follows the motion: model.md 14.2.
#include "contact/held.h"
#include "phases/series.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kLeastRate = 8.0 * kOrder; // of what follows, per unit: otherwise passes don't converge
constexpr int kSlavedPasses = 16;

} // namespace

/// The roughest slip, if nothing starts.
bool Series::findSlaved() {
    m_slaved = kMostHeld;
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        if (startsToSlip(contact)) return false;
        if (contact.mode != Mode::slipping || !(contact.N[0] > 0.0)) continue;
        if (m_slaved == kMostHeld || contact.held.friction > m_contacts[m_slaved].held.friction) m_slaved = i;
    }
    return m_slaved < m_count && m_countsSlips && m_shared.rate == 0.0;
}

/// Term k of the normal acceleration at the slaved contact with this pressure, and of all other forces.
double Series::apartWith(int k, double pressure) {
    m_given = pressure;
    forces(k);
    return apart(m_contacts[m_slaved], k);
}

/// Term k + 1 of it, with this pressure of order k and the following one.
double Series::apartAfter(int k, double pressure, double following) {
    apartWith(k, pressure);
    move(k);
    return apartWith(k + 1, following);
}

/// Of a pressure that follows from the motion: of all forces, and of the directions of other slips.
double Series::roundingOfPressure(const Contact &contact) const {
    constexpr double kRoundings = 16.0 * 0x1p-52;
    double size = glm::length(m_moment.gravity) + curvature(m_moment, contact.held);
    for (const Contact &one : contacts()) {
        size += glm::length(one.r[0]);
        if (one.mode != Mode::slipping || &one == &contact) continue;
        size += one.held.friction * one.N[0] * speedScale(m_moment) / glm::length(one.u[0]);
    }
    return kRoundings * size;
}

/// Whether the pressure returns so fast to what the motion implies that it can be found from there: in a small part of
/// the unit.
bool Series::relaxes(double present) {
    const double now = apartWith(0, present) - apartWith(0, 0.0);
    const double later = apartAfter(0, present, 0.0) - apartAfter(0, 0.0, 0.0);
    return now > 0.0 && later > kLeastRate * now;
}

/// Finds the terms of what follows the motion, such that after(k, term k, term k + 1) is zero. present: what it is now;
/// false if that isn't its first term up to rounding, and in the first pass `nearly`.
template<class After>
bool Series::follow(const After &after, double present, double step, double nearly, double rounding, Work &work) {
    constexpr double kSame = 4e-15, kConverges = 0.25;
    Jet terms{};
    double changed = kNever;
    for (int pass = 0; pass < kSlavedPasses; ++pass) {
        const double before = terms[0], changedBefore = changed;
        double most = std::abs(step);
        changed = 0.0;
        for (int k = 0; k < kOrder; ++k) {
            const double further = step / (k + 1), here = after(k, terms[k], terms[k + 1]);
            const double slope = (after(k, terms[k] + further, terms[k + 1]) - here) / further;
            const double change = -here / slope;
            terms[k] += change;
            after(k, terms[k], terms[k + 1]);
            changed = std::max(changed, std::abs(change));
            most = std::max(most, std::abs(terms[k]));
            const double inaccuracy = pass == 0 ? nearly : 4.0 * std::abs(terms[0] - before);
            if (k == 0 && std::abs(terms[0] - present) > inaccuracy + rounding) return false;
        }
        work.add(3 * Work::kSeries * (1 + size()));
        m_reach.length = 0.0; // the unit is much too long
        if (!std::isfinite(changed + most)) return true;
        if (changed <= kSame * most || (pass > 1 && changed > kConverges * changedBefore)) break;
    }
    m_last = kOrder;
    finish();
    return true;
}

bool Series::buildSlaved(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                         Work &work) {
    constexpr double kNearly = 0.1;
    take(moment, held, response, unit, 0);
    work.add(Work::kSeries);
    if (!findSlaved()) return false;
    m_isSlaved = true;
    const double present = m_contacts[m_slaved].N[0], rounding = roundingOfPressure(m_contacts[m_slaved]);
    if (!relaxes(present)) return false;
    const auto after = [&](int k, double pressure, double next) { return apartAfter(k, pressure, next); };
    return follow(after, present, present, kNearly * present, rounding, work);
}

/// Whether friction turns a slip much faster than it changes it.
bool Series::turnsFast(const Contact &contact) const {
    if (contact.mode != Mode::slipping) return false;
    const double rate = std::abs(glm::dot(contact.u[1], contact.d[0])) / unit();
    return kLeastRate * rate < kSlipPerFriction * contact.held.friction * contact.N[0];
}

double Series::timeOfSlips() const {
    double time = std::sqrt(m_moment.radius / accelerationScale(m_moment));
    uint32_t count = 0;
    for (const Contact &contact : contacts()) {
        if (startsToSlip(contact)) return 0.0;
        if (!turnsFast(contact)) continue;
        const double rate = std::abs(glm::dot(contact.u[1], contact.d[0])) / unit();
        if (rate > 0.0) time = std::min(time, glm::length(contact.u[0]) / rate);
        ++count;
    }
    return count > 0 && count <= 2 && m_shared.rate == 0.0 && !m_rollStarts ? time : 0.0;
}

/// n0.(u x d)/|u_0| of each, term k: the part of the slip across its direction.
Vec2 Series::acrossDirections(int k) const {
    Vec2 across(0.0);
    for (int i = 0; i < m_turned.count; ++i) {
        const Contact &contact = m_contacts[m_turned.contacts[i]];
        for (int j = 0; j <= k; ++j) {
            across[i] += glm::dot(glm::cross(contact.u[j], contact.d[k - j]), contact.n[0]);
        }
        across[i] /= glm::length(contact.u[0]);
    }
    return across;
}

/// Turns of order k: `fast` of all slips together, and as much against each other as their slips imply.
void Series::setTurns(int k, double fast) {
    const auto set = [&](const Vec2 &turns) {
        for (int i = 0; i < m_turned.count; ++i) {
            Contact &contact = m_contacts[m_turned.contacts[i]];
            const Vec3 &d = m_turned.starts[i];
            contact.turn[k] = turns[i];
            if (k > 0)
                turn(contact, k);
            else
                contact.d[0] = hat(d + turns[i] * glm::cross(contact.n[0], d));
        }
    };
    const Vec2 turns = fast * m_turned.fast;
    set(turns);
    if (k == 0 || m_turned.count < 2) return;
    const double slow = -glm::dot(m_turned.slowRow, acrossDirections(k)) / glm::dot(m_turned.slowRow, m_turned.slow);
    set(turns + slow * m_turned.slow);
}

/// Term k + 1 of the part of the slips across their directions that friction removes fast, with this turn of order k,
/// and the following one.
double Series::acrossAfter(int k, double fast, double following) {
    setTurns(k, fast);
    forces(k);
    move(k);
    setTurns(k + 1, following);
    return glm::dot(m_turned.fastRow, acrossDirections(k + 1));
}

/// The turn of the slips together that friction resists most. False if it doesn't do so fast enough.
bool Series::findFastTurn() {
    constexpr double kTurn = 1e-6;
    m_turned.count = 0;
    for (uint32_t i = 0; i < m_count; ++i) {
        Contact &contact = m_contacts[i];
        if (!turnsFast(contact)) continue;
        if (m_turned.count == 2) return false;
        contact.isTurned = true;
        contact.turn = Jet{};
        m_turned.starts[m_turned.count] = contact.d[0];
        m_turned.contacts[m_turned.count++] = i;
    }
    if (m_turned.count == 0) return false;
    m_turned.fastRow = {1.0, 0.0};
    const auto acrossWith = [&](const Vec2 &turns) { // without the turns of order 1
        m_turned.fast = turns;
        setTurns(0, 1.0);
        forces(0);
        for (int i = 0; i < m_turned.count; ++i) m_contacts[m_turned.contacts[i]].turn[1] = 0.0;
        move(0);
        return acrossDirections(1);
    };
    const Vec2 none = acrossWith(Vec2(0.0));
    std::array<Vec2, 2> rates{}; // of both slips by the turn of each
    for (int j = 0; j < m_turned.count; ++j) {
        Vec2 turns(0.0);
        turns[j] = kTurn;
        rates[j] = (acrossWith(turns) - none) / kTurn;
    }
    const double a = rates[0].x, b = rates[1].x, c = rates[0].y, d = rates[1].y;
    const double fastest = 0.5 * (a + d) + std::sqrt(std::max(0.0, 0.25 * (a - d) * (a - d) + b * c));
    if (!(fastest > kLeastRate)) return false;
    m_turned.fast = {1.0, 0.0};
    if (m_turned.count < 2) return true;
    // Eigenvectors to the right and left; the slow ones are across those of the other side.
    m_turned.fast = a > d ? Vec2(fastest - d, c) : Vec2(b, fastest - a);
    m_turned.fastRow = a > d ? Vec2(fastest - d, b) : Vec2(c, fastest - a);
    for (Vec2 *turns : {&m_turned.fast, &m_turned.fastRow}) {
        const double size = glm::length(*turns);
        if (!(size > 0.0)) return false;
        *turns /= size;
    }
    m_turned.slow = quarterTurn(m_turned.fastRow);
    m_turned.slowRow = quarterTurn(m_turned.fast);
    return true;
}

bool Series::buildTurning(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                          Work &work) {
    constexpr double kNearly = 0.1, kTurn = 1e-3, kRoundings = 16.0 * 0x1p-52;
    take(moment, held, response, unit, 0);
    work.add(Work::kSeries);
    m_countsSlips = false;
    m_isSlaved = true;
    if (!findFastTurn()) return false;
    double rounding = 0.0;
    for (int i = 0; i < m_turned.count; ++i) {
        rounding += kRoundings * speedScale(m_moment) / glm::length(m_contacts[m_turned.contacts[i]].u[0]);
    }
    const auto after = [&](int k, double turn, double following) { return acrossAfter(k, turn, following); };
    if (!follow(after, 0.0, kTurn, kNearly, rounding, work)) return false;
    for (int i = 0; i < m_turned.count; ++i) {
        Contact &contact = m_contacts[m_turned.contacts[i]];
        contact.speed = dot(contact.u, contact.d);
    }
    return true;
}

} // namespace phys
