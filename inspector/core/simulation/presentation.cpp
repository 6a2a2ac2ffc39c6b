// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/presentation.h"

#include "core/recording/same_bits.h"

#include <algorithm>
#include <utility>

namespace inspector {

Presentation::Presentation(Simulation &owner, SampleRing &samples, EventLog &events, LatestValue<Snapshot> &snapshots)
    : m_owner(owner)
    , m_samples(samples)
    , m_events(events)
    , m_snapshots(snapshots) {}

// ---- pace ----

void Presentation::setRunning(bool isRunning) {
    if (m_isRunning == isRunning) return;
    m_isRunning = isRunning;
    startPacing();
    emit m_owner.runningChanged(m_isRunning);
}

void Presentation::setSpeed(double speed) {
    m_speed = speed;
    startPacing();
}

void Presentation::startPacing() {
    const Clock::time_point now = Clock::now();
    m_pacedDt = m_run->engine().dt();
    m_pacer.start(now, m_pacedDt, m_speed);
    m_meter.start(now);
}

void Presentation::followDt() {
    if (m_run->engine().dt() != m_pacedDt) startPacing();
}

// ---- ghost ----

void Presentation::compare(uint64_t number, const GhostSetup &setup, const QByteArray &leaderId) {
    m_ghost.reset();
    m_ghostNumber = number;
    // A replay may have moved to another scene; then the comparison is requested again.
    if (setup.scene == m_run->engine().scene()) m_ghost.emplace(m_run->engine(), setup, leaderId);
    m_isGhostAsMet = true;
    ++m_meetings;
}

void Presentation::setGhostInputs(uint64_t number, const std::optional<Inputs> &own) {
    if (!m_ghost) return;
    m_ghostNumber = number;
    m_isGhostAsMet = false;
    m_ghost->setOwnInputs(own);
}

void Presentation::meetGhost() {
    if (m_ghost && m_ghost->scene() != m_run->engine().scene()) m_ghost.reset(); // its stepper is of the other scene
    if (m_ghost) m_ghost->meet(m_run->engine());
    m_isGhostAsMet = true;
    ++m_meetings;
}

/// Steps the ghost, after everything else: the ball never depends on it.
void Presentation::leadGhost() {
    QString line;
    if (!m_ghost || m_ghost->follow(m_run->engine(), &line)) return;
    emit m_owner.comparisonRefused(m_ghostNumber, line);
}

bool Presentation::ghostBeginsAt(const phys_state &ball, bool isLive) const {
    return m_ghost && (!isLive || (m_isGhostAsMet && isSameBits(ball, m_ghost->met())));
}

std::optional<GhostEngine> Presentation::ghostOf(const Engine &ball, const QByteArray &leaderId) const {
    if (!m_ghost || m_ghost->scene() != ball.scene()) return std::nullopt;
    return std::optional<GhostEngine>(std::in_place, ball, m_ghost->setup(), leaderId);
}

void Presentation::addGhost(const GhostEngine &ghost, Sample &sample) const {
    ghost.addTo(sample);
    sample.ghost = m_ghostNumber;
}

// ---- samples and events ----

void Presentation::beginRun() {
    ++m_runCount;
    meetGhost();
    m_pacer.forgetLostTime();
    startPacing();
    clear();
    emit m_owner.runBegan();
}

void Presentation::countStep() { m_meter.count(Clock::now(), m_run->engine().dt()); }

Sample Presentation::sample() const {
    Sample sample = m_run->engine().sample();
    const bool isOfMaze = std::ranges::count(m_trackScenes, m_run->engine().scene()) > 0;
    if (m_track && isOfMaze) m_track->addTo(sample);
    return sample;
}

void Presentation::noteStep(double stepTime) {
    countStep();
    leadGhost();
    Sample sample = this->sample();
    if (m_ghost) addGhost(*m_ghost, sample);
    sample[Channel::StepTime] = stepTime;
    m_samples.append(sample);
    noteEvents();
}

void Presentation::noteEvents() {
    const Engine &engine = m_run->engine();
    m_events.note(engine, m_run->stepperPlace());
}

void Presentation::hold() {
    m_samples.hold();
    m_events.hold();
    m_isHeld = true;
}

void Presentation::release() {
    if (!std::exchange(m_isHeld, false)) return;
    m_samples.release();
    m_events.release();
}

void Presentation::clear() {
    m_samples.clear();
    m_events.clear();
}

void Presentation::publish(Clock::time_point due) {
    const Engine &engine = m_run->engine();
    Snapshot snapshot;
    snapshot.previous = engine.previous();
    snapshot.current = engine.state();
    snapshot.due = due;
    snapshot.interval = m_isRunning ? m_pacer.interval() : Clock::duration::zero();
    snapshot.inputs = engine.inputs();
    snapshot.report = engine.report();
    snapshot.report.events = nullptr;
    snapshot.report.event_capacity = 0;
    snapshot.dt = engine.dt();
    snapshot.number = ++m_published;
    snapshot.run = m_runCount;
    snapshot.running = m_isRunning;
    if (m_ghost && m_ghost->isThere())
        snapshot.ghost = {m_ghostNumber,  m_ghost->previous(), m_ghost->state(),
                          m_ghost->met(), m_meetings,          m_ghost->deviation()};
    snapshot.statistics = {m_meter.stepsPerSecond(), m_speed, m_meter.speed(), m_pacer.lostTime()};
    m_run->addTo(snapshot);
    m_snapshots.publish(snapshot);
}

} // namespace inspector
