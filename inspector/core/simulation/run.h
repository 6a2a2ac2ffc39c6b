// SPDX-License-Identifier: GPL-3.0-or-later
// What can be shown: the live ball, a recording, or the past that is kept. The thread that steps shows one at a time.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/pacer.h"
#include "core/simulation/snapshot.h"

namespace inspector {

// What a run of balls answers to the commands of a person, whichever it is.
class Run {
public:
    Run() = default;
    Run(const Run &) = delete;
    Run &operator=(const Run &) = delete;
    virtual ~Run() = default;

    virtual const Engine &engine() const = 0;  // the ball that is shown
    virtual uint32_t stepperPlace() const = 0; // of the last step's stepper in the registry, or kNoStepper
    virtual void addTo(Snapshot &snapshot) const = 0;

    virtual void prepareToGoOn() {}               // it is about to go on by itself
    virtual void step(Clock::time_point due) = 0; // by its own, and shows it
    virtual void stepOnce() = 0;                  // because it was asked for
    virtual void restart() = 0;
};

} // namespace inspector
