// SPDX-License-Identifier: MIT
// A small window, or a small screen: everything fits, and what is there can be read.
#include "gl/view/maze_view.h"
#include "window_fixture.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTabBar>
#include <QTreeWidget>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <qcustomplot.h>

using namespace window_test;

class TestWindowSmall : public WindowSuite {
    Q_OBJECT

private slots:
    void windowFitsASmallScreen_data();
    void windowFitsASmallScreen();
    void windowFitsAScreenOfLargePixels_data();
    void windowFitsAScreenOfLargePixels();
    void boardIsSeenInAWindowThatBecameSmall();
    void docksHaveTheirRoomBackInAWindowThatGrows_data();
    void docksHaveTheirRoomBackInAWindowThatGrows();
    void dockOpenedInASmallWindowGrowsWithIt();
    void windowClosedWhileSmallStillGivesTheRoomBack();
    void chosenRoomIsKept_data();
    void chosenRoomIsKept();
    void lowPlotIsReadable();
    void tabsOfDocksAreWhole();
    void messageHasItsRoom();
    void dockBesideTheBouncesIsWhole_data();
    void dockBesideTheBouncesIsWhole();
    void legendIsWholeInANarrowPlot();
    void legendOfANarrowComparisonIsOneLine();
    void largerTextLeavesNumbersWhole();
    void doubleTextLeavesTheChoosersWhole();
    void doubleTextPutsBouncesBehindThePlots();
    void titlesOfDocksFollowTheTextSize();
    void rowsOfListsAreHigherThanTheirText();
    void legendOfALowPlotIsWhole();
    void legendLeavesASmallPlotToItsCurves();
    void hintIsWholeInAPlotThatBecameNarrow();
    void plotBehindAnotherDockIsDrawnOnceItIsSeen();
    void resultNamesItsLevel();
    void resultSaysItsReasonWhole_data();
    void resultSaysItsReasonWhole();
    void closedResultSaysAllOfIt();
    void everyFieldOfTheStatusIsWhole();
};

void TestWindowSmall::windowFitsASmallScreen_data() {
    QTest::addColumn<QString>("dock");
    QTest::newRow("at first") << "";
    for (const char *name : {"trade", "comparison", "bounces", "track", "runs", "watch", "ball"})
        QTest::newRow(name) << QStringLiteral("%1_dock").arg(QLatin1String(name));
}

// With everything that the time bar can show.
void TestWindowSmall::windowFitsASmallScreen() {
    QFETCH(QString, dock);
    inspector::ui::MainWindow &window = m_fixture->window();
    m_fixture->session().startRecording(m_fixture->path("run.rec"));
    m_fixture->trigger("step");
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(1));
    m_fixture->session().lookAt(0);
    QTRY_VERIFY(m_fixture->find<QWidget>("time_bar_go_on")->isVisible());
    QTRY_VERIFY(m_fixture->find<QWidget>("time_recording")->isVisible());
    window.resize(800, 600);
    QTRY_COMPARE(window.size(), QSize(800, 600));
    if (!dock.isEmpty()) m_fixture->trigger("show_" + dock);
    const auto fits = [&] {
        const QSize least = window.minimumSizeHint();
        return least.width() <= 800 && least.height() <= 600 && window.size() == QSize(800, 600);
    };
    QTRY_VERIFY2(fits(), qPrintable(QStringLiteral("%1 x %2, at least %3 x %4")
                                        .arg(window.width())
                                        .arg(window.height())
                                        .arg(window.minimumSizeHint().width())
                                        .arg(window.minimumSizeHint().height())));
    QVERIFY(window.view().height() >= 150);
}

void TestWindowSmall::windowFitsAScreenOfLargePixels_data() { windowFitsASmallScreen_data(); }

// 1280 x 800 at a scale of 2 are 640 x 400, of which a window manager's frame takes some.
void TestWindowSmall::windowFitsAScreenOfLargePixels() {
    QFETCH(QString, dock);
    inspector::ui::MainWindow &window = m_fixture->window();
    window.resize(640, 360);
    if (!dock.isEmpty()) m_fixture->trigger("show_" + dock);
    const auto least = [&] { return window.minimumSizeHint(); };
    QTRY_VERIFY2(least().width() <= 640 && least().height() <= 360,
                 qPrintable(QStringLiteral("%1 x %2").arg(least().width()).arg(least().height())));
    QTRY_COMPARE(window.size(), QSize(640, 360));
}

