// SPDX-License-Identifier: MIT
// Helpers of the recording suites: what they do to an engine and how they compare.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/recorder.h"
#include "core/simulation/snapshot.h"

#include <cstdint>

namespace inspector {

inline void stepRecorded(Engine &engine, Recorder &recorder, int steps) {
    for (int i = 0; i < steps; ++i) {
        QString error;
        if (!engine.step(&error)) qFatal("%s", qPrintable(error));
        recorder.note(engine);
    }
}

inline uint64_t hashOf(const Snapshot &snapshot) { return phys_state_hash(&snapshot.current); }

} // namespace inspector
