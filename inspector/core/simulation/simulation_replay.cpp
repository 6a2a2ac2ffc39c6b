// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown in the place of the live ball: a recording, or the past that is kept; and how the ball goes on from
// there.
#include "core/simulation/simulation_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace inspector {

namespace {

// Steps before the place sought in a replay that plots and trails get to see.
constexpr uint64_t kStepsBefore = 10000; // the 10 s of a plot at 1 ms
// Steps of an earlier run that plots and trails get to see: a moment's work.
constexpr uint64_t kStepsOfARun = 100000;
// A replay is checked ahead in pieces, between which there is time for steps and commands.
constexpr std::chrono::milliseconds kCheckSlice{1};
constexpr std::chrono::milliseconds kShowSlice{20};
constexpr int kStepsPerLook = 32; // at the clock

} // namespace

ReplayPlace Simulation::Worker::replayPlace() const {
    return {replay,         player->position(), player->end(), player->checked(), player->isChecked(),
            differenceAt(), player->stretch(),  seeks};
}

// Where the first difference shows: after that step, or at the end if the step fails.
std::optional<uint64_t> Simulation::Worker::differenceAt() const {
    if (!player->difference()) return std::nullopt;
    return std::min(player->difference()->number, player->end());
}

// A ball that has left the maze goes on as recorded.
void Simulation::Worker::replayStep(Clock::time_point due) {
    if (player->enterRun()) beginRun();
    if (player->next()) {
        if (shown().dt() != pacedDt) startPacing();
        noteStep();
    }
    const bool isDifferent = differenceAt() == player->position();
    if (isDifferent || player->position() == player->end()) setRunning(false);
    publish(due);
    if (isDifferent) emit owner.differenceReached(replay);
}

// While no step is due.
void Simulation::Worker::checkAhead() {
    const bool wasSame = !player->difference();
    Clock::time_point end = Clock::now() + kCheckSlice;
    if (running) end = std::min(end, pacer.deadline());
    do {
        for (int i = 0; i < kStepsPerLook; ++i) player->check();
    } while (!player->isChecked() && Clock::now() < end);
    if (!running) publish(Clock::now());
    if (wasSame && player->difference()) emit owner.differenceFound(replay, *player->difference());
}

// ---- the past of the live ball ----

HistoryPlace Simulation::Worker::historyPlace() const {
    return {history.begin(), liveRun, history.end(), past ? pastPlace() : history.end()};
}

// To the end of the run that is shown.
void Simulation::Worker::pastStep(Clock::time_point due) {
    const uint64_t end = past->endOfRun(pastPlace());
    if (pastPlace() < end && player->next() && shown().dt() != pacedDt) startPacing();
    meter.count(Clock::now(), shown().dt());
    if (pastPlace() == end) setRunning(false);
    publish(due);
}

// Samples and events of the run that is gone to.
void Simulation::Worker::showPastRun() {
    const uint64_t wanted = past->beginOfRun(pastPlace());
    if (wanted != std::max(shownRun, past->begin)) refillSamples(wanted);
}

// Made again from its beginning to its end; the player is where it was afterwards.
void Simulation::Worker::refillSamples(uint64_t first) {
    const uint64_t place = player->position();
    const uint64_t end = std::min(past->endOfRun(first + 1), first + kStepsOfARun) - past->begin;
    owner.m_samples.hold();
    owner.m_events.hold();
    owner.m_samples.clear();
    owner.m_events.clear();
    player->seek(first - past->begin);
    while (player->position() < end && player->next()) {
        if (shown().previous().flags & PHYS_OUT) continue;
        owner.m_samples.append(shown().sample());
        noteEvents();
    }
    player->seek(place);
    owner.m_samples.release();
    owner.m_events.release();
    shownRun = first;
}

