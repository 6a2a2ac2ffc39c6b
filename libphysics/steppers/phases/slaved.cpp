// SPDX-License-Identifier: MIT
// A slip so rough that its pressure follows the motion: model.md 14.2.
#include "contact/held.h"
#include "phases/series.h"

#include <algorithm>
#include <cmath>

namespace phys {

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
    constexpr double kLeastRate = 8.0 * kOrder; // per unit
    const double now = apartWith(0, present) - apartWith(0, 0.0);
    const double later = apartAfter(0, present, 0.0) - apartAfter(0, 0.0, 0.0);
    return now > 0.0 && later > kLeastRate * now;
}

bool Series::buildSlaved(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                         Work &work) {
    constexpr int kMostPasses = 16;
    constexpr double kNearly = 0.1, kSame = 4e-15, kConverges = 0.25;
    take(moment, held, response, unit, 0);
    work.add(Work::kSeries);
    if (!findSlaved()) return false;
    m_equations.begin(m_unknowns);
    const double present = m_contacts[m_slaved].N[0], rounding = roundingOfPressure(m_contacts[m_slaved]);
    if (!relaxes(present)) return false;
    Jet pressure{};
    double changed = kNever;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const double before = pressure[0], changedBefore = changed;
        double most = 0.0;
        changed = 0.0;
        for (int k = 0; k < kOrder; ++k) {
            const double step = present / (k + 1), here = apartAfter(k, pressure[k], pressure[k + 1]);
            const double slope = (apartAfter(k, pressure[k] + step, pressure[k + 1]) - here) / step;
            const double change = -here / slope;
            pressure[k] += change;
            apartAfter(k, pressure[k], pressure[k + 1]);
            changed = std::max(changed, std::abs(change));
            most = std::max(most, std::abs(pressure[k]));
            const double inaccuracy = pass == 0 ? kNearly * present : 4.0 * std::abs(pressure[0] - before);
            if (k == 0 && std::abs(pressure[0] - present) > inaccuracy + rounding) return false;
        }
        work.add(3 * Work::kSeries * (1 + size()));
        if (!std::isfinite(changed + most)) {
            m_reach.length = 0.0; // the unit is much too long
            return true;
        }
        if (changed <= kSame * most || (pass > 1 && changed > kConverges * changedBefore)) break;
    }
    m_last = kOrder;
    finish();
    return true;
}

} // namespace phys
