// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/comparison.h"

#include "core/session/session.h"

namespace inspector {

Comparison::Comparison(Session &session)
    : m_session(session) {
    connect(&session, &Session::levelOpened, this, &Comparison::begin);
    connect(&session.simulation(), &Simulation::comparisonRefused, this, &Comparison::refuse);
}

void Comparison::start(const Opponent &opponent) {
    m_opponent = opponent;
    m_isOn = true;
    begin();
}

void Comparison::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    if (isOn) return start(m_opponent);
    m_isOn = false;
    m_refusal.clear();
    m_session.simulation().endComparison();
    emit changed();
}

void Comparison::setOpponent(const Opponent &opponent) {
    if (opponent == m_opponent) return;
    m_opponent = opponent;
    begin();
    if (!m_isOn) emit changed();
}

void Comparison::meetAgain() { begin(); }

// A new stepper each time: it costs little, and one that couldn't be made is tried again.
void Comparison::begin() {
    if (!m_isOn || m_session.isInPast()) return; // of the past there are samples only
    m_refusal.clear();
    QString error;
    const auto means = makeMeans(m_session.registry(), m_opponent, m_session.scene(), &error);
    if (!means) {
        m_session.simulation().endComparison();
        return refuse(error);
    }
    m_session.simulation().compareWith(*means, m_session.stepperId());
    emit changed();
}

void Comparison::refuse(const QString &line) {
    if (!m_isOn) return; // said while it was being switched off
    m_refusal = tr("comparison with %1: %2").arg(QString::fromUtf8(m_opponent.stepper), line);
    emit refused(m_refusal);
    emit changed();
}

} // namespace inspector
