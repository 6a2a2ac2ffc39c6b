// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/inputs.h"

namespace inspector {

/// Sets the tilt of the board in place of the sliders. Called by the stepping thread before a step.
class Pilot {
public:
    virtual ~Pilot() = default;
    /// The tilt for a step of dt, s, from this state on, rad; a function of both alone, so that a run can be repeated
    /// from any state.
    virtual Tilt tilt(const phys_state &state, double dt) const = 0;
    /// Simulated time between two calls, s: about as often as a player's hand moves. 0: before each step.
    virtual double period() const { return 0.02; }
};

} // namespace inspector
