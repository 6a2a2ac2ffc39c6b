// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QMainWindow>
#include <QTimer>

#include <vector>

class QDockWidget;
class QMenu;
class QUndoStack;

namespace inspector::gl {
class MazeView;
struct Frame;
struct Ray;
} // namespace inspector::gl

namespace inspector::ui {

class BounceDock;
class ComparisonDock;
class GameOverlay;
class LevelPanel;
class MessageBar;
class ParameterPanel;
class PlotPanel;
class ReplayBar;
class StatusLine;
class TimePlot;
class TransportBar;

// The window: composes view, docks, bars and menus over a session and forwards between them.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    // session: outlives the window.
    explicit MainWindow(Session &session);
    ~MainWindow() override;

    gl::MazeView &view() { return *m_view; }
    MessageBar &messages() { return *m_messages; }

    // Writes a picture of the whole window as it is now. False and one line in `error` (or nullptr) if that fails.
    bool grabTo(const QString &path, QString *error);
    // Everything that follows the simulation shows the present moment; called about 30 times a second.
    void refresh();

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    struct ActionRow;
    struct DockRow;
    static const std::vector<ActionRow> &actionRows();

    // Made once, in this order.
    void makeActions();
    void makeCentre();
    void makeDocks();
    void addDockAction(QDockWidget &dock, int number, double share);
    void showDock(QDockWidget &dock, double share);
    void showComparisonDock();
    void makeMenus();
    void addUndoActions(QMenu &menu);
    void addViewChoices(QMenu &menu);
    void addChoice(QMenu &menu, const char *name, const QStringList &texts, int (MainWindow::*chosen)() const,
                   void (MainWindow::*choose)(int));
    void connectSession();
    QAction *action(const char *name) const;
    void savePlotAs(TimePlot &plot, const QString &name);

    void connectBounces();
    void selectBounceAt(const gl::Ray &ray);
    void openLevel();
    void openFile(const QString &path);
    void showReplay(bool isOn);
    void showTitle();
    void showRunning(bool isRunning);
    void showComparison();
    void restoreLook();
    void arrangeDocks();
    gl::Frame frame() const;
    int quality() const;
    void chooseQuality(int number);
    int theme() const;
    void chooseTheme(int number);

    // One for each row of the table of actions.
    void openMazeFile();
    void openRecording();
    void closeRecording();
    void savePlot();
    void saveScreenshot();
    void toggleRecording();
    void quit();
    void resetParameters();
    void resetLayout();
    void resetCamera();
    void lookFromAbove();
    void toggleBounces();
    void confirm();
    void toggleRunning();
    void pause();
    void stepOnce();
    void restart();
    void toggleAutopilot();
    void toggleComparison();
    void meetAgain();
    void stepBack();
    void goToEnd();
    void goOnFromHere();
    void showKeys();
    void showAbout();

    Session &m_session;
    QUndoStack *m_undo;
    gl::MazeView *m_view = nullptr;
    GameOverlay *m_overlay = nullptr;
    MessageBar *m_messages = nullptr;
    ParameterPanel *m_parameters = nullptr;
    PlotPanel *m_plot = nullptr;
    ComparisonDock *m_comparison = nullptr;
    LevelPanel *m_levels = nullptr;
    BounceDock *m_bounces = nullptr;
    QAction *m_showsBounces = nullptr;
    TransportBar *m_transport = nullptr;
    ReplayBar *m_replay = nullptr;
    StatusLine *m_status = nullptr;
    QByteArray m_firstLayout; // of docks and bars, before anyone moved them
    QTimer m_refresh;
};

} // namespace inspector::ui