// Its docks had more room before.
void TestWindowSmall::boardIsSeenInAWindowThatBecameSmall() {
    m_fixture->window().resize(1200, 1000);
    m_fixture->trigger("show_trade_dock");
    const auto *dock = m_fixture->find<QDockWidget>("trade_dock");
    QTRY_VERIFY(dock->height() > 400);
    m_fixture->window().resize(800, 600);
    QTRY_COMPARE(m_fixture->window().size(), QSize(800, 600));
    QTRY_VERIFY2(m_fixture->window().view().height() >= 150,
                 qPrintable(QString::number(m_fixture->window().view().height())));
}

void TestWindowSmall::docksHaveTheirRoomBackInAWindowThatGrows_data() {
    QTest::addColumn<QStringList>("opened");
    QTest::addColumn<int>("height");
    QTest::newRow("at first") << QStringList() << 231;             // 0.29 of 800
    QTest::newRow("one") << QStringList{"comparison_dock"} << 246; // 0.34, of which the tabs take 26
    QTest::newRow("beside each other") << QStringList{"comparison_dock", "bounces_dock"} << 336; // 0.42
}

// Through every size between, as by dragging its edge.
void TestWindowSmall::docksHaveTheirRoomBackInAWindowThatGrows() {
    QFETCH(QStringList, opened);
    QFETCH(int, height);
    inspector::ui::MainWindow &window = m_fixture->window();
    for (const QString &name : opened) m_fixture->trigger("show_" + name);
    const auto *below = m_fixture->find<QDockWidget>(opened.isEmpty() ? "plot_dock" : opened.last());
    const auto *beside = m_fixture->find<QDockWidget>("parameters_dock");
    QTRY_COMPARE(below->height(), height);
    const int width = beside->width();
    for (const QSize to : {QSize(640, 400), QSize(1200, 800)}) {
        const QSize from = window.size();
        for (int i = 1; i <= 10; ++i) {
            window.resize(from + (to - from) * i / 10);
            QApplication::processEvents();
        }
        QTRY_COMPARE(window.size(), to);
        QTRY_COMPARE(beside->width() == width && below->height() == height, to.width() == 1200);
    }
}

void TestWindowSmall::dockOpenedInASmallWindowGrowsWithIt() {
    inspector::ui::MainWindow &window = m_fixture->window();
    window.resize(640, 464);
    m_fixture->trigger("show_trade_dock");
    const auto *dock = m_fixture->find<QDockWidget>("trade_dock");
    QTRY_VERIFY(dock->height() < 140 && window.view().height() >= 150);
    window.resize(1200, 800);
    QTRY_COMPARE(dock->height(), 204);     // 230, of which the tabs take 26
    m_fixture->trigger("show_trade_dock"); // closes it
    const auto *plots = m_fixture->find<QDockWidget>("plot_dock");
    QTRY_COMPARE(plots->height(), 231);
}

void TestWindowSmall::windowClosedWhileSmallStillGivesTheRoomBack() {
    const auto height = [this] { return m_fixture->find<QDockWidget>("plot_dock")->height(); };
    QTRY_COMPARE(height(), 231);
    m_fixture->window().resize(640, 464);
    QTRY_VERIFY(height() < 200);
    m_fixture->reopen();
    QVERIFY(m_fixture->isReady());
    QTRY_VERIFY(height() < 200);
    m_fixture->window().resize(1200, 800);
    QTRY_COMPARE(height(), 231);
}

void TestWindowSmall::chosenRoomIsKept_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QPoint>("separator"); // beside the dock's upper left corner
    QTest::addColumn<QPoint>("way");
    QTest::newRow("below") << "plot_dock" << QPoint(100, -2) << QPoint(0, -90);
    QTest::newRow("at the side") << "parameters_dock" << QPoint(-2, 50) << QPoint(-70, 0);
}

