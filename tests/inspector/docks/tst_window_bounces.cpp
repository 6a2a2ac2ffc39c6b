// SPDX-License-Identifier: MIT
// Bounces: marks in the view, rows in the dock, ticks in the plot, and the selected one.
#include "gl/view/maze_view.h"
#include "inspector/stepping.h"
#include "ui/bounces/bounce_dock.h"
#include "ui/plots/bounce_ticks.h"
#include "ui/plots/time_plot.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineF>
#include <QMimeData>
#include <QScrollBar>
#include <QTableView>

#include <algorithm>
#include <cmath>

using namespace window_test;
using inspector::LoggedEvent;

class TestWindowBounces : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void everyEntryOfTheLogIsARow();
    void clickOnAMarkSelectsItsRow();
    void clickOnAMarkShowsTheDock();
    void clickOnARowSelectsItsMark();
    void clickOnNothingLetsGo();
    void dragOfTheCameraSelectsNothing();
    void markBehindAWallIsNotClicked();
    void marksGoAndComeByTheirKey();
    void choiceOfMarksIsRemembered();
    void hiddenMarksAreNotClicked();
    void escInTheListLetsGo();
    void escLetsGoWhenAllStandsStill();
    void arrowKeysMoveThroughTheList();
    void arrowKeysAreTheGamesWhileItRuns();
    void copiedRowsAreATable();
    void slowImpactsAreLeftOutOnRequest();
    void choiceOfRowsIsRemembered();
    void otherEventsAreLeftOutOnRequest();
    void listFollowsTheNewestRow();
    void listStaysWhereItIsWhileARowIsSelected();
    void selectionStaysOnItsEventWhileRowsCome();
    void restartEmptiesTheList();
    void selectionComesBackWithItsEvent();
    void plotHasATickForEachBounce();
    void selectedBounceIsMarkedInThePlot();
    void clickOnATickSelectsItsBounce();
    void lostEventsAreTold();
    void detailHasTheLawWithItsNumbers();
    void detailIsWrappedBesideAnotherDock();
    void listBesideThePlotsHasRoom();

private:
    void makeSteps(int count);
    void play(int seconds);
    QPoint pixelOf(const LoggedEvent &event) const;
    std::vector<LoggedEvent> lonelyMarks() const;
    void clickAt(const QPoint &place) { QTest::mouseClick(m_view, Qt::LeftButton, {}, place); }
    QPoint emptyPlace() const;
    QPoint rowPlace(int row) const { return m_table->visualRect(m_table->model()->index(row, 1)).center(); }
    QString cell(int row, int column) const { return m_table->model()->index(row, column).data().toString(); }
    int rows() const { return m_table->model()->rowCount(); }
    void showDock();

    inspector::gl::MazeView *m_view = nullptr;
    inspector::ui::BounceDock *m_bounces = nullptr;
    QTableView *m_table = nullptr;
};

void TestWindowBounces::init() {
    QVERIFY(open(3, solidIn({"clickOnARowSelectsItsMark", "markBehindAWallIsNotClicked", "marksGoAndComeByTheirKey"})));
    m_view = &m_fixture->window().view();
    m_bounces = m_fixture->find<inspector::ui::BounceDock>("bounces");
    m_table = m_fixture->find<QTableView>("bounces_table");
}

// Stepped manually, so that every run has the same bounces.
void TestWindowBounces::makeSteps(int count) {
    const uint64_t end = m_fixture->simulation().latest().current.step + uint64_t(count);
    for (int i = 0; i < count; ++i) m_fixture->simulation().stepOnce();
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, end);
    m_fixture->window().refresh();
}

// Back and forth, so that the ball hits many walls; then a picture with the current marks.
void TestWindowBounces::play(int seconds) {
    const double tilts[][2] = {{6.0, 4.0}, {-7.0, 3.0}, {5.0, -8.0}, {-6.0, -6.0}, {8.0, 2.0}, {-3.0, 8.0}};
    for (int second = 0; second < seconds; ++second) {
        const double *tilt = tilts[second % 6];
        m_fixture->parameters().set({{"tilt_x", tilt[0]}, {"tilt_y", tilt[1]}});
        makeSteps(100);
    }
    m_fixture->parameters().set({{"tilt_x", 0.0}, {"tilt_y", 0.0}});
    QTRY_COMPARE(m_fixture->simulation().latest().inputs.tilt.x, 0.0);
    m_view->grabFramebuffer();
    QVERIFY(m_bounces->marks().recent.size() > 3);
}

