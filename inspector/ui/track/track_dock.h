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

class FitTable;
class ResidualPlot;

// A measured ball: its file, laid over the run; the fit in the background, what it found, and the values to be taken
// over.
class TrackDock : public QWidget {
    Q_OBJECT

public:
    // Both outlive the dock.
    TrackDock(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    // Lays the measured ball of a file over the run, as if its name and units (words) were typed; in the frame that is
    // set. False if it can't be read, which the dock says.
    bool open(const QString &path, const QString &units);
    void setFrame(const TrackFrame &frame);
    QString units() const; // as they are typed

    QSize sizeHint() const override { return {900, 320}; }

private:
    QWidget *makeControls();
    void chooseTrackFile();
    bool openTrack(); // as it is typed; says what is wrong with it
    void layOver(const BoardParameters &board);
    void follow(bool isOn);
    void forget(); // the track and the fit, of another maze
    void toggle(); // begins to fit, or cancels
    void showOutcome(const std::shared_ptr<const FitOutcome> &outcome);
    void showRunning();
    void takeOver();
    std::vector<Setting> fittedSettings() const;

    Session &m_session;
    QUndoStack &m_undo;
    FitWorker m_worker;
    std::shared_ptr<const FitOutcome> m_outcome; // of the last fit; may be null
    std::optional<Track> m_track;
    QLineEdit *m_file;
    QLineEdit *m_units;
    QPushButton *m_fit;
    QPushButton *m_follow;
    QPushButton *m_takeOver;
    QProgressBar *m_progress;
    FitTable *m_quantities;
    QPlainTextEdit *m_report;
    ResidualPlot *m_residuals;
};

} // namespace inspector::ui
