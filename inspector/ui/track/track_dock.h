// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/track/fit_worker.h"

#include <QWidget>

class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QUndoStack;

namespace inspector::ui {

class ResidualPlot;

// A measured ball: its file, the fit in the background, what it found, and the values to be taken over.
class TrackDock : public QWidget {
    Q_OBJECT

public:
    // Both outlive the dock.
    TrackDock(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {900, 320}; }

private:
    QWidget *makeControls();
    void openFile();
    void toggle(); // begins to fit, or cancels
    void showOutcome(const std::shared_ptr<const FitOutcome> &outcome);
    void showRunning();
    void takeOver();
    std::vector<Setting> fittedSettings() const;

    Session &m_session;
    QUndoStack &m_undo;
    FitWorker m_worker;
    std::shared_ptr<const FitOutcome> m_outcome; // of the last fit; may be null
    QLineEdit *m_file;
    QLineEdit *m_units;
    QPushButton *m_fit;
    QPushButton *m_takeOver;
    QProgressBar *m_progress;
    QPlainTextEdit *m_report;
    ResidualPlot *m_residuals;
};

} // namespace inspector::ui
