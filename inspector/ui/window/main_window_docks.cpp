// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks: their table, their places and sizes, and how these are stored.
#include "core/setup/stored_values.h"
#include "gl/view/maze_view.h"
#include "ui/ball/ball_dock.h"
#include "ui/bounces/bounce_dock.h"
#include "ui/comparison/comparison_dock.h"
#include "ui/game/level_panel.h"
#include "ui/input/keyboard_focus.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parts/dock_room.h"
#include "ui/parts/settings_keys.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_scroll.h"
#include "ui/plots/plot_stack.h"
#include "ui/runs/run_dock.h"
#include "ui/track/track_dock.h"
#include "ui/trade/trade_dock.h"
#include "ui/window/main_window.h"
#include "ui/window/watch_list.h"

#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QFont>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QTabBar>

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr QSize kUsualWindowSize(1280, 800);
constexpr double kWindowShare = 0.75; ///< share of a larger screen
constexpr double kTradeShare = 0.56;  ///< share of the window's height, when the dock is shown
constexpr int kRestHeight = 390;      ///< logical pixels of the window's height, at least, for view and bars
constexpr int kLeastHeight = 100;     ///< of a dock that is opened at the side
constexpr int kLeastBelow = 230;      ///< of one below the view, once the window has it
constexpr double kPlotShare = 0.29;
constexpr double kTrackShare = 0.48;
constexpr double kSideShare = 0.42; ///< of the window's width, at most, for the parameters
constexpr double kComparisonShare = 0.34;
constexpr double kBouncesShare = 0.42;
constexpr double kBouncesWidth = 0.36; ///< share of the window's width, next to the plots
constexpr int kRoomBesidePlots = 71;   ///< lines of text of the window's width, else the bounces are tabbed with them

} // namespace

/// A dock: its names and its initial place.
struct MainWindow::DockRow {
    const char *name;
    const char *title;
    Qt::DockWidgetArea area;
    double
        share; ///< on call, in the place of the plot: of the window's height that it then gets; 0: there from the start
    QWidget *(*make)(MainWindow &window);
};

namespace {
const char *const kParametersDock = "parameters_dock";
const char *const kLevelsDock = "levels_dock";
const char *const kPlotsDock = "plot_dock";
const char *const kComparisonDock = "comparison_dock";
const char *const kBouncesDock = "bounces_dock";
const char *const kTrackDock = "track_dock";

/// The screen's size without a window manager's frame, estimated: it isn't known before the window is shown.
QSize roomFor(const QWidget &window) {
    return window.screen()->availableSize() - QSize(0, 2 * window.style()->pixelMetric(QStyle::PM_TitleBarHeight));
}

/// Qt draws the titles of docks in the program's first font, unless they have one of their own.
void giveTitleItsFont(QDockWidget &dock) {
    QFont own;
    own.setStyleHint(QFont::SansSerif); // all else remains the application's
    dock.setFont(own);
}

/// Makes the content scroll on a small screen, so that the window can be smaller than the content.
QWidget *scrolled(QWidget *content) {
    auto *area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusProxy(content);
    return area;
}
} // namespace

/// Shows what changes without the user, by its refresh().
template<typename Widget>
Widget *MainWindow::refreshed(Widget *widget) {
    connect(this, &MainWindow::refreshing, widget, &Widget::refresh);
    return widget;
}

QWidget *MainWindow::makeParameters(MainWindow &window) {
    const ParameterPanel::Actions actions{*window.action("ghost_parameters"), *window.action("copy_to_ghost"),
                                          *window.action("swap_with_ghost")};
    return window.m_parameters = new ParameterPanel(window.m_session, *window.m_undo, actions);
}

QWidget *MainWindow::makePlots(MainWindow &window) {
    window.m_plots = new PlotStack(window.m_session.simulation().samples(), window.m_session.settings());
    auto *scroll = new PlotScroll(*window.m_plots);
    return window.m_plotPanel = new PlotPanel(scroll, window.m_plots->time(), QStringLiteral("plot"));
}

QWidget *MainWindow::makeComparison(MainWindow &window) {
    const ComparisonDock::Actions actions{*window.action("compare"), *window.action("meet_again"),
                                          *window.action("ghost_parameters")};
    return window.m_comparison = window.refreshed(new ComparisonDock(window.m_session, actions));
}