QPoint TestWindowBounces::pixelOf(const LoggedEvent &event) const {
    const phys_vec3 &point = event.event.point;
    return m_view->positionOf({point.x, point.y, point.z}).toPoint();
}

// In the picture, and far enough from other marks that a click is unambiguous.
std::vector<LoggedEvent> TestWindowBounces::lonelyMarks() const {
    const std::vector<LoggedEvent> &marks = m_bounces->marks().recent;
    std::vector<LoggedEvent> lonely;
    for (const LoggedEvent &mark : marks) {
        const auto isNear = [&](const LoggedEvent &other) {
            return other.number != mark.number && QLineF(pixelOf(other), pixelOf(mark)).length() < 60.0;
        };
        // A wall's front can hide a mark on its back; marks on faces to the front and sides are visible.
        const bool isSeen = mark.event.normal.y < 0.5;
        if (isSeen && std::none_of(marks.begin(), marks.end(), isNear)) lonely.push_back(mark);
    }
    return lonely;
}

QPoint TestWindowBounces::emptyPlace() const { return {4, m_view->height() - 4}; }

void TestWindowBounces::showDock() {
    m_fixture->press(Qt::Key_6, Qt::ControlModifier);
    const auto *dock = m_fixture->find<QDockWidget>("bounces_dock");
    QTRY_VERIFY(m_table->isVisible() && dock->height() > m_fixture->window().height() / 3);
    m_view->grabFramebuffer(); // the camera shows everything in what is left
}

void TestWindowBounces::everyEntryOfTheLogIsARow() {
    play(3);
    const inspector::EventLog &log = m_fixture->simulation().events();
    QCOMPARE(uint64_t(rows()), log.last() - log.first());
    LoggedEvent entry;
    QVERIFY(log.read(log.first(), entry));
    QCOMPARE(cell(0, 0), QString::number(entry.event.time, 'f', 4));
    for (int column = 0; column < m_table->model()->columnCount(); ++column)
        QVERIFY(!m_table->model()->headerData(column, Qt::Horizontal).toString().isEmpty());
}

void TestWindowBounces::clickOnAMarkSelectsItsRow() {
    play(3);
    const std::vector<LoggedEvent> marks = lonelyMarks();
    QVERIFY(!marks.empty());
    for (const LoggedEvent &mark : marks) {
        m_view->grabFramebuffer(); // the dock has come with the first click
        clickAt(pixelOf(mark));
        QVERIFY(m_bounces->selected().has_value());
        QCOMPARE(m_bounces->selected()->number, mark.number);
        const int row = m_table->currentIndex().row();
        QCOMPARE(m_table->selectionModel()->selectedRows().size(), 1);
        QCOMPARE(cell(row, 0), QString::number(mark.event.time, 'f', 4));
    }
}

void TestWindowBounces::clickOnAMarkShowsTheDock() {
    play(3);
    auto *dock = m_fixture->find<QDockWidget>("bounces_dock");
    QVERIFY(!dock->isVisible());
    clickAt(pixelOf(lonelyMarks().front()));
    QTRY_VERIFY(dock->isVisible() && m_table->isVisible());
}

void TestWindowBounces::clickOnARowSelectsItsMark() {
    play(3);
    showDock();
    const QImage before = m_view->grabFramebuffer();
    m_table->scrollToTop();
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, rowPlace(1));
    QVERIFY(m_bounces->marks().selected.has_value());
    QCOMPARE(QString::number(m_bounces->marks().selected->event.time, 'f', 4), cell(1, 0));
    QVERIFY(m_view->grabFramebuffer() != before); // its box is outlined
}

void TestWindowBounces::clickOnNothingLetsGo() {
    play(3);
    clickAt(pixelOf(lonelyMarks().front()));
    QVERIFY(m_bounces->selected());
    clickAt(emptyPlace());
    QVERIFY(!m_bounces->selected());
    QVERIFY(!m_table->selectionModel()->hasSelection());
}

void TestWindowBounces::dragOfTheCameraSelectsNothing() {
    play(3);
    const QPoint mark = pixelOf(lonelyMarks().front());
    drag(m_view, mark - QPoint(120, 0), mark);
    QVERIFY(!m_bounces->selected());
}

