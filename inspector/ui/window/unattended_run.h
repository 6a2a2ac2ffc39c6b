// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTimer>

#include <optional>

namespace inspector::ui {

/// An unattended run. With --autopilot the level starts by itself, with --grab or --duration the run ends by itself.
/// For a recording --grab shows the end, or the moment given by --duration, without playing up to there but after
/// checking all of the recording.
class UnattendedRun : public QObject {
    Q_OBJECT

public:
    /// session must outlive the run.
    UnattendedRun(Session &session, const Options &options, QObject *parent = nullptr);

    /// No effect unless the options ask for it.
    void start();

signals:
    /// Emitted once: after the options' duration, when the ball is out of the maze or the recording at its end, or on
    /// an error (one line; otherwise empty). A differing step of a recording is also an error, but doesn't end the run
    /// early.
    void finished(const QString &error);

private:
    void look();
    void finish(const QString &error);
    bool isOver();
    void startLive();
    void startReplay();
    bool isReplayOver();

    Session &m_session;
    std::optional<double> m_duration; ///< s, simulated
    bool m_plays;
    bool m_ends;
    bool m_grabs;
    uint64_t m_lastPosition = 0; ///< position in a recording
    QString m_difference;
    int m_looks = 0;
    QTimer m_timer;
};

} // namespace inspector::ui
