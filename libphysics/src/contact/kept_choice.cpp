// SPDX-License-Identifier: MIT
// Lasting contacts that start from chosen impulses, model.md 13.5.
#include "contact/coulomb_newton.h"
#include "contact/lasting.h"

namespace phys {

/// Share of the chosen pressure that a solution may have once normals have turned within the substep.
constexpr double kMostAfterTurn = 1.2;

/// Lets those contacts roll that stick. Returns whether any of them didn't yet.
bool LastingContacts::updateRolling() {
    bool any = false;
    for (Lasting &contact : *this) {
        const bool begins =
            contact.isTop && !contact.rolls && contact.reaction > 0.0 && (contact.isGlued || contact.sticks());
        contact.rolls = contact.rolls || begins;
        any = any || begins;
    }
    return any;
}

/// Friction at its limit sticks here: rounding mustn't decide whether it does.
void LastingContacts::setPrestressed() {
    m_isPrestressed = true;
    for (Lasting &contact : *this) {
        contact.closes = contact.reaction > 0.0 && !contact.isSpent;
        if (contact.rolls) contact.load = contact.reaction;
    }
}

void LastingContacts::keep(const LastingContacts &chosen) {
    for (uint32_t i = 0; i < count(); ++i) {
        Lasting &contact = (*this)[i];
        contact.rolls = chosen[i].rolls;
        contact.isIdle = chosen[i].isIdle;
        contact.resisting = chosen[i].resisting;
        contact.load = chosen[i].load;
        contact.closes = chosen.m_isPrestressed && chosen[i].closes;
        contact.slow = std::min(contact.slow, chosen[i].slow);
    }
    m_isChosen = true;
    m_isPrestressed = chosen.m_isPrestressed;
    m_mostPressure = kMostAfterTurn;
}

/// Of several contacts chosen to stick, one whose gap is still to be closed slips only along the lines between them.
void LastingContacts::closeBySticking() {
    const auto isStuck = [](const Lasting &contact) { return contact.hasNoLimit() || contact.sticks(); };
    const bool isClosing =
        std::any_of(begin(), end(), [&](const Lasting &contact) { return isStuck(contact) && contact.slow < 0.0; });
    if (!isClosing || std::count_if(begin(), end(), isStuck) < 2) return;
    for (Lasting &contact : *this) contact.closes = isStuck(contact);
}

/// Newton's method from the chosen impulses leads to the solution near them, if any: sweeps may lead to another one.
bool LastingContacts::keepChoice(double rollingFriction, double negligible, Motion &motion) {
    const auto solveHere = [&] {
        return solvePressed(rollingFriction, negligible, motion) ||
               solveCoulomb({{begin(), end()}, m_radius, rollingFriction, negligible, *m_work}, motion);
    };
    closeBySticking();
    if (!solveHere()) return false;
    if (rollingFriction > 0.0 && updateRolling() && !solveHere()) return false;
    if (m_isPrestressed) return true;
    for (int i = 0; i < kMostShares; ++i) {
        const bool isRelieved = relieve(negligible, motion).relieved > negligible;
        if (i == 0 && (rollingFriction == 0.0 || !isRelieved)) break;
        if (keepLoads(negligible)) break;
        if (!solveHere()) return false;
    }
    return std::all_of(begin(), end(),
                       [](const Lasting &contact) { return !contact.closes || contact.rolls || contact.sticks(); });
}

} // namespace phys