// From the front and almost level, the front wall hides what lies close behind it.
void TestWindowBounces::markBehindAWallIsNotClicked() {
    play(3);
    const std::vector<LoggedEvent> &marks = m_bounces->marks().recent;
    const auto isAtTheFront = [](const LoggedEvent &mark) { return mark.event.normal.y == 1.0; };
    const auto front = std::min_element(marks.begin(), marks.end(), [&](const auto &a, const auto &b) {
        return std::pair(!isAtTheFront(a), a.event.point.y) < std::pair(!isAtTheFront(b), b.event.point.y);
    });
    QVERIFY(isAtTheFront(*front));
    m_view->camera().orbit({0.0, -1e4}); // as far as it goes
    m_view->grabFramebuffer();
    const uint64_t number = front->number;
    clickAt(pixelOf(*front));
    QVERIFY(!m_bounces->selected() || m_bounces->selected()->number != number);
    m_view->camera().orbit({0.0, 1e4}); // from above nothing hides it
    m_view->grabFramebuffer();
    m_bounces->clearSelection();
    clickAt(pixelOf(*front) - QPoint(0, 3));
    QVERIFY(m_bounces->selected());
}

void TestWindowBounces::marksGoAndComeByTheirKey() {
    play(3);
    const QImage with = m_view->grabFramebuffer();
    m_fixture->press(Qt::Key_B);
    const QImage without = m_view->grabFramebuffer();
    QVERIFY(with != without);
    m_fixture->press(Qt::Key_B);
    QVERIFY(m_view->grabFramebuffer() == with);
}

void TestWindowBounces::choiceOfMarksIsRemembered() {
    m_fixture->press(Qt::Key_B);
    QVERIFY(!m_fixture->find<QAction>("bounces")->isChecked());
    m_fixture->reopen();
    QVERIFY(!m_fixture->find<QAction>("bounces")->isChecked());
}

void TestWindowBounces::hiddenMarksAreNotClicked() {
    play(3);
    const QPoint place = pixelOf(lonelyMarks().front());
    m_fixture->press(Qt::Key_B);
    clickAt(place);
    QVERIFY(!m_bounces->selected());
}

void TestWindowBounces::escInTheListLetsGo() {
    play(3);
    showDock();
    m_table->scrollToTop();
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, rowPlace(0));
    QVERIFY(m_bounces->selected());
    m_fixture->simulation().run();
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    QTest::keyClick(m_table, Qt::Key_Escape);
    QVERIFY(!m_bounces->selected());
    QVERIFY(m_fixture->simulation().latest().running); // the key was the list's
    QTest::keyClick(m_table, Qt::Key_Escape);          // and is the window's again
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
}

void TestWindowBounces::escLetsGoWhenAllStandsStill() {
    play(3);
    clickAt(pixelOf(lonelyMarks().front()));
    QVERIFY(m_bounces->selected());
    QTest::keyClick(m_view, Qt::Key_Escape);
    QVERIFY(!m_bounces->selected());
}

void TestWindowBounces::arrowKeysMoveThroughTheList() {
    play(3);
    showDock();
    QVERIFY(m_table->hasFocus());
    m_table->scrollToTop();
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, rowPlace(1));
    const uint64_t first = m_bounces->selected()->number;
    QTest::keyClick(m_table, Qt::Key_Down);
    QCOMPARE(m_bounces->selected()->number, first + 1);
    QTest::keyClick(m_table, Qt::Key_Up);
    QTest::keyClick(m_table, Qt::Key_Up);
    QCOMPARE(m_bounces->selected()->number, first - 1);
    QCOMPARE(m_fixture->simulated("tilt_y"), 0.0); // the key didn't reach the board
}

void TestWindowBounces::arrowKeysAreTheGamesWhileItRuns() {
    play(3);
    showDock();
    m_fixture->press(Qt::Key_Return); // the game starts
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    m_table->setFocus();
    QTest::keyPress(m_table, Qt::Key_Right);
    QTRY_VERIFY(m_fixture->simulated("tilt_x") > 0.0);
    QTest::keyRelease(m_table, Qt::Key_Right);
}

void TestWindowBounces::copiedRowsAreATable() {
    play(3);
    showDock();
    m_table->scrollToTop();
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, rowPlace(0));
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ShiftModifier, rowPlace(2));
    QTest::keyClick(m_table, Qt::Key_C, Qt::ControlModifier);
    const QMimeData *copied = QGuiApplication::clipboard()->mimeData();
    const QStringList lines = copied->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 4); // a header and three rows
    LoggedEvent entry;
    const inspector::EventLog &log = m_fixture->simulation().events();
    for (int row = 0; row < 3; ++row) {
        QVERIFY(log.read(log.first() + uint64_t(row), entry));
        const QStringList cells = lines[row + 1].split(QLatin1Char('\t'));
        QCOMPARE(cells[int(lines[0].split(QLatin1Char('\t')).indexOf("time [s]"))].toDouble(), entry.event.time);
    }
    QByteArray csv = copied->data(QStringLiteral("text/csv"));
    QCOMPARE(csv.replace(',', '\t'), copied->text().toUtf8());
}

