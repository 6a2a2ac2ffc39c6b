// SPDX-License-Identifier: MIT
// Which of several solutions of Coulomb's law lasting contacts take: model.md 13.5.
#pragma once

#include "contact/lasting.h"
#include "contact/modes.h"

namespace phys {

/// Where the law may have several solutions, gives lasting contacts the impulses that the modes of 14.1 have within a
/// substep h (s): solving starts from them, and stays there. lasting: of the same contacts, without impulses. Returns
/// whether no modes fit, so that the ball jams.
bool choose(const Contacts &contacts, const Moment &moment, double rollingFriction, double h, Work &work,
            LastingContacts &lasting);

/// Ends slips in a jam, as endSlips does. False if there are no such impulses.
bool endJam(const Contacts &contacts, double rollingFriction, double h, Work &work, Moment &moment);
/// The same as stopSlips does, for jams that endJam can't end.
bool stopJam(const Contacts &contacts, double rollingFriction, double h, Work &work, Moment &moment);

} // namespace phys
