// SPDX-License-Identifier: GPL-3.0-or-later
// The live ball, and what both tell: samples, events, snapshots.
#include "core/simulation/simulation_worker.h"

#include <chrono>
#include <cmath>

namespace inspector {

namespace {

// How long the ball goes on falling after it left the maze, s of simulated time.
constexpr double kFallTime = 0.4;
// Of a step: 30 steps of 0.01 s are 0.3 s.
constexpr double kRounding = 1e-6;

} // namespace

void Simulation::Worker::setOrigin(const Origin &origin) {
    stepper = stepperIndex(origin.registry, origin.stepper.id);
    history.setOrigin(origin);
    if (recorder) recorder->setOrigin(origin);
}

void Simulation::Worker::obey(const GivenInputs &given) {
    if (given.number < obeyed) return;
    obeyed = given.number;
    engine.setInputs(given.inputs);
}

// Rates and deadlines count from now; what was lost in this run stays counted.
void Simulation::Worker::startPacing() {
    const Clock::time_point now = Clock::now();
    pacedDt = shown().dt();
    pacer.start(now, pacedDt, speed);
    meter.start(now);
}

void Simulation::Worker::setRunning(bool isRunning) {
    if (running == isRunning) return;
    running = isRunning;
    startPacing();
    emit owner.runningChanged(running);
}

// The state was set from outside: a new history begins.
void Simulation::Worker::beginRun() {
    ++run;
    impacts = 0;
    leftAt = std::numeric_limits<double>::infinity();
    if (shown().state().flags & PHYS_OUT) leftAt = shown().state().time;
    if (companion && companion->scene() != shown().scene()) companion.reset(); // its stepper is of the other
    if (companion) companion->meet(shown());
    if (!player) liveRun = shownRun = history.end();
    pacer.forgetLostTime();
    startPacing();
    owner.m_samples.clear();
    owner.m_events.clear();
    emit owner.runBegan();
}

void Simulation::Worker::step(Clock::time_point due) {
    if (past) return pastStep(due);
    if (player) return replayStep(due);
    QString line;
    const Clock::time_point begin = Clock::now();
    const bool hasStepped = engine.step(&line);
    stepTime = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    if (hasStepped) history.note(engine);
    record(line);
    if (!hasStepped) {
        setRunning(false);
        publish(due);
        emit owner.failed(line);
        return;
    }
    noteStep();
    noteLeaving();
    if (engine.state().time >= pauseAt - kRounding * engine.dt()) setRunning(false);
    publish(due);
}

void Simulation::Worker::noteStep() {
    meter.count(Clock::now(), shown().dt());
    if (shown().previous().flags & PHYS_OUT) return; // out of the maze it only falls
    leadCompanion();
    Sample sample = shown().sample();
    if (companion) companion->addTo(sample);
    if (!player) sample[Channel::StepTime] = stepTime;
    owner.m_samples.append(sample);
    noteEvents();
}

// failure: the library's line if the step failed, else empty.
void Simulation::Worker::record(const QString &failure) {
    if (!recorder) return;
    if (failure.isEmpty())
        recorder->note(engine);
    else
        recorder->noteFailure(engine, failure);
    dropBadRecorder();
}

void Simulation::Worker::dropBadRecorder() {
    if (!recorder || recorder->isGood()) return;
    emit owner.recordingFailed(recorder->error());
    recorder.reset();
}

void Simulation::Worker::endRecording() {
    if (!recorder) return;
    recorder->close();
    dropBadRecorder();
    recorder.reset();
}

// Last of all that a step does to the state: nothing of the ball depends on it.
void Simulation::Worker::leadCompanion() {
    QString line;
    if (!companion) return;
    if (player) companion->setLeaderStepper(player->recording().stretch(player->stretch()).conditions.stepper.id);
    if (!companion->follow(shown(), &line)) emit owner.comparisonRefused(companionNumber, line);
}

void Simulation::Worker::noteEvents() {
    owner.m_events.note(shown(), player ? player->recording().stepperPlace(player->stretch()) : stepper);
    for (const phys_event &event : shown().events())
        if (event.kind == PHYS_EVENT_IMPACT) ++impacts;
}

void Simulation::Worker::noteLeaving() {
    const phys_state &state = engine.state();
    if (!(state.flags & PHYS_OUT)) return;
    if (std::isinf(leftAt)) {
        leftAt = state.time;
        emit owner.leftMaze(leftAt);
    }
    if (state.time >= leftAt + kFallTime) setRunning(false);
}

void Simulation::Worker::publish(Clock::time_point due) {
    const Engine &now = shown();
    Snapshot snapshot;
    snapshot.previous = now.previous();
    snapshot.current = now.state();
    snapshot.due = due;
    snapshot.interval = running ? pacer.interval() : Clock::duration::zero();
    snapshot.inputs = now.inputs();
    snapshot.report = now.report();
    snapshot.report.events = nullptr;
    snapshot.report.event_capacity = 0;
    snapshot.dt = now.dt();
    snapshot.number = ++published;
    snapshot.run = run;
    snapshot.running = running;
    if (past)
        snapshot.ghost = pastGhost();
    else if (companion && companion->isThere())
        snapshot.ghost = {companion->previous(), companion->state(), companion->metAt(), companion->deviation()};
    snapshot.statistics = {meter.stepsPerSecond(), speed, meter.speed(), pacer.lostTime(), impacts};
    if (player) snapshot.replay = replayPlace();
    snapshot.history = historyPlace();
    owner.m_snapshots.publish(snapshot);
}

} // namespace inspector
