// SPDX-License-Identifier: GPL-3.0-or-later
// A run that nobody watches: starts by itself, ends by itself, leaves a table. The window adds a picture.
#pragma once

#include "session.h"

#include <QTimer>

namespace inspector {

class UnattendedRun : public QObject {
    Q_OBJECT

public:
    // Both outlive the run.
    UnattendedRun(Session &session, const Options &options, QObject *parent = nullptr);

    // Whether the options ask for such a run.
    static bool isWanted(const Options &options);

    // Starts the level. The run ends when the ball is out of the maze, after the options' duration, or at an error.
    void start();

signals:
    // Once; the table is written. `error`: one line, empty if all went well.
    void finished(const QString &error);

private:
    void look();
    void finish(QString error);
    QString writeTable() const;

    Session &m_session;
    const Options &m_options;
    QTimer m_timer;
    bool m_isFinished = false;
};

} // namespace inspector
