// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTimer>

#include <optional>

namespace inspector::ui {

// A run that nobody watches: with --autopilot the level starts by itself, with --grab or --duration it ends by itself.
// Of a recording --grab shows the end, or the moment that --duration says, without playing up to there; all of it is
// checked before.
class UnattendedRun : public QObject {
    Q_OBJECT

public:
    // session: outlives the run.
    UnattendedRun(Session &session, const Options &options, QObject *parent = nullptr);

    // Does nothing if the options ask for nothing of this.
    void start();

signals:
    // Once: after the options' duration, when the ball is out of the maze or the recording at its end, or at an error
    // (one line, else empty). A step of a recording that differs is an error, too, but ends nothing.
    void finished(const QString &error);

private:
    void look();
    void finish(const QString &error);
    bool isOver();
    void startLive();
    void startReplay();
    bool isReplayOver();

    Session &m_session;
    std::optional<double> m_duration; // s, simulated
    bool m_plays;
    bool m_ends;
    bool m_grabs;
    uint64_t m_lastPosition = 0; // of a recording
    QString m_difference;
    int m_looks = 0;
    QTimer m_timer;
};

} // namespace inspector::ui
