// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "core/setup/lines.h"
#include "gl/view/maze_view.h"
#include "ui/ball/ball_dragger.h"
#include "ui/bounces/bounce_dock.h"
#include "ui/comparison/comparison_dock.h"
#include "ui/comparison/distance_plot.h"
#include "ui/game/game_keys.h"
#include "ui/game/game_strip.h"
#include "ui/input/menu_letters.h"
#include "ui/input/plain_texts.h"
#include "ui/input/wheel_guard.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parts/dock_room.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/theme.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/track/track_dock.h"
#include "ui/trade/trade_dock.h"
#include "ui/transport/time_bar.h"
#include "ui/transport/transport_bar.h"
#include "ui/window/board_picture.h"
#include "ui/window/grab.h"
#include "ui/window/maze_watcher.h"
#include "ui/window/ruler.h"
#include "ui/window/status_line.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QMenu>
#include <QStatusBar>
#include <QTextStream>
#include <QToolButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include <utility>

namespace inspector::ui {

namespace {
constexpr int kRefreshPeriod = 33; ///< ms
} // namespace

MainWindow::MainWindow(Session &session, gl::Drawing drawing)
    : m_session(session)
    , m_undo(new QUndoStack(this)) {
    setObjectName(QStringLiteral("main_window"));
    setWindowTitle(tr("Physics inspector"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    applyTheme(Theme(theme()));
    applyTextScale(kTextScales[size_t(textSize())]);
    makeActions();
    makeCentre(drawing);
    m_dockRoom = new DockRoom(*this, *m_view);
    makeDocks();
    makeMenus();
    connectSession();
    restoreLook();
    if (m_session.comparison().isOn())
        connect(&m_refresh, &QTimer::timeout, this, &MainWindow::showComparisonDock, Qt::SingleShotConnection);
    openLevel();
    rememberFirst();
    showReplay(m_session.isReplaying());
    m_refresh.start(kRefreshPeriod);
}

void MainWindow::showEvent(QShowEvent *event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_wasShown, true)) return;
    m_awaitsItsSize = isMaximized() || isFullScreen();
    if (!m_awaitsItsSize) restoreDocks();
    QMetaObject::invokeMethod(this, &MainWindow::bringFloatingDocksUp,
                              Qt::QueuedConnection); // it isn't on the screen yet
}

/// The window manager enlarges a maximised window once it is shown.
void MainWindow::resizeEvent(QResizeEvent *event) {
    QMainWindow::resizeEvent(event);
    if (std::exchange(m_awaitsItsSize, false)) restoreDocks();
    m_afterLayout.start();
}

MainWindow::~MainWindow() = default;

QAction *MainWindow::action(const char *name) const { return findChild<QAction *>(QLatin1String(name)); }

void MainWindow::makeCentre(gl::Drawing drawing) {
    new PlainTexts(*this); // before any label is polished
    m_messages = new MessageBar;
    m_view = new gl::MazeView(drawing);
    m_view->setObjectName(QStringLiteral("view"));
    m_view->setFocusPolicy(Qt::StrongFocus);
    m_view->setAccessibleName(tr("Board"));
    m_view->setAccessibleDescription(tr("The maze and its ball; the arrow keys tilt it while a level is played"));
    m_view->setLargestTilt(radians(kPlayTilt));
    m_view->setFrameSource([this] { return frame(); }, [this] { return hasNewFrame(); });
    m_strip = new GameStrip;
    new GameKeys(m_session, *this, *m_view); // owned by the window
    new WheelGuard(*this);
    new MenuLetters(*this);
    m_hand = new BallDragger(m_session, *m_view, *m_undo, this);
    m_ruler = new Ruler(*m_view, this);
    m_mazeWatcher = new MazeWatcher(this);
    m_time = new TimeBar(m_session,
                         {action("to_start"), action("bounce_back"), action("step_back"), action("run"), action("step"),
                          action("bounce_on"), action("end")},
                         {action("go_on"), action("close_recording")});

    auto *centre = new QWidget;
    auto *layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_strip);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_time);
    setCentralWidget(centre);
    m_view->setFocus();

    m_transport =
        new TransportBar(m_session, *m_undo, {action("run"), action("step"), action("restart"), action("autopilot")});
    addToolBar(m_transport);
    m_status = new StatusLine;
    setStatusBar(m_status);
}