void TestWindowSmall::chosenRoomIsKept() {
    QFETCH(QString, name);
    QFETCH(QPoint, separator);
    QFETCH(QPoint, way);
    inspector::ui::MainWindow &window = m_fixture->window();
    const auto *dock = m_fixture->find<QDockWidget>(name);
    const auto room = [&] { return way.x() ? dock->width() : dock->height(); };
    const int wanted = room() - way.x() - way.y();
    const QPoint from = dock->geometry().topLeft() + separator;
    QTest::mousePress(&window, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + way, window.mapToGlobal(from + way), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &move);
    QTRY_COMPARE(room(), wanted);
    QTest::mouseRelease(&window, Qt::LeftButton, {}, from + way);
    window.resize(640, 400);
    QTRY_VERIFY(room() < wanted);
    window.resize(1200, 800);
    QTRY_COMPARE(room(), wanted);
}

void TestWindowSmall::lowPlotIsReadable() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    m_fixture->window().resize(560, 370);
    QTRY_VERIFY(plot->height() < 120);
    const auto areValuesApart = [&] {
        m_fixture->window().refresh();
        plot->replot();
        double last = std::numeric_limits<double>::infinity();
        for (const double tick : plot->yAxis->tickVector()) {
            if (!plot->yAxis->range().contains(tick)) continue;
            const double place = plot->yAxis->coordToPixel(tick);
            if (last - place < plot->fontMetrics().capHeight()) return false;
            last = place;
        }
        return std::isfinite(last);
    };
    QTRY_VERIFY2(areValuesApart(), qPrintable(QString::number(plot->axisRect()->height())));
    QVERIFY(plot->rect().contains(plot->legend->rect()));
    QVERIFY(plot->legend->outerRect().height() >= plot->legend->minimumOuterSizeHint().height());
}

void TestWindowSmall::tabsOfDocksAreWhole() {
    m_fixture->window().resize(800, 600);
    for (const char *name : {"trade", "comparison", "bounces", "track", "runs"})
        m_fixture->trigger(QStringLiteral("show_%1_dock").arg(QLatin1String(name)));
    const auto whole = [&] {
        int tabs = 0;
        for (const QTabBar *bar : m_fixture->window().findChildren<QTabBar *>()) {
            if (!bar->isVisible()) continue;
            for (int i = 0; i < bar->count(); ++i)
                tabs += bar->tabRect(i).width() >= bar->fontMetrics().horizontalAdvance(bar->tabText(i)) ? 1 : -100;
        }
        return tabs;
    };
    QTRY_COMPARE(whole(), 6);
}

// In the status line.
void TestWindowSmall::messageHasItsRoom() {
    m_fixture->window().resize(800, 600);
    auto *line = m_fixture->window().statusBar();
    line->showMessage(QString(60, 'n'));
    const int end = line->fontMetrics().horizontalAdvance(line->currentMessage());
    const auto fields = [&] { // that are shown, or -1 if one hides the message
        m_fixture->window().refresh();
        int count = 0;
        for (const QLabel *field : line->findChildren<QLabel *>()) {
            if (!field->isVisible()) continue;
            if (field->x() < end) return -1;
            ++count;
        }
        return count;
    };
    QTRY_VERIFY2(fields() >= 1, qPrintable(QString::number(fields())));
    line->clearMessage();
    QTRY_COMPARE(fields(), -1);
}

void TestWindowSmall::dockBesideTheBouncesIsWhole_data() {
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QSize>("size");
    for (const char *name : {"trade_dock", "comparison_dock", "track_dock"})
        for (const QSize size : {QSize(1280, 800), QSize(800, 600)})
            QTest::addRow("%s at %d", name, size.width()) << name << size;
}

// From side to side.
void TestWindowSmall::dockBesideTheBouncesIsWhole() {
    QFETCH(QString, dock);
    QFETCH(QSize, size);
    m_fixture->window().resize(size);
    m_fixture->trigger("show_bounces_dock");
    m_fixture->trigger("show_" + dock);
    const auto *area = qobject_cast<QScrollArea *>(m_fixture->find<QDockWidget>(dock)->widget());
    QVERIFY(area);
    QTRY_VERIFY(area->isVisible());
    QTRY_COMPARE(area->horizontalScrollBar()->maximum(), 0);
}

