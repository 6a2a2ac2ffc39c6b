// SPDX-License-Identifier: MIT
// Impacts: all contacts of one moment together, with friction: model.md 13.2.
#pragma once

#include "contact/contact.h"
#include "contact/work.h"

namespace phys {

/// Impacts that still approach after so many rounds end without a bounce.
inline constexpr uint32_t kMostImpactRounds = 64;

/// What the impacts of one moment did.
struct Impacts {
    double lostNormal = 0.0; ///< J/kg taken by restitution
    double lostSlip = 0.0;   ///< J/kg taken by friction
    uint32_t rounds = 0;     ///< 0: nothing was approaching

    /// A contact's normal speed before the first round that it took part in (m/s); 0 if it took part in none.
    std::array<double, Contacts::kMost> approach{};
};

/// Gives contacts that approach their impulses, in rounds, until none does: restitution holds above restSpeed only.
/// Energy never rises; neither the order of contacts nor a mirror changes the result by a bit.
Impacts resolveImpacts(const Contacts &contacts, double radius, Motion &motion, Work &work);

} // namespace phys
