// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/parts/path_icon.h"

#include <QHash>
#include <QList>
#include <QMainWindow>
#include <QTimer>

#include <functional>
#include <optional>
#include <span>
#include <vector>

class QDockWidget;
class QMenu;
class QUndoStack;

namespace inspector::gl {
class MazeView;
enum class Drawing;
struct Frame;
struct Ray;
} // namespace inspector::gl

namespace inspector::ui {

class BallDragger;
class BounceDock;
class ComparisonDock;
class DockRoom;
class DocumentDialog;
class GameStrip;
class MazeWatcher;
class MessageBar;
class ParameterPanel;
class PlotPanel;
class PlotStack;
class TimeBar;
class Ruler;
class StatusLine;
class TimePlot;
class TimeView;
class TrackDock;
class TradeDock;
class TransportBar;

/// The window: assembles view, docks, bars and menus over a session and connects them.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// session must outlive the window.
    explicit MainWindow(Session &session, gl::Drawing drawing = {}); ///< solid
    ~MainWindow() override;

    gl::MazeView &view() { return *m_view; }
    MessageBar &messages() { return *m_messages; }
    /// reason: one line.
    void sayWhyFlat(const QString &reason);

    /// Writes a picture of the whole window as it is now. Returns false, with one line in `error` (may be nullptr), on
    /// failure.
    bool grabTo(const QString &path, QString *error);
    /// Updates everything that follows the simulation; called about 30 times a second.
    void refresh();