void TestWindowSmall::legendIsWholeInANarrowPlot() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    m_fixture->window().resize(800, 600);
    m_fixture->window().refresh(); // fits the docks to it, before they get another width
    const QList<QDockWidget *> side{m_fixture->find<QDockWidget>("parameters_dock"),
                                    m_fixture->find<QDockWidget>("levels_dock")};
    m_fixture->window().resizeDocks(side, {430, 430}, Qt::Horizontal);
    const auto isWhole = [&] {
        m_fixture->window().refresh();
        plot->replot();
        for (int cell = 0; cell < plot->legend->elementCount(); ++cell) {
            const QCPLayoutElement *entry = plot->legend->elementAt(cell);
            if (!entry) continue;
            const bool hasRoom = entry->rect().width() >= entry->minimumOuterSizeHint().width();
            if (!hasRoom || !plot->rect().contains(entry->rect())) return false;
        }
        return true;
    };
    QTRY_VERIFY(plot->width() < 400);
    QTRY_VERIFY(isWhole());
    QVERIFY(plot->legend->rowCount() <= 2);
}

void TestWindowSmall::legendOfANarrowComparisonIsOneLine() {
    m_fixture->trigger("show_comparison_dock");
    m_fixture->trigger("compare");
    m_fixture->makeSteps(20);
    auto *plot = m_fixture->find<QCustomPlot>("distance_plot");
    QTRY_VERIFY(plot->isVisible());
    plot->setFixedWidth(450);
    QTRY_COMPARE(plot->width(), 450);
    m_fixture->window().refresh();
    QCOMPARE(plot->legend->rowCount(), 1);
}

void TestWindowSmall::largerTextLeavesNumbersWhole() {
    const auto *box = m_fixture->find<QLineEdit>("gravity_box");
    const int before = box->fontMetrics().height();
    const auto isWhole = [&] {
        return box->fontMetrics().height() > before && box->fontMetrics().horizontalAdvance(box->text()) < box->width();
    };
    m_fixture->trigger("text_size_3");
    QTRY_VERIFY2(isWhole(), qPrintable(QString::number(box->width())));
    m_fixture->trigger("text_size_0");
    QTRY_COMPARE(box->fontMetrics().height(), before);
}

// On a projector of 1024 x 768.
void TestWindowSmall::doubleTextLeavesTheChoosersWhole() {
    m_fixture->trigger("text_size_3");
    m_fixture->window().resize(1022, 700);
    const auto *stepper = m_fixture->find<QComboBox>("stepper");
    const auto *timeStep = m_fixture->find<QLineEdit>("time_step_box");
    QTRY_COMPARE(m_fixture->window().width(), 1022);
    QTRY_VERIFY2(stepper->isVisible() && stepper->width() >= stepper->sizeHint().width(),
                 qPrintable(QStringLiteral("%1 of %2").arg(stepper->width()).arg(stepper->sizeHint().width())));
    QVERIFY(timeStep->isVisible()); // in the bar, not behind its arrow
    QVERIFY2(timeStep->width() > timeStep->fontMetrics().horizontalAdvance(timeStep->text()),
             qPrintable(QString::number(timeStep->width())));
}

void TestWindowSmall::doubleTextPutsBouncesBehindThePlots() {
    m_fixture->trigger("text_size_3");
    QApplication::processEvents();
    m_fixture->press(Qt::Key_6, Qt::ControlModifier);
    QTRY_VERIFY(!m_fixture->find<QWidget>("bounces")->visibleRegion().isEmpty());
    QVERIFY(m_fixture->find<QWidget>("velocity_plot")->visibleRegion().isEmpty());
}