void Simulation::Worker::leavePast() {
    if (!past) return;
    setRunning(false);
    const bool isLiveRun = std::max(shownRun, past->begin) == std::max(liveRun, past->begin);
    if (!isLiveRun && liveRun < history.end()) refillSamples(std::max(liveRun, past->begin));
    if (!isLiveRun && liveRun == history.end()) {
        owner.m_samples.clear();
        owner.m_events.clear();
        shownRun = liveRun;
    }
    past.reset();
    player.reset();
    sought.reset();
    startPacing();
}

// As the samples tell it.
std::optional<Ghost> Simulation::Worker::pastGhost() const {
    Sample sample;
    const double time = shown().state().time;
    const uint64_t number = owner.m_samples.find(time);
    if (!owner.m_samples.read(number, sample) || std::isnan(sample[Channel::GhostX])) return std::nullopt;
    Ghost ghost;
    ghost.current = shown().state();
    ghost.current.position = {sample[Channel::GhostX], sample[Channel::GhostY], sample[Channel::GhostZ]};
    ghost.previous = ghost.current;
    ghost.deviation = {sample[Channel::Distance], sample[Channel::SpeedDifference], sample[Channel::EnergyDifference]};
    return ghost;
}

// Once all before it is checked; commands are obeyed between the pieces of that.
void Simulation::Worker::goToSought() {
    if (sought->position > player->checked() && !player->isChecked()) return checkAhead();
    if (past) {
        player->seek(sought->position);
        showPastRun();
        startPacing();
    } else if (!showUpTo(sought->position)) {
        return;
    }
    seeks = std::exchange(sought, std::nullopt)->number;
    publish(Clock::now());
}

// Plots and trails then show what they do when it is played: what was before it in its run is made again, too. A piece
// of that, because a fine ghost makes it long; true if it is done, or needs no more pieces.
bool Simulation::Worker::showUpTo(uint64_t position) {
    const uint64_t end = std::min(position, player->end());
    const uint64_t start = player->recording().beginOfRun(end);
    const uint64_t begin = std::max(start, end - std::min(end, kStepsBefore));
    const bool goesOn = player->position() > start && player->position() >= begin && player->position() <= end;
    holdSamples();
    if (!goesOn) {
        player->seek(begin);
        player->enterRun();
        beginRun();
    }
    const Clock::time_point until = Clock::now() + kShowSlice;
    while (player->position() < end && player->next()) {
        noteStep();
        if (player->position() < end && Clock::now() >= until) return false;
    }
    startPacing();
    releaseSamples();
    return true;
}

// Readers see what they are of before and after, and nothing between.
void Simulation::Worker::holdSamples() {
    owner.m_samples.hold();
    owner.m_events.hold();
    areSamplesHeld = true;
}

void Simulation::Worker::releaseSamples() {
    if (!std::exchange(areSamplesHeld, false)) return;
    owner.m_samples.release();
    owner.m_events.release();
}

// The engine gets all that the replay's last step had: its next one is what that one's would be. Inputs that were given
// after the command, but came before it, stay. number: of what counts as given by the command.
void Simulation::Worker::goOnLive(uint64_t number) {
    const PlayableRecording &recording = player->recording();
    const Engine &from = player->engine();
    engine.setScene(from.scene(), recording.stepper(player->stretch()));
    engine.setDt(from.dt());
    obey({from.inputs(), number});
    engine.setState(from.state(), from.sums());
    if (past) {
        owner.m_samples.truncate(owner.m_samples.find(std::nextafter(engine.state().time, HUGE_VAL)));
        owner.m_events.forgetAfter(engine.state().time);
    }
    past.reset();
    player.reset();
    liveRun = shownRun = history.end();
    if (companion && companion->scene() != engine.scene()) companion.reset();
    if (companion) companion->meet(engine);
    sought.reset();
    leftAt = engine.state().flags & PHYS_OUT ? engine.state().time : std::numeric_limits<double>::infinity();
    startPacing();
    emit owner.runBegan();
}

} // namespace inspector