void TestWindowBounces::slowImpactsAreLeftOutOnRequest() {
    play(5);
    showDock();
    const int all = rows();
    click(m_fixture->find<QCheckBox>("bounces_slow"));
    const int fast = rows();
    QVERIFY(fast < all);
    const inspector::EventLog &log = m_fixture->simulation().events();
    int expected = 0;
    LoggedEvent entry;
    for (uint64_t number = log.first(); number < log.last(); ++number)
        if (log.read(number, entry) && !entry.isSlow()) ++expected;
    QCOMPARE(fast, expected);
}

void TestWindowBounces::choiceOfRowsIsRemembered() {
    showDock();
    click(m_fixture->find<QCheckBox>("bounces_slow"));
    m_fixture->reopen();
    QVERIFY(!m_fixture->find<QCheckBox>("bounces_slow")->isChecked());
    QVERIFY(m_fixture->find<QCheckBox>("bounces_others")->isChecked());
}

void TestWindowBounces::otherEventsAreLeftOutOnRequest() {
    play(5); // until it has come to rest once
    m_fixture->parameters().set({{"rolling_friction", 0.1}});
    makeSteps(200);
    showDock();
    const int all = rows();
    click(m_fixture->find<QCheckBox>("bounces_others"));
    QVERIFY(rows() < all);
    for (int row = 0; row < rows(); ++row) QVERIFY(cell(row, 1) != QStringLiteral("Stop"));
}

void TestWindowBounces::listFollowsTheNewestRow() {
    play(3);
    showDock();
    const QScrollBar *bar = m_table->verticalScrollBar();
    m_table->scrollToBottom();
    play(6);
    QTRY_VERIFY(bar->maximum() > 0);
    QTRY_COMPARE(bar->value(), bar->maximum());
}

void TestWindowBounces::listStaysWhereItIsWhileARowIsSelected() {
    play(6);
    showDock();
    m_table->scrollToBottom();
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, rowPlace(rows() - 1));
    const int value = m_table->verticalScrollBar()->value();
    play(6);
    QTRY_VERIFY(m_table->verticalScrollBar()->maximum() > value); // laid out a moment later
    QCOMPARE(m_table->verticalScrollBar()->value(), value);
}

void TestWindowBounces::selectionStaysOnItsEventWhileRowsCome() {
    play(3);
    clickAt(pixelOf(lonelyMarks().front()));
    const std::optional<LoggedEvent> before = m_bounces->selected();
    QVERIFY(before);
    play(6);
    QVERIFY(m_bounces->selected());
    QCOMPARE(m_bounces->selected()->number, before->number);
}

void TestWindowBounces::restartEmptiesTheList() {
    play(3);
    clickAt(pixelOf(lonelyMarks().front()));
    m_fixture->trigger("restart");
    QTRY_COMPARE(rows(), 0);
    QVERIFY(!m_bounces->selected());
    QVERIFY(m_bounces->marks().recent.empty());
}

// The same steps again, as a recording makes them when it goes back.
void TestWindowBounces::selectionComesBackWithItsEvent() {
    play(3);
    const LoggedEvent mark = lonelyMarks().front();
    clickAt(pixelOf(mark));
    m_fixture->trigger("restart");
    QTRY_COMPARE(rows(), 0);
    QVERIFY(!m_bounces->selected());
    play(3);
    QVERIFY(m_bounces->selected());
    QCOMPARE(m_bounces->selected()->event.time, mark.event.time);
}

void TestWindowBounces::plotHasATickForEachBounce() {
    play(5);
    const auto *ticks =
        m_fixture->find<inspector::ui::TimePlot>("velocity_plot")->findChild<inspector::ui::BounceTicks *>();
    std::vector<double> expected;
    const inspector::EventLog &log = m_fixture->simulation().events();
    LoggedEvent entry;
    for (uint64_t number = log.first(); number < log.last(); ++number)
        if (log.read(number, entry) && entry.isBounce() && !entry.isSlow()) expected.push_back(entry.event.time);
    QVERIFY(!expected.empty());
    QVERIFY(ticks->times() == expected);
    QVERIFY(!ticks->selected());
}