void MainWindow::makeDocks() {
    static const DockRow rows[] = {
        {kParametersDock, QT_TR_NOOP("Parameters"), Qt::RightDockWidgetArea, 0.0, &MainWindow::makeParameters},
        {kLevelsDock, QT_TR_NOOP("Levels"), Qt::RightDockWidgetArea, 0.0,
         [](MainWindow &window) -> QWidget * { return new LevelPanel(window.m_session); }},
        {kPlotsDock, QT_TR_NOOP("Plots"), Qt::BottomDockWidgetArea, 0.0, &MainWindow::makePlots},
        {"trade_dock", QT_TR_NOOP("Trade"), Qt::BottomDockWidgetArea, kTradeShare,
         [](MainWindow &window) -> QWidget * {
             return window.m_trade = new TradeDock(window.m_session, *window.m_undo);
         }},
        {kComparisonDock, QT_TR_NOOP("Comparison"), Qt::BottomDockWidgetArea, kComparisonShare,
         &MainWindow::makeComparison},
        {kBouncesDock, QT_TR_NOOP("Bounces"), Qt::BottomDockWidgetArea, kBouncesShare,
         [](MainWindow &window) -> QWidget * { return window.m_bounces = new BounceDock(window.m_session); }},
        {kTrackDock, QT_TR_NOOP("Measured ball"), Qt::BottomDockWidgetArea, kTrackShare,
         [](MainWindow &window) -> QWidget * {
             return window.m_track = new TrackDock(window.m_session, *window.m_undo);
         }},
        {"runs_dock", QT_TR_NOOP("Runs"), Qt::BottomDockWidgetArea, kComparisonShare,
         [](MainWindow &window) -> QWidget * { return window.refreshed(new RunDock(window.m_session)); }},
        {"watch_dock", QT_TR_NOOP("Watch"), Qt::RightDockWidgetArea, kComparisonShare,
         [](MainWindow &window) -> QWidget * { return window.refreshed(new WatchList(window.m_session)); }},
        {"ball_dock", QT_TR_NOOP("Ball"), Qt::RightDockWidgetArea, kComparisonShare,
         [](MainWindow &window) -> QWidget * {
             return window.refreshed(new BallDock(window.m_session, *window.m_undo));
         }},
    };
    int number = 0;
    QByteArray names;
    for (const DockRow &row : rows) {
        names += row.name;
        auto *dock = new QDockWidget(tr(row.title), this);
        dock->setObjectName(QLatin1String(row.name));
        giveTitleItsFont(*dock);
        QWidget *content = row.make(*this);
        dock->setWidget(row.share > 0.0 ? scrolled(content) : content);
        for (QWidget *part : {content, dock->widget()}) part->setAccessibleName(dock->windowTitle());
        addDockWidget(row.area, dock);
        addDockAction(*dock, ++number, row.share);
        if (row.share == 0.0) continue;
        m_onCall += dock;
        dock->hide();
    }
    m_layoutVersion = qChecksum(names);
    arrangeOnCall(rows);
}

/// Docks that are opened on demand are tabbed with the plots, except for the bounces, which are next to the plots so
/// that both are visible. The bounces must be placed first, because a dock with tabs can't be split.
void MainWindow::arrangeOnCall(std::span<const DockRow> rows) {
    const auto dockOf = [this](const char *name) { return findChild<QDockWidget *>(QLatin1String(name)); };
    splitDockWidget(dockOf(kPlotsDock), dockOf(kBouncesDock), Qt::Horizontal);
    for (const DockRow &row : rows)
        if (row.share > 0.0 && row.area == Qt::BottomDockWidgetArea && row.name != kBouncesDock)
            tabifyDockWidget(dockOf(kPlotsDock), dockOf(row.name));
}

