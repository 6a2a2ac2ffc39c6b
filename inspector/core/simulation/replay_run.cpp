// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/replay_run.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace inspector {

namespace {

/// Steps before the target of a seek that are repeated for plots and trails.
constexpr uint64_t kStepsBefore = 10000; ///< the 10 s of a plot at 1 ms
/// A replay is checked ahead in slices, between which steps and commands are handled.
constexpr std::chrono::milliseconds kCheckSlice{1};
constexpr int kStepsPerLook = 32; ///< steps between two looks at the clock
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

} // namespace

ReplayRun::ReplayRun(Presentation &presentation, const LiveRun &live, Player player, uint64_t number)
    : m_presentation(presentation)
    , m_live(live)
    , m_player(std::move(player))
    , m_number(number) {}

void ReplayRun::addTo(Snapshot &snapshot) const {
    m_live.addTo(snapshot);
    snapshot.replay = {m_number,       m_player.position(), m_player.end(), m_player.checked(), m_player.isChecked(),
                       differenceAt(), m_player.segment(),  m_seeks};
}

/// The position of the first difference: after that step, or at the end if the step fails.
std::optional<uint64_t> ReplayRun::differenceAt() const {
    if (!m_player.difference()) return std::nullopt;
    return std::min(m_player.difference()->number, m_player.end());
}

void ReplayRun::prepareToGoOn() {
    if (!m_sought && m_player.position() == m_player.end()) restart();
}

/// Outside of the maze the ball continues as recorded.
void ReplayRun::step(Clock::time_point due) {
    if (m_player.enterRun()) m_presentation.beginRun();
    if (m_player.next()) {
        m_presentation.followDt();
        noteStep();
    }
    tellDifference();
    const bool isDifferent = differenceAt() == m_player.position();
    if (isDifferent || m_player.position() == m_player.end()) m_presentation.setRunning(false);
    m_presentation.publish(due);
    if (isDifferent) emit m_presentation.owner().differenceReached(m_number);
}

void ReplayRun::noteStep() {
    if (GhostEngine *ghost = m_presentation.ghost()) ghost->setLeaderStepper(leaderId());
    m_presentation.noteStep(kNotMeasured);
}

void ReplayRun::stepOnce() {
    if (m_sought)
        ++m_sought->position;
    else
        step(Clock::now());
}

void ReplayRun::restart() { m_sought = {0, m_seeks}; }

// ---- seeking ----

void ReplayRun::seek(uint64_t position, uint64_t number) { m_sought = {position, number}; }

void ReplayRun::stepBack() {
    const Seek now = m_sought.value_or(Seek{m_player.position(), m_seeks});
    m_sought = {now.position - std::min<uint64_t>(now.position, 1), now.number};
}

void ReplayRun::goToSought() {
    if (m_sought->position > m_player.checked() && !isChecked()) return checkAhead();
    if (!showAt(m_sought->position)) return;
    m_presentation.startPacing();
    m_seeks = std::exchange(m_sought, std::nullopt)->number;
    m_presentation.publish(Clock::now());
}

void ReplayRun::goTo(uint64_t position) {
    if (m_player.position() == position) return;
    m_presentation.endComparison(); // it would have to repeat too much
    while (!showAt(position)) {
    }
}

/// Plots and trails must look as if the recording had been played, so the run before the position is repeated as well.
/// This is done in slices, because a fine ghost makes it slow.
bool ReplayRun::showAt(uint64_t position) {
    const uint64_t end = std::min(position, m_player.end());
    const uint64_t start = m_player.recording().runAt(end).begin;
    const uint64_t begin = std::max(start, end - std::min(end, kStepsBefore));
    const bool goesOn = m_player.position() > start && m_player.position() >= begin && m_player.position() <= end;
    m_presentation.hold();
    if (!goesOn) {
        m_player.seek(begin);
        m_player.enterRun();
        m_presentation.beginRun();
    }
    const Clock::time_point until = Clock::now() + kShowSlice;
    while (m_player.position() < end && m_player.next()) {
        noteStep();
        if (m_player.position() < end && Clock::now() >= until) return false;
    }
    m_presentation.release();
    return true;
}

// ---- checking ----

void ReplayRun::checkAhead() {
    Clock::time_point end = Clock::now() + kCheckSlice;
    if (m_presentation.isRunning()) end = std::min(end, m_presentation.deadline());
    do {
        for (int i = 0; i < kStepsPerLook; ++i) m_player.check();
    } while (!isChecked() && Clock::now() < end);
    if (!m_presentation.isRunning()) m_presentation.publish(Clock::now());
    tellDifference();
}

/// Found by a check, or by a step that was due before it was checked ahead, as happens on a busy machine.
void ReplayRun::tellDifference() {
    if (!m_player.difference() || std::exchange(m_hasToldDifference, true)) return;
    emit m_presentation.owner().differenceFound(m_number, *m_player.difference());
}

} // namespace inspector
