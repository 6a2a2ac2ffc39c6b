// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/past_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inspector {

namespace {

/// The number of steps of an earlier run, and of a ghost beside it, that are repeated for plots and trails; this takes
/// a moment.
constexpr uint64_t kStepsOfARun = 100000;

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
    show(std::min(m_past.begin + offset, m_past.end()));
    const uint64_t wanted = m_past.beginOfRun(place());
    if (wanted != std::max(m_shownRun, m_past.begin)) refillSamples(wanted);
    return true;
}

void PastRun::goTo(uint64_t offset) { showAt(offset); }

void PastRun::show(uint64_t place) {
    const uint64_t position = m_past.positionOf(place);
    if (place == m_past.beginOfRun(place))
        m_player.seekBegin(position);
    else
        m_player.seek(position);
}

/// Repeats the run from its beginning to its end, beside a ghost like the present one; the player returns to where it
/// was.
void PastRun::refillSamples(uint64_t first) {
    const uint64_t shown = place();
    const uint64_t end = std::min(m_past.endOfRun(first), first + kStepsOfARun);
    m_presentation.hold();
    m_presentation.clear();
    show(first);
    const bool isLive = first == std::max(m_live.beginPlace(), m_past.begin);
    std::optional<GhostEngine> ghost;
    uint64_t ghostSteps = 0;
    m_met.reset();
    while (place() < end) {
        if (!ghost && ghostSteps == 0 && m_presentation.ghostBeginsAt(engine().state(), isLive)) {
            ghost = m_presentation.ghostOf(engine(), leaderId());
            m_met = engine().state();
        }
        if (!m_player.next()) break;
        Sample sample = m_presentation.sample();
        if (ghost) ghostSteps += follow(*ghost, sample);
        if (ghostSteps > kStepsOfARun) ghost.reset();
        m_presentation.samples().append(sample);
        m_presentation.noteEvents();
    }
    if (end < m_past.endOfRun(first)) m_presentation.samples().cut();
    show(shown);
    m_presentation.release();
    m_shownRun = first;
}

/// Returns the number of steps that it makes.
uint64_t PastRun::follow(GhostEngine &ghost, Sample &sample) const {
    ghost.setLeaderStepper(leaderId());
    if (ghost.follow(engine(), nullptr)) m_presentation.addGhost(ghost, sample);
    return uint64_t(ghost.setup().substeps);
}

void PastRun::showLiveRun() {
    const uint64_t begin = std::max(m_live.beginPlace(), m_past.begin);
    if (begin == std::max(m_shownRun, m_past.begin)) return;
    if (m_live.beginPlace() < m_live.history().end())
        refillSamples(begin);
    else
        m_presentation.clear();
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