/// The dock's key closes it if it is visible, and otherwise shows and raises it.
void MainWindow::addDockAction(QDockWidget &dock, int number, double share) {
    auto *toggle = new QAction(dock.windowTitle(), this);
    toggle->setObjectName(QStringLiteral("show_") + dock.objectName());
    toggle->setCheckable(true);
    if (number <= 10) toggle->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(number % 10)));
    const auto showState = [&dock, toggle] { toggle->setChecked(!dock.isHidden()); };
    connect(&dock, &QDockWidget::visibilityChanged, toggle, showState);
    connect(&dock, &QDockWidget::visibilityChanged, this, [this, &dock](bool isSeen) {
        if (!isSeen && dock.isAncestorOf(focusWidget())) m_view->setFocus(); // else behind another it would keep it
    });
    connect(dock.toggleViewAction(), &QAction::toggled, this, [this, &dock] {
        if (!dock.isHidden()) return;
        giveBackHeights(dockWidgetArea(&dock));
        m_view->setFocus(); // Qt gives it to what happens to be next
    });
    connect(toggle, &QAction::triggered, &dock, [this, &dock, share, showState] {
        const bool isSeen = dock.isVisible() && !dock.visibleRegion().isEmpty();
        if (isSeen)
            dock.close();
        else
            showDock(dock, share);
        if (!isSeen) giveKeyboard(*dock.widget());
        showState();
    });
    addAction(toggle); // so that it is listed with the others
}

void MainWindow::showDock(QDockWidget &dock, double share) {
    const bool isResized = share > 0.0 && dock.isHidden() && !dock.isFloating();
    const Qt::DockWidgetArea area = dockWidgetArea(&dock);
    if (isResized && docksOf(area, true).isEmpty()) {
        for (QDockWidget *other : docksOf(area, false)) m_heights[other] = other->height();
        m_roomBefore[area] = m_dockRoom->wanted(area);
    }
    const bool isBounces = dock.objectName() == QLatin1String(kBouncesDock);
    auto *plots = findChild<QDockWidget *>(QLatin1String(kPlotsDock));
    const bool hasRoomBeside = width() >= kRoomBesidePlots * fontMetrics().height();
    if (isResized && isBounces && !hasRoomBeside) tabifyDockWidget(plots, &dock);
    dock.show();
    dock.raise();
    if (!isResized) return;
    const bool isBelow = area == Qt::TopDockWidgetArea || area == Qt::BottomDockWidgetArea;
    const int least = isBelow ? kLeastBelow : kLeastHeight;
    const int wanted = std::min(int(share * height()), std::max(height() - kRestHeight, least));
    resizeDocks({&dock}, {wanted}, Qt::Vertical);
    if (isBelow) m_dockRoom->want(area, wanted);
    if (isBounces && hasRoomBeside) resizeDocks({&dock}, {int(kBouncesWidth * width())}, Qt::Horizontal);
}

/// Those that are open there: on demand, or from the start.
QList<QDockWidget *> MainWindow::docksOf(Qt::DockWidgetArea area, bool isOnCall) const {
    QList<QDockWidget *> docks = findChildren<QDockWidget *>();
    docks.removeIf([&](QDockWidget *dock) {
        return m_onCall.contains(dock) != isOnCall || dock->isHidden() || dock->isFloating() ||
               dockWidgetArea(dock) != area;
    });
    return docks;
}

/// Once the last dock opened on demand is closed, the others have their room from before.
void MainWindow::giveBackHeights(Qt::DockWidgetArea area) {
    if (!docksOf(area, true).isEmpty()) return;
    QList<QDockWidget *> docks;
    QList<int> heights;
    for (QDockWidget *dock : docksOf(area, false)) {
        if (!m_heights.contains(dock)) continue;
        docks += dock;
        heights += m_heights.take(dock);
    }
    resizeDocks(docks, heights, Qt::Vertical);
    if (const int room = m_roomBefore.take(area)) m_dockRoom->want(area, room);
}

/// Called when the window is shown, as tabs can't be raised before.
void MainWindow::showComparisonDock() {
    showDock(*findChild<QDockWidget *>(QLatin1String(kComparisonDock)), kComparisonShare);
}

void MainWindow::showBouncesDock() { showDock(*findChild<QDockWidget *>(QLatin1String(kBouncesDock)), kBouncesShare); }

bool MainWindow::openTrack(const QString &path, const QString &units) {
    showDock(*findChild<QDockWidget *>(QLatin1String(kTrackDock)), kTrackShare);
    return m_track->open(path, units);
}

