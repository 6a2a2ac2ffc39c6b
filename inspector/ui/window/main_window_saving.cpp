// SPDX-License-Identifier: GPL-3.0-or-later
// What is saved: the run shown, the plot that is seen, pictures, recordings.
#include "core/setup/lines.h"
#include "ui/comparison/comparison_dock.h"
#include "ui/comparison/distance_plot.h"
#include "ui/files/file_chooser.h"
#include "ui/parts/message_bar.h"
#include "ui/plots/plot_stack.h"
#include "ui/track/track_dock.h"
#include "ui/trade/trade_dock.h"
#include "ui/window/main_window.h"
#include "ui/window/save_run.h"

namespace inspector::ui {

void MainWindow::saveRun() {
    const QString again = m_session.isReplaying() ? QString() : tr("Recording that repeats it (*.rec);;");
    const QString filter = again + tr("Table of all samples (*.csv);;Picture of the view (*.png)");
    chooseFile(*this, m_session.settings(), {tr("Save run"), filter, tr("run"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   if (ui::saveRun(m_session, *m_view, path, &error)) error = remarkOnSaved(m_session, path);
                   showSaved(path, error);
               });
}

/// The one that is seen: their docks lie behind each other.
void MainWindow::savePlot() {
    const auto isSeen = [](const QWidget *widget) { return !widget->visibleRegion().isEmpty(); };
    if (m_plots->isSeen()) return saveCurves();
    if (isSeen(m_comparison)) return saveDistance();
    if (isSeen(m_trade)) return saveTrade();
    if (isSeen(m_track)) return saveFit();
    saveCurves();
}

void MainWindow::saveDistance() {
    askWhereToSavePlot(tr("distance"), m_comparison->plot().time(),
                       [this](const QString &path, QString *error) { return m_comparison->plot().save(path, error); });
}

void MainWindow::saveTrade() {
    const QString filter = tr("Table of all settings (*.csv);;Picture (*.png);;Document (*.pdf);;Drawing (*.svg)");
    chooseFile(*this, m_session.settings(), {tr("Save trade"), filter, tr("trade"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   m_trade->save(path, &error);
                   showSaved(path, error);
               });
}

void MainWindow::saveFit() {
    const QString filter = tr("Table of the residuals (*.csv);;Picture (*.png);;Document (*.pdf)");
    chooseFile(*this, m_session.settings(), {tr("Save fit"), filter, tr("fit"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   m_track->save(path, &error);
                   showSaved(path, error);
               });
}

void MainWindow::saveCurves() {
    askWhereToSavePlot(tr("plot"), m_plots->time(),
                       [this](const QString &path, QString *error) { return m_plots->save(path, error); });
}

void MainWindow::askWhereToSavePlot(const QString &name, const TimeView &time,
                                    const std::function<bool(const QString &path, QString *error)> &save) {
    const QString filter = tr("Picture (*.png);;Document (*.pdf);;Table of all samples (*.csv)");
    chooseFile(*this, m_session.settings(), {tr("Save plot"), filter, name, FileUse::Write},
               [this, save, &time](const QString &path) {
                   QString error;
                   const bool isTable = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
                   if (save(path, &error) &&
                       (!isTable || saveSettingsBeside(m_session, path, time.clearedAt(), &error)))
                       error = remarkOnSaved(m_session, path);
                   showSaved(path, error);
               });
}

void MainWindow::saveScreenshot() {
    chooseFile(*this, m_session.settings(),
               {tr("Save picture of the window"), tr("Picture (*.png)"), tr("inspector.png"), FileUse::Write},
               [this](const QString &path) {
                   QString error;
                   grabTo(path, &error);
                   showSaved(path, error);
               });
}

/// line: why it failed, a remark, or empty.
void MainWindow::showSaved(const QString &path, const QString &line) {
    showRemark(line);
    if (line.isEmpty()) sayItIsSaved(path);
}

/// line: or empty.
void MainWindow::showRemark(const QString &line) {
    m_messages->settle(Cause::Command);
    if (!line.isEmpty()) m_messages->showLine(line, Cause::Command);
}

void MainWindow::sayItIsSaved(const QString &path) { sayBriefly(tr("Saved: %1").arg(oneLine(path))); }

void MainWindow::toggleRecording() {
    if (m_session.isRecording()) {
        m_session.stopRecording();
        return sayBriefly(tr("The recording has ended; its file is complete"));
    }
    action("record")->setChecked(false); // stays off until a file is chosen
    chooseFile(*this, m_session.settings(),
               {tr("Record the run"), tr("Recording (*.rec)"), tr("run.rec"), FileUse::Write},
               [this](const QString &path) { m_session.startRecording(path); });
}

} // namespace inspector::ui