void TestWindowSmall::titlesOfDocksFollowTheTextSize() {
    auto *dock = m_fixture->find<QDockWidget>("levels_dock");
    const QImage before = dock->grab().toImage().copy(0, 0, 100, dock->widget()->y());
    m_fixture->trigger("text_size_2");
    QTRY_VERIFY(dock->widget()->y() > before.height());
    const auto darkPixels = [](const QImage &title) {
        int count = 0;
        for (int y = 0; y < title.height(); ++y)
            for (int x = 0; x < title.width(); ++x) count += qGray(title.pixel(x, y)) < 100 ? 1 : 0;
        return count;
    };
    const QImage after = dock->grab().toImage().copy(0, 0, 100, dock->widget()->y());
    m_fixture->trigger("text_size_0");
    QVERIFY2(4 * darkPixels(after) > 5 * darkPixels(before), qPrintable(QString::number(darkPixels(after))));
}

void TestWindowSmall::rowsOfListsAreHigherThanTheirText() {
    m_fixture->trigger("show_watch_dock");
    const auto *list = m_fixture->find<QTreeWidget>("watched");
    const int height = list->visualItemRect(list->topLevelItem(0)).height();
    QVERIFY2(3 * height >= 4 * list->fontMetrics().height(), qPrintable(QString::number(height)));
}

// In one line and in two.
void TestWindowSmall::legendOfALowPlotIsWhole() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    QSet<int> lines;
    for (const int width : {700, 180}) {
        plot->setFixedWidth(width);
        QTRY_COMPARE(plot->width(), width);
        m_fixture->window().refresh();
        m_fixture->window().resizeDocks({m_fixture->find<QDockWidget>("plot_dock")}, {10}, Qt::Vertical);
        const auto isWhole = [&] {
            m_fixture->window().refresh();
            plot->replot();
            return plot->legend->minimumOuterSizeHint().height() <= plot->legend->outerRect().height() &&
                   plot->axisRect()->height() >= 2 * plot->fontMetrics().height();
        };
        QTRY_VERIFY2(isWhole(), qPrintable(QString::number(plot->height())));
        lines += plot->legend->rowCount();
    }
    QCOMPARE(lines.size(), 2);
}

// As on a screen of large pixels.
void TestWindowSmall::legendLeavesASmallPlotToItsCurves() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    const auto roomOfEntry = [&] { // that it asks for
        m_fixture->window().refresh();
        plot->replot();
        return plot->legend->elementAt(0)->minimumOuterSizeHint().width();
    };
    const int usual = roomOfEntry();
    m_fixture->window().resize(640, 376);
    QTRY_VERIFY(plot->width() < 320);
    QTRY_VERIFY2(roomOfEntry() < usual, qPrintable(QString::number(usual)));
}

// Nothing else draws a plot anew while the ball rests.
void TestWindowSmall::hintIsWholeInAPlotThatBecameNarrow() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    const auto *text = plot->findChild<QCPTextElement *>("read_out");
    bool wasThere = false;
    for (int width = 1240; width >= 900; width -= 20) {
        m_fixture->window().resize(width, 800);
        QTRY_COMPARE(m_fixture->window().width(), width);
        QApplication::processEvents(); // which lays the docks out
        m_fixture->window().refresh();
        plot->replot();
        wasThere = wasThere || !text->text().isEmpty();
        QVERIFY2(text->text().isEmpty() || isReadOutWhole(plot), qPrintable(QString::number(width)));
    }
    QVERIFY(wasThere && text->text().isEmpty());
}

void TestWindowSmall::plotBehindAnotherDockIsDrawnOnceItIsSeen() {
    const auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    m_fixture->trigger("show_runs_dock");
    QTRY_VERIFY(plot->visibleRegion().isEmpty());
    QApplication::processEvents();
    const QSignalSpy drawn(plot, &QCustomPlot::afterReplot);
    m_fixture->makeSteps(5);
    m_fixture->window().refresh();
    QApplication::processEvents();
    QCOMPARE(drawn.count(), 0);
    m_fixture->find<QDockWidget>("plot_dock")->raise();
    QTRY_VERIFY(drawn.count() > 0);
    QTRY_VERIFY(plot->graph(0)->dataCount() > 0);
}