/// Tab leaves out docks behind other ones.
bool MainWindow::focusNextPrevChild(bool isNext) {
    const auto isBehind = [this](const QWidget *widget) {
        while (widget && widget != this && !qobject_cast<const QDockWidget *>(widget)) widget = widget->parentWidget();
        return widget && widget != this && widget->visibleRegion().isEmpty();
    };
    const QWidget *first = focusWidget();
    do {
        if (!QMainWindow::focusNextPrevChild(isNext)) return false;
    } while (isBehind(focusWidget()) && focusWidget() != first);
    return true;
}

/// Tabs of docks are scrolled rather than cut.
void MainWindow::childEvent(QChildEvent *event) {
    QMainWindow::childEvent(event);
    auto *tabs = qobject_cast<QTabBar *>(event->child());
    if (tabs && event->type() == QEvent::ChildPolished) tabs->setElideMode(Qt::ElideNone);
}

void MainWindow::restoreLook() {
    const QSettings &settings = m_session.settings();
    const QSize available = roomFor(*this);
    resize(kUsualWindowSize.expandedTo(available * kWindowShare).boundedTo(available));
    arrangeDocks();
    m_firstLayout = saveState(m_layoutVersion);
    restoreGeometry(storedBytes(settings, settings_keys::kGeometry));
    fitScreen();
    restoreDocks();
    useQuality();
}

/// The screen may be smaller, or its pixels larger, than when the geometry was saved.
void MainWindow::fitScreen() {
    if (isMaximized() || isFullScreen()) return;
    resize(size().boundedTo(roomFor(*this)));
    const QRect available = screen()->availableGeometry();
    if (available.contains(geometry())) return;
    const QPoint last = available.bottomRight() - rect().bottomRight();
    // move() isn't suitable: before the window is shown, it would use the content's position for the frame.
    setGeometry({{std::clamp(x(), available.left(), std::max(available.left(), last.x())),
                  std::clamp(y(), available.top(), std::max(available.top(), last.y()))},
                 size()});
}

void MainWindow::resetLayout() {
    restoreState(m_firstLayout, m_layoutVersion);
    m_dockRoom->forget();
    arrangeDocks();
    m_plots->reset();
}

/// Gives most of the window to the view.
void MainWindow::arrangeDocks() {
    auto *parameters = findChild<QDockWidget *>(QLatin1String(kParametersDock));
    auto *levels = findChild<QDockWidget *>(QLatin1String(kLevelsDock));
    auto *plot = findChild<QDockWidget *>(QLatin1String(kPlotsDock));
    const int side = std::min(m_parameters->sizeHint().width(), int(kSideShare * width()));
    resizeDocks({parameters, levels}, {side, side}, Qt::Horizontal);
    resizeDocks({parameters, levels}, {m_parameters->sizeHint().height() + 30, 240}, Qt::Vertical);
    const int below = std::max(200, int(kPlotShare * height()));
    resizeDocks({plot}, {below}, Qt::Vertical);
    m_dockRoom->want(Qt::BottomDockWidgetArea, below);
}

/// Qt fits a layout that is restored earlier to a window of another size, and then to this one, which gives what was
/// saved to other docks.
void MainWindow::restoreDocks() {
    const QSettings &settings = m_session.settings();
    if (restoreState(storedBytes(settings, settings_keys::kLayout), m_layoutVersion))
        m_dockRoom->restore(settings.value(settings_keys::kDockRoom).toStringList());
}

/// The layout showed them before this window, which lies above them since; window managers keep above it what is
/// shown after it.
void MainWindow::bringFloatingDocksUp() {
    for (QDockWidget *dock : findChildren<QDockWidget *>()) {
        if (!dock->isFloating() || dock->isHidden()) continue;
        dock->hide();
        dock->show();
    }
}

void MainWindow::closeEvent(QCloseEvent *event) {
    QSettings &settings = m_session.settings();
    storeBytes(settings, settings_keys::kGeometry, saveGeometry());
    storeBytes(settings, settings_keys::kLayout, saveState(m_layoutVersion));
    settings.setValue(settings_keys::kDockRoom, m_dockRoom->stored());
    m_session.simulation().pause();
    QMainWindow::closeEvent(event);
}

} // namespace inspector::ui
