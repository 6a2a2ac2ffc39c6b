// SPDX-License-Identifier: GPL-3.0-or-later
// Switches from one run shown to another.
#include "core/simulation/simulation_worker.h"

#include <utility>

namespace inspector {

Simulation::Worker::Worker(Simulation &owner, const Scene &scene, const Stepper &stepper)
    : presentation(owner, owner.m_samples, owner.m_events, owner.m_snapshots)
    , live(presentation, scene, stepper) {
    presentation.show(live);
}

void Simulation::Worker::startReplay(const std::shared_ptr<const PlayableRecording> &recording, uint64_t number) {
    presentation.setRunning(false);
    past = nullptr;
    replay = std::make_unique<ReplayRun>(presentation, live, Player(recording), number);
    presentation.show(*replay);
    presentation.beginRun();
}

void Simulation::Worker::lookBack(const Past &kept, uint64_t number) {
    presentation.setRunning(false);
    auto run = std::make_unique<PastRun>(presentation, live, kept, past ? past->shownRun() : live.beginPlace(), number);
    past = run.get();
    replay = std::move(run);
    presentation.show(*replay);
}

void Simulation::Worker::leavePast() {
    if (!past) return;
    presentation.setRunning(false);
    past->showLiveRun();
    showLive();
    presentation.startPacing();
}

void Simulation::Worker::showLive() {
    presentation.setRunning(false);
    presentation.show(live);
    past = nullptr;
    replay.reset();
}

/// Keeps running or stays paused.
void Simulation::Worker::goOnLive(uint64_t number) {
    live.goOnFrom(replay->engine(), replay->stepper(), number);
    replay->forgetFuture();
    handOver();
}

bool Simulation::Worker::resume(const HistoryPlace &run) {
    const History &history = live.history();
    const bool isLast = run.end > run.run && live.beginPlace() == run.end + 1 && history.end() == run.end + 1;
    if (replay || !isLast || history.begin() > run.run) return false;
    const std::optional<Past> kept = history.past(run.run, run.end, nullptr);
    if (!kept) return false;
    lookBack(*kept, 0);
    past->goTo(kept->end() - kept->begin);
    live.resume(past->engine(), run.run);
    handOver();
    return true;
}

/// The live ball is where the one shown is, and is shown from now on.
void Simulation::Worker::handOver() {
    presentation.show(live);
    past = nullptr;
    replay.reset();
    presentation.meetGhost();
    presentation.startPacing();
    emit presentation.owner().runBegan();
}

} // namespace inspector