    /// Overlays a measured ball on the run, in the dock's frame. False if the file can't be read, which the dock
    /// reports.
    bool openTrack(const QString &path, const QString &units);
    TrackDock &track() { return *m_track; }

signals:
    void refreshing(const inspector::Snapshot &now); ///< about 30 times a second

protected:
    bool focusNextPrevChild(bool isNext) override;
    void childEvent(QChildEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    struct ActionRow {
        const char *name;
        const char *text;
        const char *keys; ///< as in QKeySequence, "; " between several
        const char *tip;
        void (MainWindow::*run)();
        std::optional<Glyph> glyph = {};
    };
    struct DockRow;
    static const std::vector<ActionRow> &actionRows();
    static std::vector<ActionRow> fileRows();
    static std::vector<ActionRow> viewRows();
    static std::vector<ActionRow> cameraRows();
    static std::vector<ActionRow> runRows();
    static std::vector<ActionRow> ghostRows();
    static std::vector<ActionRow> helpRows();

    /// Called once each, in this order.
    void makeActions();
    void makeCentre(gl::Drawing drawing);
    void makeDocks();
    template<typename Widget>
    Widget *refreshed(Widget *widget);
    static QWidget *makeParameters(MainWindow &window);
    static QWidget *makePlots(MainWindow &window);
    static QWidget *makeComparison(MainWindow &window);
    void arrangeOnCall(std::span<const DockRow> rows);
    void addDockAction(QDockWidget &dock, int number, double share);
    void showDock(QDockWidget &dock, double share);
    QList<QDockWidget *> docksOf(Qt::DockWidgetArea area, bool isOnCall) const;
    void giveBackHeights(Qt::DockWidgetArea area);
    void showComparisonDock();
    void showBouncesDock();
    void makeMenus();
    void addUndoActions(QMenu &menu);
    void addViewChoices(QMenu &menu);
    void addChoice(QMenu &menu, const char *name, const QStringList &texts, int (MainWindow::*chosen)() const,
                   void (MainWindow::*choose)(int));
    void connectSession();
    void connectMessages();
    void obey(void (MainWindow::*command)());
    void settleCommand();
    void settleSaid();
    void settleByChange();
    QAction *action(const char *name) const;
    void connectPlots();
    void askWhereToSavePlot(const QString &name, const TimeView &time,
                            const std::function<bool(const QString &path, QString *error)> &save);
    void showSaved(const QString &path, const QString &line);
    void showRemark(const QString &line);
    void sayItIsSaved(const QString &path);

    void connectBounces();
    void selectBounceAt(const gl::Ray &ray);
    void openLevel();
    void openFile(const QString &path);
    void remember(const QString &path, bool isOpen);
    void rememberFirst();
    void addRecent(QMenu &menu);
    void loadPlugin(const QString &path);
    void watchMaze();
    void readMazeAgain(const QString &path);
    void sayMazeIsGone(const QString &path);
    void sayMazeIsOlder(const QString &path);
    void showPage(const QString &page, const QString &section = {});
    void showReplay(bool isOn);
    void showPast(bool isIn);
    void sayWhereTheRunIs();
    void sayWhereTheRunBeforeIs();
    void sayTheBallIsBack();
    void sayOfTheBall(const QString &line);
    void sayIfSettingsAreLost();
    void sayBriefly(const QString &line); ///< shows it for some seconds in the status line
    void jumpToBounce(Direction direction);
    void showTitle();
    void showRunning(bool isRunning);
    void showComparison();
    void restoreLook();
    void bringFloatingDocksUp();
    void restoreDocks();
    void fitScreen();
    void arrangeDocks();
    bool hasNewFrame();
    gl::Frame frame() const;
    int quality() const;
    void chooseQuality(int number);
    void useQuality();
    int pictureScale() const;
    void choosePictureScale(int number);
    int textSize() const;
    void chooseTextSize(int number);
    int theme() const;
    void chooseTheme(int number);

    /// One for each row of the table of actions.
    void openMazeFile();
    void openRecording();
    void askForTrack();
    void askForPlugin();
    void closeRecording();
    void saveRun();
    void saveFilm();
    void savePlot();
    void saveCurves();
    void saveDistance();
    void saveTrade();
    void saveFit();
    void saveScreenshot();
    void toggleRecording();
    void quit();
    void resetParameters();
    void resetLayout();
    void resetCamera();
    void turnLeft();
    void turnRight();
    void lookFromHigher();
    void lookFromLower();
    void lookFromNearer();
    void lookFromFarther();
    void lookFromAbove();
    void toggleFollowing();
    void toggleBounces();
    void toggleWayAhead();
    void toggleOthersAhead();
    void goToNextPart();
    void goToPartBefore();
    void confirm();
    void toggleRunning();
    void pause();
    void stepOnce();
    void restart();
    void toggleAutopilot();
    void toggleComparison();
    void meetAgain();
    void toggleGhostParameters();
    void copyToGhost();
    void swapWithGhost();
    void stepBack();
    void goToStart();
    void bounceBack();
    void bounceOn();
    void goToEnd();
    void goOnFromHere();
    void showKeys();
    void showGuide();
    void showModelPage();
    void showAccuracyPage();
    void showAbout();

    Session &m_session;
    QUndoStack *m_undo;
    gl::MazeView *m_view = nullptr;
    GameStrip *m_strip = nullptr;
    MessageBar *m_messages = nullptr;
    bool m_isJustSaid = false; ///< by the command that is being carried out
    bool m_hasSaidSettingsAreLost = false;
    ParameterPanel *m_parameters = nullptr;
    PlotStack *m_plots = nullptr;
    PlotPanel *m_plotPanel = nullptr;
    ComparisonDock *m_comparison = nullptr;
    BallDragger *m_hand = nullptr;
    Ruler *m_ruler = nullptr;
    MazeWatcher *m_mazeWatcher = nullptr;
    DocumentDialog *m_documents = nullptr; ///< created on demand
    TrackDock *m_track = nullptr;
    TradeDock *m_trade = nullptr;
    BounceDock *m_bounces = nullptr;
    QAction *m_run = nullptr;
    QAction *m_showsBounces = nullptr;
    TransportBar *m_transport = nullptr;
    TimeBar *m_time = nullptr;
    StatusLine *m_status = nullptr;
    int m_layoutVersion = 0;  ///< stored layouts with other docks have another one, and are discarded
    QByteArray m_firstLayout; ///< of docks and bars, before the user moved them
    uint64_t m_drawn = 0;     ///< sum of the versions of what the view shows
    bool m_wasShown = false;
    bool m_awaitsItsSize = false;
    QTimer m_refresh;
    DockRoom *m_dockRoom = nullptr;
    QTimer m_afterLayout;                        ///< of a window that was resized
    QList<QDockWidget *> m_onCall;               ///< docks that aren't there from the start
    QHash<QDockWidget *, int> m_heights;         ///< of docks, before others were opened in their area
    QHash<Qt::DockWidgetArea, int> m_roomBefore; ///< of all docks of the area, likewise
};

} // namespace inspector::ui
