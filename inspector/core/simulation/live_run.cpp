// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/live_run.h"

#include "core/simulation/departure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace inspector {

namespace {

/// Tolerance as a share of a step: 30 steps of 0.01 s are 0.3 s.
constexpr double kPauseRounding = 1e-6;

double timeOfLeaving(const phys_state &state) {
    return state.flags & PHYS_OUT ? state.time : std::numeric_limits<double>::infinity();
}

} // namespace

LiveRun::LiveRun(Presentation &presentation, const Scene &scene, const Stepper &stepper)
    : m_presentation(presentation)
    , m_engine(scene, stepper) {}

void LiveRun::addTo(Snapshot &snapshot) const {
    snapshot.history = {m_history.begin(), beginPlace(), m_history.end(), m_history.end()};
}

void LiveRun::step(Clock::time_point due) {
    QString line;
    const Clock::time_point begin = Clock::now();
    const bool hasStepped = m_engine.step(&line);
    const double stepTime = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    if (hasStepped) m_history.note(m_engine);
    record(line);
    if (!hasStepped) {
        m_presentation.setRunning(false);
        m_presentation.publish(due);
        emit m_presentation.owner().failed(line);
        return;
    }
    m_presentation.noteStep(stepTime);
    noteLeaving();
    if (m_engine.state().time >= m_pauseAt - kPauseRounding * m_engine.dt()) m_presentation.setRunning(false);
    m_presentation.publish(due);
}

void LiveRun::noteLeaving() {
    const phys_state &state = m_engine.state();
    const BoardSide side = boardSide(m_engine.scene().get(), state.position);
    if (side == BoardSide::Within) return;
    if (std::isinf(m_leftAt)) {
        m_leftAt = state.time;
        emit m_presentation.owner().leftMaze({m_leftAt, side});
    }
    if (state.time >= m_leftAt + kFallTime) m_presentation.setRunning(false);
}

void LiveRun::restart() {
    m_engine.restart();
    begin();
}

// ---- inputs of the next steps ----

void LiveRun::obey(const GivenInputs &given) {
    if (given.number < m_obeyed) return;
    m_obeyed = given.number;
    m_engine.setInputs(given.inputs);
}

void LiveRun::setScene(const Scene &scene, const Stepper &stepper, const Origin &origin) {
    m_engine.setScene(scene, stepper);
    setOrigin(origin);
    begin();
}

void LiveRun::setStepper(const Stepper &stepper, const Origin &origin) {
    setOrigin(origin);
    m_engine.setStepper(stepper);
}

void LiveRun::setState(const phys_state &state) {
    m_engine.setState(state);
    begin();
}

void LiveRun::setOrigin(const Origin &origin) {
    m_stepperPlace = stepperIndex(origin.registry, origin.stepper.id);
    m_history.setOrigin(origin);
    if (m_recorder) m_recorder->setOrigin(origin);
}

void LiveRun::begin() {
    m_leftAt = timeOfLeaving(m_engine.state());
    m_history.beginRun();
    m_presentation.beginRun();
}

void LiveRun::goOnFrom(const Engine &from, const Stepper &stepper, uint64_t number) {
    m_engine.setScene(from.scene(), stepper);
    m_engine.setDt(from.dt());
    obey({from.inputs(), number});
    m_engine.setState(from.state(), from.sums());
    m_history.beginRun();
    const auto left = departure(m_presentation.samples(), from.scene().get(), from.state().time);
    m_leftAt = left ? left->time : timeOfLeaving(m_engine.state());
    if (left) emit m_presentation.owner().leftMaze(*left);
}

void LiveRun::resume(const Engine &end, uint64_t begin) {
    m_engine.setState(end.state(), end.sums());
    m_history.resumeRun(begin);
    const auto left = departure(m_presentation.samples(), end.scene().get(), end.state().time);
    m_leftAt = left ? left->time : timeOfLeaving(m_engine.state());
}

// ---- recording ----

void LiveRun::startRecording(const QString &file, const Origin &origin) {
    endRecording();
    m_recorder.emplace(file);
    m_recorder->setOrigin(origin);
    dropBadRecorder();
}

void LiveRun::endRecording() {
    if (!m_recorder) return;
    m_recorder->close();
    dropBadRecorder();
    m_recorder.reset();
}

void LiveRun::flushRecording() {
    if (!m_recorder) return;
    m_recorder->flush();
    dropBadRecorder();
}

/// failure: the library's message if the step failed, else empty.
void LiveRun::record(const QString &failure) {
    if (!m_recorder) return;
    if (failure.isEmpty())
        m_recorder->note(m_engine);
    else
        m_recorder->noteFailure(m_engine, failure);
    dropBadRecorder();
}

void LiveRun::dropBadRecorder() {
    if (!m_recorder || m_recorder->isGood()) return;
    emit m_presentation.owner().recordingFailed(m_recorder->error());
    m_recorder.reset();
}

} // namespace inspector
