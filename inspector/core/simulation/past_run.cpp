// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/past_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inspector {

namespace {

/// The number of steps of a ghost that are repeated beside an earlier run.
constexpr uint64_t kGhostSteps = 100000;

} // namespace

PastRun::PastRun(Presentation &presentation, const LiveRun &live, const Past &past, uint64_t shownRun, uint64_t number)
    : ReplayRun(presentation, live, Player(past.recording, past.keyframes), number)
    , m_past(past)
    , m_shownRun(shownRun) {
    if (shownRun == live.beginPlace() && presentation.ghost()) m_met = presentation.ghost()->met();
    m_player.seek(past.recording->length());
}

void PastRun::addTo(Snapshot &snapshot) const {
    ReplayRun::addTo(snapshot);
    snapshot.history.place = place();
    snapshot.ghost = ghost();
}

void PastRun::step(Clock::time_point due) {
    const uint64_t end = m_past.endOfRun(place());
    if (place() < end && m_player.next()) m_presentation.followDt();
    m_presentation.countStep();
    if (place() == end) m_presentation.setRunning(false);
    m_presentation.publish(due);
}

bool PastRun::showAt(uint64_t offset) {
    const uint64_t place = std::min(m_past.begin + offset, m_past.end());
    const uint64_t run = m_past.beginOfRun(place);
    if (run != firstKept(m_shownRun) && !refill(run)) return false;
    show(place);
    return true;
}

void PastRun::goTo(uint64_t offset) {
    while (!showAt(offset)) {
    }
}

void PastRun::show(uint64_t place) {
    const uint64_t position = m_past.positionOf(place);
    if (place == m_past.beginOfRun(place))
        m_player.seekBegin(position);
    else
        m_player.seek(position);
}

// ---- repeating a run ----

void PastRun::beginRefill(uint64_t run) {
    m_shownRun = kNoRun;
    m_refill.emplace(Refill{run, m_past.endOfRun(run), run == firstKept(m_live.beginPlace())});
    m_presentation.hold();
    m_presentation.clear();
    m_met.reset();
    show(run);
}

/// Repeats part of the run; true when done. The player is then at the run's end.
bool PastRun::refill(uint64_t run) {
    if (!m_refill || m_refill->run != run) beginRefill(run);
    const Clock::time_point until = Clock::now() + kShowSlice;
    while (place() < m_refill->end && addStep())
        if (place() < m_refill->end && Clock::now() >= until) return false;
    m_presentation.release();
    m_refill.reset();
    m_shownRun = run;
    return true;
}

bool PastRun::addStep() {
    auto &[run, end, isLive, ghost, ghostSteps] = *m_refill;
    if (!ghost && ghostSteps == 0 && m_presentation.ghostBeginsAt(engine().state(), isLive)) {
        ghost = m_presentation.ghostOf(engine(), leaderId());
        m_met = engine().state();
    }
    if (!m_player.next()) return false;
    Sample sample = m_presentation.sample();
    if (ghost) ghostSteps += follow(*ghost, sample);
    if (ghostSteps > kGhostSteps) ghost.reset();
    m_presentation.samples().append(sample);
    m_presentation.noteEvents();
    return true;
}

/// Returns the number of steps that it makes.
uint64_t PastRun::follow(GhostEngine &ghost, Sample &sample) const {
    ghost.setLeaderStepper(leaderId());
    if (ghost.follow(engine(), nullptr)) m_presentation.addGhost(ghost, sample);
    return uint64_t(ghost.setup().substeps);
}

void PastRun::showLiveRun() {
    const uint64_t run = firstKept(m_live.beginPlace());
    if (run == firstKept(m_shownRun)) return;
    if (m_live.beginPlace() == m_live.history().end()) return m_presentation.clear();
    while (!refill(run)) {
    }
}

/// Called when the live ball has been put where this one is.
void PastRun::forgetFuture() {
    const double time = engine().state().time;
    m_presentation.samples().truncate(m_presentation.samples().find(std::nextafter(time, HUGE_VAL)));
    m_presentation.events().forgetAfter(time);
}

/// Reconstructed from the samples.
std::optional<Ghost> PastRun::ghost() const {
    const SampleRing &samples = m_presentation.samples();
    Sample sample;
    const phys_state &state = engine().state();
    if (!samples.read(samples.find(state.time), sample) || std::isnan(sample[Channel::GhostX])) return std::nullopt;
    Ghost ghost;
    ghost.number = sample.ghost;
    ghost.current = state;
    ghost.current.position = {sample[Channel::GhostX], sample[Channel::GhostY], sample[Channel::GhostZ]};
    ghost.previous = ghost.current;
    const bool isOfEarlierGhost = !m_met || state.time <= m_met->time;
    if (isOfEarlierGhost)
        ghost.met.time = std::numeric_limits<double>::quiet_NaN();
    else
        ghost.met = *m_met;
    ghost.deviation = {sample[Channel::Distance], sample[Channel::SpeedDifference], sample[Channel::EnergyDifference]};
    return ghost;
}

} // namespace inspector
