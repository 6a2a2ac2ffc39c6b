// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/comparison.h"

#include "core/session/session.h"

#include <algorithm>
#include <set>
#include <utility>

namespace inspector {

Comparison::Comparison(Session &session)
    : m_session(session) {
    takeRows();
    connect(&m_parameters, &Parameters::changed, this, [this] { passOwnInputs(); });
    connect(&session, &Session::levelOpened, this, &Comparison::beginInScene);
    connect(&session, &Session::pastChanged, this, &Comparison::beginIfWaiting);
    connect(&session.simulation(), &Simulation::comparisonRefused, this, [this](uint64_t ghost, const QString &line) {
        if (ghost == m_ghost) refuse(line); // ignore an earlier ghost's
    });
    connect(&session.simulation(), &Simulation::runBegan, this, &Comparison::forgetRefusal);
}

void Comparison::start(const GhostChoice &ghostChoice) {
    m_ghostChoice = ghostChoice;
    m_isOn = true;
    takeRows();
    begin();
}

void Comparison::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    if (isOn) return start(m_ghostChoice);
    m_isOn = false;
    m_isWaiting = false;
    m_refusal.clear();
    m_ghost = 0;
    m_session.simulation().endComparison();
    emit changed();
}

void Comparison::setGhostChoice(const GhostChoice &ghostChoice) {
    if (ghostChoice == m_ghostChoice) return;
    m_ghostChoice = ghostChoice;
    takeRows();
    begin();
    if (!m_isOn) emit changed();
}

void Comparison::meetAgain() { begin(); }

/// Makes a new stepper each time: it is cheap, and a stepper that couldn't be made is tried again.
void Comparison::begin() {
    if (!m_isOn) return;
    m_isWaiting = m_session.isInPast(); // the past has samples only
    if (m_isWaiting) return;
    m_scene = m_session.scene();
    m_refusal.clear();
    m_ghost = 0;
    QString error;
    auto setup = makeGhostSetup(m_session.registry(), m_ghostChoice, m_session.scene(), &error);
    if (!setup) {
        m_session.simulation().endComparison();
        return refuse(error);
    }
    setup->own = ownInputs();
    m_met = m_session.simulation().compareWith(*setup, m_session.stepperId());
    note(m_met);
    emit changed();
}

/// Whoever only looked at another level's run comes back to the ghost that was there.
void Comparison::beginInScene() {
    if (!m_session.isInPast() && m_session.scene() != m_scene) begin();
}

void Comparison::beginIfWaiting() {
    if (m_isWaiting) begin();
}

/// Passes the ghost's own parameters on, if there is a ghost.
void Comparison::passOwnInputs() {
    if (m_ghost != 0) note(m_session.simulation().setGhostInputs(ownInputs()));
}

void Comparison::note(uint64_t ghost) {
    m_ghost = ghost;
    if (m_made.size() >= m_mostMade) forgetUnseen();
    m_made.push_back({ghost, m_met, m_ghostChoice, m_hasOwn ? settingsOf(m_parameters) : std::vector<Setting>()});
}

/// Drops those that no kept sample names, and that make no more.
void Comparison::forgetUnseen() {
    const SampleRing &samples = m_session.simulation().samples();
    const std::optional<Ghost> now = m_session.simulation().latest().ghost;
    const uint64_t oldestAlive = now ? now->number : m_ghost;
    std::set<uint64_t> seen;
    Sample sample;
    for (uint64_t number = samples.first(); number < samples.last(); ++number)
        if (samples.read(number, sample)) seen.insert(sample.ghost);
    std::erase_if(m_made, [&](const Made &made) { return made.number < oldestAlive && !seen.contains(made.number); });
    m_mostMade = std::max(kFewMade, 2 * m_made.size());
}

const Comparison::Made *Comparison::made(uint64_t ghost) const {
    const auto found = std::ranges::lower_bound(m_made, ghost, {}, &Made::number);
    return found != m_made.end() && found->number == ghost ? &*found : nullptr;
}

void Comparison::refuse(const QString &line) {
    m_refusal = tr("comparison with %1: %2").arg(stepperName(m_session.registry(), m_ghostChoice.stepper), line);
    emit refused(m_refusal);
    emit changed();
}

/// Called when the ghost has started over, if there is one.
void Comparison::forgetRefusal() {
    if (m_ghost == 0 || m_refusal.isEmpty()) return;
    m_refusal.clear();
    emit changed();
}

/// Adopts the rows of the ghost's stepper; the other parameters keep their values.
void Comparison::takeRows() {
    phys_stepper_info info;
    const char *id = m_ghostChoice.stepper.constData();
    if (phys_registry_find(m_session.registry().get(), id, &info, nullptr) != PHYS_OK) return; // begin() says so
    if (m_ghostChoice.stepper != std::exchange(m_rowsOf, m_ghostChoice.stepper)) m_parameters.setStepper(info);
}

std::optional<Inputs> Comparison::ownInputs() const {
    return m_hasOwn ? std::optional(m_parameters.inputs()) : std::nullopt;
}

void Comparison::setOwnParameters(bool isOn) {
    if (isOn == m_hasOwn) return;
    if (isOn && !std::exchange(m_hasValues, true)) m_parameters.set(sharedValues(m_session.parameters(), m_parameters));
    m_hasOwn = isOn;
    if (isOn && !m_isOn) return start(m_ghostChoice);
    passOwnInputs();
    emit changed();
}

} // namespace inspector