void MainWindow::connectSession() {
    connectMessages(); // first, because the next signal may settle a message
    connect(&m_session, &Session::levelOpened, this, &MainWindow::openLevel);
    connect(&m_session, &Session::replayChanged, this, &MainWindow::showReplay);
    connect(&m_session, &Session::pastChanged, this, &MainWindow::showPast);
    connect(&m_session, &Session::takenOver, this, &MainWindow::sayWhereTheRunIs);
    connect(&m_session, &Session::runLeft, this, &MainWindow::sayWhereTheRunBeforeIs);
    connect(&m_session, &Session::ballPutBack, this, &MainWindow::sayTheBallIsBack);
    connect(&m_session, &Session::recordingChanged, action("record"), &QAction::setChecked);
    connect(&m_session, &Session::autopilotChanged, action("autopilot"), &QAction::setChecked);
    connect(&m_session.comparison(), &Comparison::changed, this, &MainWindow::showComparison);
    connect(&m_session.simulation(), &Simulation::runningChanged, this, &MainWindow::showRunning);
    connect(m_mazeWatcher, &MazeWatcher::changed, this, &MainWindow::readMazeAgain);
    connect(m_mazeWatcher, &MazeWatcher::lost, this, &MainWindow::sayMazeIsGone);
    connect(&m_session, &Session::olderMazeOpened, this, &MainWindow::sayMazeIsOlder);
    connect(m_mazeWatcher, &MazeWatcher::found, this, [this] { m_messages->settle(Cause::Maze); });
    connect(m_view, &gl::MazeView::followingChanged, action("camera_follow"), &QAction::setChecked);
    connectPlots();
    connect(&m_refresh, &QTimer::timeout, this, &MainWindow::refresh);
    m_afterLayout.setSingleShot(true);
    connect(&m_afterLayout, &QTimer::timeout, m_dockRoom, &DockRoom::follow);
    connectBounces();
    m_session.lookAhead().show(action("way_ahead")->isChecked());
    action("autopilot")->setChecked(m_session.hasAutopilot());
    action("record")->setChecked(m_session.isRecording());
    showComparison();
}

void MainWindow::connectPlots() {
    connect(m_plotPanel, &PlotPanel::followWanted, m_plots, &PlotStack::setFollowing);
    connect(m_plotPanel, &PlotPanel::pauseWanted, m_plots, &PlotStack::setPaused);
    connect(m_plotPanel, &PlotPanel::clearWanted, m_plots, &PlotStack::clear);
    connect(m_plotPanel, &PlotPanel::saveWanted, this, &MainWindow::saveCurves);
    connect(m_comparison, &ComparisonDock::saveWanted, this, &MainWindow::saveDistance);
    connect(m_trade, &TradeDock::saveWanted, this, &MainWindow::saveTrade);
    connect(m_track, &TrackDock::saveWanted, this, &MainWindow::saveFit);
    connect(m_track, &TrackDock::opened, this, [this](const QString &path) { remember(path, true); });
    const QToolButton *add =
        m_plotPanel->addButton(Glyph::Add, QStringLiteral("plot_add"), tr("Add a plot, or change one"));
    connect(add, &QToolButton::clicked, this, [this, add] {
        auto *menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        m_plots->fillMenu(*menu, &m_plots->first());
        menu->popup(add->mapToGlobal(add->rect().bottomLeft()));
    });
}

void MainWindow::connectBounces() {
    connect(m_view, &gl::MazeView::clicked, this, &MainWindow::selectBounceAt);
    connect(m_plots, &PlotStack::bounceClicked, m_bounces, &BounceDock::selectAt);
    connect(m_bounces, &BounceDock::sectionWanted, this,
            [this](const QString &section) { showPage(QStringLiteral("libphysics/docs/model.md"), section); });
    connect(m_bounces, &BounceDock::changed, this, [this] {
        const std::optional<LoggedEvent> selected = m_bounces->selected();
        const std::optional<double> time = selected ? std::optional(selected->event.time) : std::nullopt;
        m_view->update(); // redraws the marks
        m_plots->showBounces(m_bounces->bounceTimes(), time);
        m_comparison->plot().showBounces(m_bounces->bounceTimes(), time); // where distances jump
    });
}

