// SPDX-License-Identifier: GPL-3.0-or-later
// Something that can be shown: the live ball, a recording, or the history. The stepping thread shows one at a time.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/pacer.h"
#include "core/simulation/snapshot.h"

namespace inspector {

/// The interface through which a run of any kind reacts to the user's commands.
class Run {
public:
    Run() = default;
    Run(const Run &) = delete;
    Run &operator=(const Run &) = delete;
    virtual ~Run() = default;

    virtual const Engine &engine() const = 0;  ///< of the ball shown
    virtual uint32_t stepperPlace() const = 0; ///< index of the last step's stepper in the registry, or kNoStepper
    virtual void addTo(Snapshot &snapshot) const = 0;

    virtual void prepareToGoOn() {}               ///< called before it runs
    virtual void step(Clock::time_point due) = 0; ///< makes the next due step and shows it
    virtual void stepOnce() = 0;                  ///< makes one step on request
    virtual void restart() = 0;
};

} // namespace inspector