void TestWindowBounces::selectedBounceIsMarkedInThePlot() {
    play(3);
    const LoggedEvent mark = lonelyMarks().front();
    clickAt(pixelOf(mark));
    const auto *ticks =
        m_fixture->find<inspector::ui::TimePlot>("velocity_plot")->findChild<inspector::ui::BounceTicks *>();
    QCOMPARE(ticks->selected(), std::optional(mark.event.time));
    clickAt(emptyPlace());
    QVERIFY(!ticks->selected());
}

void TestWindowBounces::clickOnATickSelectsItsBounce() {
    play(3);
    auto *plot = m_fixture->find<inspector::ui::TimePlot>("velocity_plot");
    const double time = plot->findChild<inspector::ui::BounceTicks *>()->times().front();
    const QPoint tick(int(std::lround(plot->xAxis->coordToPixel(time))), plot->axisRect()->bottom() - 4);
    QTest::mouseClick(plot, Qt::LeftButton, {}, tick - QPoint(0, 60)); // there is nothing above the tick
    QVERIFY(!m_bounces->selected());
    QTest::mouseClick(plot, Qt::LeftButton, {}, tick);
    QVERIFY(m_bounces->selected());
    QCOMPARE(m_bounces->selected()->event.time, time);
}

// One step of 10 s in which a ball that hardly loses speed bounces far more often than a report has room for.
void TestWindowBounces::lostEventsAreTold() {
    QVERIFY(chooseStepper(m_fixture->session(), "exact"));
    m_fixture->parameters().set({{"tilt_x", 6.0}, {"tilt_y", 4.0}, {"restitution_wall", 0.98}});
    QVERIFY(chooseDt(m_fixture->session(), 10.0));
    makeSteps(1);
    const uint64_t lost = m_fixture->simulation().latest().report.events_lost;
    QVERIFY(lost > 0);
    const QString text = m_fixture->find<QLabel>("bounces_count")->text();
    QVERIFY2(text.contains(QStringLiteral("%1 events lost").arg(lost)), qPrintable(text));
}

void TestWindowBounces::detailHasTheLawWithItsNumbers() {
    play(3);
    const LoggedEvent mark = lonelyMarks().front();
    clickAt(pixelOf(mark));
    const QString text = m_fixture->find<QLabel>("bounces_detail")->text();
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    const QString law =
        QStringLiteral("%1 m/s = 0.5 × %2 m/s").arg(number(mark.event.speed_after), number(-mark.event.speed_before));
    QVERIFY2(text.contains(law), qPrintable(text));
    QVERIFY(text.contains(QStringLiteral("Symplectic Euler")));
    QVERIFY(text.contains(QStringLiteral("<b>Box</b>")));
    QVERIFY(text.contains(QStringLiteral("model.md 2.1 R2")));
}

// In a narrow dock nothing is cut off: the details are below the list, and no line is wider than the dock.
void TestWindowBounces::detailIsWrappedBesideAnotherDock() {
    m_fixture->press(Qt::Key_7, Qt::ControlModifier);
    showDock();
    play(5);
    m_table->selectRow(0);
    const auto *detail = m_fixture->find<QLabel>("bounces_detail");
    const QWidget *area = detail->parentWidget();
    QVERIFY(area->mapTo(&m_fixture->window(), QPoint()).y() > m_table->mapTo(&m_fixture->window(), QPoint()).y());
    QTRY_VERIFY2(detail->width() <= area->width() && detail->minimumSizeHint().width() <= area->width(),
                 qPrintable(QString("%1 of %2").arg(detail->minimumSizeHint().width()).arg(area->width())));
    const auto *dock = m_fixture->find<QDockWidget>("bounces_dock");
    QVERIFY2(dock->width() > 0.3 * m_fixture->window().width(), qPrintable(QString::number(dock->width())));
}

// In the default window, beside the plots.
void TestWindowBounces::listBesideThePlotsHasRoom() {
    m_fixture->window().resize(1280, 820);
    showDock();
    play(5);
    const QHeaderView *header = m_table->horizontalHeader();
    const auto endOf = [header](const char *title) {
        for (int column = 0; column < header->count(); ++column)
            if (header->model()->headerData(column, Qt::Horizontal).toString().startsWith(title))
                return header->sectionViewportPosition(column) + header->sectionSize(column);
        qFatal("no column %s", title);
    };
    QTRY_VERIFY2(endOf("After") <= m_table->viewport()->width(),
                 qPrintable(QString("%1 of %2").arg(endOf("After")).arg(m_table->viewport()->width())));
    const int rows = m_table->viewport()->height() / m_table->rowHeight(0);
    QVERIFY2(rows >= 4, qPrintable(QString::number(rows)));
}

QTEST_MAIN(TestWindowBounces)
#include "tst_window_bounces.moc"
