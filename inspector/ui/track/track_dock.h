// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/track/fit_worker.h"

#include <QWidget>

class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QSplitter;
class QToolButton;
class QUndoStack;

namespace inspector::ui {

class FileBox;
class FitTable;
class ResidualPlot;
class TextBox;

/// A measured ball: its file, its overlay on the run, its fit in the background, and the results, which can be applied.
class TrackDock : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the dock.
    TrackDock(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    /// Overlays the measured ball of a file on the run, as if its name and units were typed, in the current frame.
    /// False if it can't be read, which the dock reports.
    bool open(const QString &path, const QString &units);
    void setFrame(const TrackFrame &frame);
    QString units() const; ///< as typed
    /// Writes, by the name's suffix, .csv (the residuals, and beside them what the fit began with and found), .png or
    /// .pdf (the plot). Returns false, with one line in `error`, on failure.
    bool save(const QString &path, QString *error);

    QSize sizeHint() const override { return {900, 320}; }

signals:
    void opened(const QString &path);
    void saveWanted();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange(Qt::Orientation orientation);
    QWidget *makeControls();
    void chooseTrackFile();
    bool openTrack(); ///< opens the file that was typed; reports what is wrong with it
    void layOver(const BoardParameters &board);
    void follow(bool isOn);
    QStringList reportLines() const;
    void showReport();
    void showAnew();
    void forgetFit();
    void hideFit();
    void showLevel(); ///< clears a fit of another maze; a track, and its fit, are shown again with their level
    void toggle();    ///< starts or cancels a fit
    void showOutcome(const std::shared_ptr<const FitOutcome> &outcome);
    void showRunning();
    QString othersText() const;
    void showConditions(); ///< updates the report if parameters changed on which the result depends
    void takeOver();
    std::vector<Setting> found() const; ///< what can be taken over

    Session &m_session;
    QUndoStack &m_undo;
    FitWorker m_worker;
    std::shared_ptr<const FitOutcome> m_outcome; ///< of the last fit; may be null
    std::vector<Setting> m_assumed;              ///< parameters that the last fit took for true
    Options m_begunWith;                         ///< likewise, and its files
    QString m_shownOthers;                       ///< those of them that aren't set any more, as the report names them
    std::optional<Track> m_track;
    QString m_level; ///< name of the level on which it was opened
    FileBox *m_file;
    TextBox *m_units; ///< refused if they can't be read
    QPushButton *m_fit;
    QToolButton *m_save;
    QPushButton *m_follow;
    QPushButton *m_takeOver;
    QProgressBar *m_progress;
    FitTable *m_quantities;
    QPlainTextEdit *m_report;
    ResidualPlot *m_residuals;
    QSplitter *m_results; ///< report and residuals
    QSplitter *m_halves;  ///< the table, and the splitter m_results
};

} // namespace inspector::ui
