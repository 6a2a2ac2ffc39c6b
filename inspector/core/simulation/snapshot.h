// SPDX-License-Identifier: GPL-3.0-or-later
// What the stepping thread shows to the drawing one.
#pragma once

#include "core/engine/ghost_engine.h"
#include "core/engine/pacer.h"
#include "core/setup/inputs.h"

#include <optional>

namespace inspector {

struct Statistics {
    double stepsPerSecond = 0.0; ///< over the last half second
    double speedAsked = 1.0;     ///< simulated seconds per second
    double speedReached = 0.0;   ///< over the last half second; 0 while paused
    double lostTime = 0.0;       ///< dropped since the start of the run, s of wall-clock time
};

/// The ghost's states, like the ball's.
struct Ghost {
    uint64_t number = 0;   ///< as in Simulation::compareWith()
    phys_state previous{}; ///< at the same moments as the ball's
    phys_state current{};
    phys_state met{};      ///< common state where it last started from the ball's; its time is NaN if it isn't known
    uint64_t meetings = 0; ///< counts the starts from the ball's state
    Deviation deviation;
};

/// Where a replay is.
struct ReplayPlace {
    uint64_t number = 0;                ///< of the replay, from 1; 0: the live ball is shown
    uint64_t position = 0;              ///< steps made
    uint64_t end = 0;                   ///< the last position
    uint64_t checked = 0;               ///< steps whose hashes were compared
    bool isChecked = false;             ///< all of them
    std::optional<uint64_t> difference; ///< position of the first one
    size_t segment = 0;                 ///< of the recording, of the last step
    uint64_t seeks = 0;                 ///< number of the last one done
};

/// The extent of the history; places number the states since the program began, as in Past.
struct HistoryPlace {
    uint64_t begin = 0; ///< the oldest one kept
    uint64_t run = 0;   ///< where the live run began
    uint64_t end = 0;   ///< the present
    uint64_t place = 0; ///< the place shown
};

struct Snapshot {
    phys_state previous{}; ///< one step earlier; the same as `current` right after a restart
    phys_state current{};
    Clock::time_point due{};    ///< when `current` was due
    Clock::duration interval{}; ///< to the next step; 0 while paused
    Inputs inputs{};            ///< of the last step
    phys_report report{};       ///< of the last step; its events are not here
    double dt = 0.0;            ///< s
    uint64_t number = 0;        ///< of the snapshot
    uint64_t run = 0;           ///< counts restarts, levels and states set
    bool running = false;
    std::optional<Ghost> ghost; ///< while there is a comparison and it isn't refused
    Statistics statistics;
    ReplayPlace replay;
    HistoryPlace history;
};

/// The ball at `now`, interpolated between the two states: drawing runs one step behind and never extrapolates.
phys_state interpolated(const Snapshot &snapshot, Clock::time_point now);
/// The ghost at that moment; nothing if there is none.
std::optional<phys_state> interpolatedGhost(const Snapshot &snapshot, Clock::time_point now);

} // namespace inspector