void TestWindowSmall::resultNamesItsLevel() {
    m_fixture->window().resize(800, 600);
    m_fixture->session().setSpeed(inspector::Simulation::kFastest);
    m_fixture->session().setAutopilot(true);
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->game().phase(), inspector::Game::Phase::Won);
    const auto isWhole = [this] {
        for (const QLabel *label : m_fixture->find<QWidget>("game_strip")->findChildren<QLabel *>())
            if (label->text() == QLatin1String("Level 1 done"))
                return label->width() >= label->fontMetrics().horizontalAdvance(label->text());
        return false;
    };
    QTRY_VERIFY(isWhole());
}

void TestWindowSmall::resultSaysItsReasonWhole_data() {
    QTest::addColumn<std::function<void(inspector::Session &)>>("prepare");
    const auto row = [](const char *name, const std::function<void(inspector::Session &)> &prepare) {
        QTest::newRow(name) << prepare;
    };
    row("autopilot", [](inspector::Session &session) { session.setAutopilot(true); });
    row("placed", [](inspector::Session &session) {
        session.setStart(session.simulation().latest().current); // where it is put by hand
    });
    row("speed", [](inspector::Session &session) { session.setSpeed(inspector::Simulation::kFastest); });
}

void TestWindowSmall::resultSaysItsReasonWhole() {
    QFETCH(std::function<void(inspector::Session &)>, prepare);
    m_fixture->window().resize(800, 600);
    prepare(m_fixture->session());
    m_fixture->press(Qt::Key_Return);
    m_fixture->game().leaveMaze(599.99, !m_fixture->session().whyNoBestTime().isEmpty());
    m_fixture->window().refresh();
    const QString reason = "no best time: " + m_fixture->session().whyNoBestTime();
    const auto isWhole = [&] {
        for (const QLabel *label : m_fixture->find<QWidget>("game_strip")->findChildren<QLabel *>())
            if (label->text() == reason)
                return label->contentsRect().width() >= label->fontMetrics().horizontalAdvance(reason);
        return false;
    };
    QTRY_VERIFY2(isWhole(), qPrintable(reason));
    QVERIFY(m_fixture->window().view().height() >= 150);
}

// At the place of its title.
void TestWindowSmall::closedResultSaysAllOfIt() {
    m_fixture->session().setAutopilot(true);
    m_fixture->press(Qt::Key_Return);
    m_fixture->game().leaveMaze(2.0, true);
    m_fixture->window().refresh();
    const auto first = [this] {
        for (const QLabel *label : m_fixture->find<QWidget>("game_strip")->findChildren<QLabel *>())
            if (label->isVisible()) return std::pair(label->text(), label->mapTo(&m_fixture->window(), QPoint()).x());
        return std::pair(QString(), -1);
    };
    QTRY_COMPARE(first().first, QString("Level 1 done"));
    const int left = first().second;
    m_fixture->press(Qt::Key_Escape);
    QTRY_COMPARE(first(), std::pair(QString::fromUtf8("Level 1 done · no best time: the autopilot played · "
                                                      "Enter: Level 2 · R: again"),
                                    left));
}

// With a ghost, in a run that has left the maze.
void TestWindowSmall::everyFieldOfTheStatusIsWhole() {
    m_fixture->window().resize(800, 600);
    m_fixture->trigger("compare");
    phys_state state = m_fixture->simulation().latest().current;
    state.position.x = 1.0;
    m_fixture->simulation().setState(state);
    m_fixture->trigger("step");
    QTRY_VERIFY(m_fixture->simulation().latest().current.flags & PHYS_OUT);
    const auto cut = [this] {
        m_fixture->window().refresh();
        QStringList texts;
        for (const QLabel *field : m_fixture->window().statusBar()->findChildren<QLabel *>())
            if (field->isVisible() &&
                field->contentsRect().width() < field->fontMetrics().horizontalAdvance(field->text()))
                texts << field->text();
        return texts.join(' ');
    };
    QTRY_COMPARE(cut(), QString());
    QVERIFY(m_fixture->find<QLabel>("status_ball")->isVisible());
    QVERIFY(m_fixture->find<QLabel>("status_tilt")->isVisible());
}

QTEST_MAIN(TestWindowSmall)
#include "tst_window_small.moc"
