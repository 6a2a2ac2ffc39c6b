// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QToolBar>

class QComboBox;
class QUndoStack;

namespace inspector::ui {

class NumberBox;

QString speedText(double speed); ///< "1/16 ×"

/// Run, step and restart, with speed, stepper and dt.
class TransportBar : public QToolBar {
    Q_OBJECT

public:
    /// playback: the window's actions, shown first. session and undo must outlive the bar.
    TransportBar(Session &session, QUndoStack &undo, const QList<QAction *> &playback, QWidget *parent = nullptr);

protected:
    void changeEvent(QEvent *event) override;

private:
    QComboBox *addChooser(const QString &label, const char *name, const QString &tip);
    void addSpeeds();
    void addSteppers();
    void addTimeSteps();
    void changeTimeStep(double dt);
    void showSpeed();
    void showPace();
    void showStepper();
    void fitStepper();

    Session &m_session;
    QUndoStack &m_undo;
    QComboBox *m_speed = nullptr;
    QComboBox *m_stepper = nullptr;
    QComboBox *m_timeStep = nullptr;
    NumberBox *m_typedTimeStep = nullptr;
};

} // namespace inspector::ui
