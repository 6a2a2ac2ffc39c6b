// SPDX-License-Identifier: GPL-3.0-or-later
// State of the stepping thread: the live ball, and what may be shown in its place.
#pragma once

#include "core/simulation/past_run.h"

namespace inspector {

struct Simulation::Worker {
    Presentation presentation;
    LiveRun live;
    std::unique_ptr<ReplayRun> replay{}; ///< a recording or the past; null while the live ball is shown
    PastRun *past = nullptr;             ///< the same object as `replay` if that is the past; else null

    Worker(Simulation &owner, const Scene &scene, const Stepper &stepper);

    Run &shown() { return replay ? static_cast<Run &>(*replay) : live; }
    bool isSeeking() const { return replay && replay->isSeeking(); }
    bool isChecking() const { return replay && !replay->isChecked(); }
    void startReplay(const std::shared_ptr<const PlayableRecording> &recording, uint64_t number);
    void lookBack(const Past &kept, uint64_t number);
    void leavePast();
    void showLive(); ///< paused
    void handOver();
    /// The live ball continues from what is shown. number: of the inputs given with the command.
    void goOnLive(uint64_t number);
    /// Continues this run where it ended, with its samples; false, and nothing changes, if steps were made since.
    bool resume(const HistoryPlace &run);
};

} // namespace inspector
