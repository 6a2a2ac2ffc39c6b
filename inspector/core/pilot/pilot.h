// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/inputs.h"

namespace inspector {

// Someone who tilts the board in place of the sliders. Asked by the thread that steps, before a step.
class Pilot {
public:
    virtual ~Pilot() = default;
    // The tilt from this state on, rad; a function of the state alone, so that a run can be repeated from anywhere.
    virtual Tilt tilt(const phys_state &state) const = 0;
};

} // namespace inspector
