// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session.h"

#include <QTimer>

#include <optional>

namespace inspector::ui {

// A run that nobody watches: with --autopilot the level starts by itself, with --grab or --duration it ends by itself.
class UnattendedRun : public QObject {
    Q_OBJECT

public:
    // session: outlives the run.
    UnattendedRun(Session &session, const Options &options, QObject *parent = nullptr);

    // Does nothing if the options ask for nothing of this.
    void start();

signals:
    // Once: after the options' duration, when the ball is out of the maze, or at an error (one line, else empty).
    void finished(const QString &error);

private:
    void look();
    void finish(const QString &error);
    bool isOver();

    Session &m_session;
    std::optional<double> m_duration; // s, simulated
    bool m_plays;
    bool m_ends;
    int m_looks = 0;
    QTimer m_timer;
};

} // namespace inspector::ui
