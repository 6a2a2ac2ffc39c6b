// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/unattended_run.h"

#include <algorithm>
#include <chrono>

namespace inspector::ui {

namespace {

using namespace std::chrono_literals;

constexpr auto kPeriod = 50ms;
constexpr int kLooksAtRest = 20; ///< pictures drawn before an idle window is grabbed

} // namespace

UnattendedRun::UnattendedRun(Session &session, const Options &options, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_duration(options.duration)
    , m_plays(options.autopilot)
    , m_ends(!options.grab.isEmpty() || options.duration.has_value())
    , m_grabs(!options.grab.isEmpty()) {
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, &UnattendedRun::look);
}

void UnattendedRun::start() {
    if (m_session.isReplaying())
        startReplay();
    else if (m_duration != 0.0)
        startLive();
    if (!m_ends) return;
    connect(&m_session, &Session::failed, this, &UnattendedRun::finish);
    connect(&m_session.simulation(), &Simulation::failed, this, &UnattendedRun::finish);
    m_timer.start();
}

void UnattendedRun::startLive() {
    if (m_duration) m_session.simulation().pauseAt(*m_duration);
    if (m_plays)
        m_session.game().confirm();
    else if (m_duration)
        m_session.simulation().run();
}

void UnattendedRun::look() {
    ++m_looks;
    if (!isOver()) return;
    if (m_session.simulation().latest().running) {
        m_session.simulation().pause(); // first, so that the whole picture shows one moment
        return;
    }
    m_timer.stop();
    // Queued after the simulation's signals of this moment: a win, a difference.
    QMetaObject::invokeMethod(
        this, [this] { finish(m_difference); }, Qt::QueuedConnection);
}

bool UnattendedRun::isOver() {
    if (m_session.isReplaying()) return isReplayOver();
    const Snapshot now = m_session.simulation().latest();
    // Both end in a pause at the exact step, so that the picture is reproducible.
    if (m_duration && now.current.time >= *m_duration - 0.5 * now.dt) return !now.running;
    if (m_session.departure(now)) return !now.running;
    return !m_plays && !m_duration && m_looks >= kLooksAtRest;
}

void UnattendedRun::startReplay() {
    const PlayableRecording &recording = m_session.replay()->recording();
    m_lastPosition = m_duration ? recording.positionAt(*m_duration) : recording.length();
    connect(&m_session, &Session::replayDiffers, this, [this](const QString &line) { m_difference = line; });
    if (!m_grabs) return;
    m_session.simulation().pause();
    m_session.replay()->seek(m_lastPosition);
}

bool UnattendedRun::isReplayOver() {
    const Snapshot snapshot = m_session.simulation().latest();
    const ReplayPlace &now = snapshot.replay;
    if (now.difference && m_difference.isEmpty()) return false; // the signal hasn't arrived yet
    const bool isThere = now.number > 0 && now.position >= std::min(m_lastPosition, now.end);
    if (m_grabs) return isThere && now.isChecked && m_looks >= kLooksAtRest;
    return isThere || (!snapshot.running && now.difference == now.position); // it has paused at the differing step
}

void UnattendedRun::finish(const QString &error) {
    m_timer.stop();
    disconnect(&m_session, nullptr, this, nullptr);
    disconnect(&m_session.simulation(), nullptr, this, nullptr);
    emit finished(error);
}

} // namespace inspector::ui
