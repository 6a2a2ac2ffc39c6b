// SPDX-License-Identifier: MIT
// Impacts: all contacts of one moment together, with friction: model.md 13.2.
#pragma once

#include "contact/contact.h"
#include "contact/work.h"

namespace phys {

/// Impacts that still approach after this many rounds end without a bounce.
inline constexpr uint32_t kMostImpactRounds = 64;

/// The result of the impacts of one moment.
struct Impacts {
    double lostNormal = 0.0; ///< J/kg taken by restitution
    double lostSlip = 0.0;   ///< J/kg taken by friction
    uint32_t rounds = 0;     ///< 0: no contact was approaching

    /// Normal speed of a contact before its first round (m/s); 0 if it took part in none.
    std::array<double, Contacts::kMost> approach{};
};

/// Applies impulses to approaching contacts, in rounds, until none approaches; restitution applies above restSpeed
/// only. Energy never rises, and neither the order of contacts nor a reflection changes any bit of the result.
Impacts resolveImpacts(const Contacts &contacts, double radius, Motion &motion, Work &work);

} // namespace phys