/// A click on nothing clears the selection.
void MainWindow::selectBounceAt(const gl::Ray &ray) {
    std::optional<uint64_t> found;
    if (m_showsBounces->isChecked()) found = markAt(*m_view, ray, m_bounces->marks(), m_session.scene().get());
    if (!found) return m_bounces->clearSelection();
    m_bounces->select(*found);
    showBouncesDock();
}

/// While the simulation runs, the ball also moves between two snapshots.
bool MainWindow::hasNewFrame() {
    const Snapshot &now = m_session.simulation().latest();
    const uint64_t seen = now.number + m_session.lookAhead().updates();
    return now.running || seen != std::exchange(m_drawn, seen);
}

gl::Frame MainWindow::frame() const {
    gl::Frame frame = currentFrame(m_session);
    addWayAhead(frame, m_session.lookAhead().way());
    m_hand->addArrow(frame.strokes);
    m_ruler->addTo(frame.strokes);
    if (m_showsBounces->isChecked()) addMarks(frame.strokes, m_bounces->marks(), m_session.scene().get());
    return frame;
}

void MainWindow::openLevel() {
    m_messages->settle(Cause::Level);
    m_messages->settle(Cause::Maze);
    QString ofMaze;
    QString ofBall;
    m_view->setMaze(mazeMesh(m_session, &ofMaze));
    if (m_view->drawing() != gl::Drawing::Flat) m_view->setBall(ballMesh(&ofBall)); // flat, the ball is a disc
    QTextStream messages(stderr); // for scripted pictures, where nobody sees the message bar
    for (const QString &problem : {ofBall, ofMaze}) {
        if (problem.isEmpty()) continue;
        m_messages->showLine(problem, Cause::Level);
        report(messages, problem);
    }
    watchMaze();
    showTitle();
}

void MainWindow::showTitle() {
    const QString title = tr("%1 – Physics inspector").arg(levelTitle(m_session, m_session.level()));
    const Playback *replay = m_session.replay();
    if (!replay) return setWindowTitle(title);
    const QString name = QFileInfo(replay->recording().recording().file).fileName();
    setWindowTitle(QStringLiteral("%1 – %2").arg(oneLine(name), title));
}

void MainWindow::refresh() {
    sayIfSettingsAreLost();
    const Snapshot now = m_session.simulation().latest(); // the same moment for the whole window
    m_session.followReplay(now);
    m_run->setEnabled(!m_session.hasEnded(now));
    m_status->showSnapshot(now, m_session.scene().get());
    m_time->refresh(now);
    m_strip->setText(gameText(m_session, now));
    m_bounces->refresh(); // first, as plots mark them
    const std::optional<double> moment = m_session.isInPast() ? std::optional(now.current.time) : std::nullopt;
    const std::optional<Departure> left = m_session.departure();
    m_plots->refresh({m_session.samplesBeside(), moment, left ? std::optional(left->time) : std::nullopt});
    emit refreshing(now);
    m_dockRoom->follow();
    if (m_session.isTiltedByPilot() && !m_session.isInPast()) m_parameters->showPilotsTilt(now.inputs.tilt);
}

void MainWindow::showRunning(bool isRunning) {
    m_run->setIcon(glyphIcon(isRunning ? Glyph::Pause : Glyph::Run));
    m_run->setText(isRunning ? tr("Pause") : tr("Run"));
}

void MainWindow::showComparison() {
    const bool isOn = m_session.comparison().isOn();
    action("compare")->setChecked(isOn);
    action("meet_again")->setEnabled(isOn);
    const bool hasOwn = m_session.comparison().hasOwnParameters();
    action("ghost_parameters")->setChecked(hasOwn);
    action("copy_to_ghost")->setEnabled(isOn && hasOwn);
    action("swap_with_ghost")->setEnabled(isOn && hasOwn && !m_session.isReplaying());
}

bool MainWindow::grabTo(const QString &path, QString *error) {
    refresh();
    m_session.liveUncertainty().finish(); // this and the next lines make pictures of the same moment identical
    refresh();
    m_session.lookAhead().computeAtOnce(m_session.simulation().latest(), m_session.scene());
    m_status->leaveOutClock();
    QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // lay out new texts
    for (QCustomPlot *plot : findChildren<QCustomPlot *>())
        for (int pass = 0; pass < 2; ++pass)
            plot->replot(); // immediately; margins fit the content only the second time
    return grabToFile(*this, path, error);
}

} // namespace inspector::ui
