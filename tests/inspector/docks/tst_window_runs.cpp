// SPDX-License-Identifier: MIT
// What remains of a run when the next one begins: it is listed, said to be, and can still be saved.
#include "core/program/options.h"
#include "core/recording/history.h"
#include "support/compare.h"
#include "support/files.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/plots/plot_stack.h"
#include "ui/transport/time_bar.h"
#include "ui/window/board_picture.h"
#include "ui/window/save_run.h"
#include "window_fixture.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QFile>
#include <QLabel>
#include <QStatusBar>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace window_test;
using inspector::ui::MessageBar;

class TestWindowRuns : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void runWhoseBeginningIsGoneSaysSo();
    void runThatContinuesAnotherSaysWhereThatIs();
    void recordingOfARunTakenOverSaysWhereItBegins();
    void emptyListSaysWhatItWillHold();
    void parametersOfARunAreThoseThatArentInitial_data();
    void parametersOfARunAreThoseThatArentInitial();
    void tickedRunIsShownBesideTheOthers();
    void runIsTickedInItsMenuByKeys();
    void runBesideIsNamedInTheLegend();
    void runBesideIsOfItsMaze();
    void runShownIsMarked();
    void recordingWithoutStepsIsNotSaved_data();
    void recordingWithoutStepsIsNotSaved();
    void everyRunIsShownFromItsFirstState();
    void barSaysThatAnotherRunIsBeingRepeated();
    void takenOverTiltEndsWithTheRun();
    void tiltSetByHandOutlivesARunTakenOver();
    void onlyTheLiveRunIsThePresentOne();
    void selectionStaysOnItsRun();
    void typedPlaceLeavesTheRunInRunsAndSaysSo();
    void tableAtTheEndIsOfTheLastRunWithSteps();
    void tableOfAnEarlierRunHasItsGhost();
    void ghostOfThePresentStartsWhereItMetTheBall();
    void tableOfARunTakenOverSaysWhatMadeEachRow();
    void tableOfARecordingGoneOnFromSaysWhatMadeEachRow();
    void wholeMessageIsReadBesideTheFields();
    void messageGoesWithTheNextCommand_data();
    void messageGoesWithTheNextCommand();

private:
    bool isAt(uint64_t step) { return ball().step == step; }
    phys_state ball() { return m_fixture->simulation().latest().current; }
    double tiltX() { return m_fixture->parameters().value(m_fixture->parameters().indexOf("tilt_x")); }
    bool isTilted() {
        const phys_vec3 down = m_fixture->parameters().inputs().params.gravity;
        return down.x != 0.0 || down.y != 0.0;
    }
    QString placeText() { return m_fixture->find<QLabel>("time_place")->text(); }
    QString resultOf(int row);
    void restart();
    void goBack(uint64_t steps);
    void tick(int row);
    void typeGravity(const QString &text);
    QByteArray textBesideTable();
};

void TestWindowRuns::init() {
    QVERIFY(open());
    m_fixture->trigger("show_runs_dock");
    m_fixture->makeSteps(30);
    m_fixture->window().refresh();
}

// In the list of runs, newest first.
QString TestWindowRuns::resultOf(int row) {
    m_fixture->window().refresh();
    const QTreeWidgetItem *item = m_fixture->find<QTreeWidget>("runs")->topLevelItem(row);
    return item ? item->text(4) : QStringLiteral("none");
}

void TestWindowRuns::restart() {
    m_fixture->key(Qt::Key_R);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(0));
}

void TestWindowRuns::goBack(uint64_t steps) {
    const uint64_t place = m_fixture->simulation().latest().current.step - steps;
    for (uint64_t i = 0; i < steps; ++i) m_fixture->press(Qt::Key_Comma);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, place);
}

// Clicks its box.
void TestWindowRuns::tick(int row) {
    auto *runs = m_fixture->find<QTreeWidget>("runs");
    const QRect place = runs->visualItemRect(runs->topLevelItem(row));
    QTest::mouseClick(runs->viewport(), Qt::LeftButton, {}, {place.left() + place.height() / 2, place.center().y()});
}

void TestWindowRuns::typeGravity(const QString &text) {
    auto *box = m_fixture->find<inspector::ui::NumberBox>("gravity_box");
    box->setFocus();
    box->selectAll();
    m_fixture->type(text);
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulated("gravity"), text.toDouble());
}

QByteArray TestWindowRuns::textBesideTable() {
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("table.csv"));
    return support::contentOf(m_fixture->path("table.csv.txt"));
}

// The history keeps so many changes of the step size.
void TestWindowRuns::runWhoseBeginningIsGoneSaysSo() {
    const uint64_t steps = inspector::History::kMostBlocks + 10;
    for (uint64_t i = 0; i < steps; ++i) {
        m_fixture->simulation().setDt(i % 2 ? 1e-6 : 2e-6);
        m_fixture->simulation().stepOnce();
    }
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, 30 + steps);
    m_fixture->window().refresh();
    QVERIFY2(!placeText().contains("Earlier"), qPrintable(placeText()));
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_VERIFY2(placeText().endsWith("Earlier steps aren't kept"), qPrintable(placeText()));
    m_fixture->key(Qt::Key_End, Qt::ControlModifier);
    QTRY_VERIFY2(!placeText().contains("Earlier"), qPrintable(placeText()));
    QCOMPARE(m_fixture->find<QWidget>("time_slider")->toolTip(), QString("Earlier steps aren't kept"));
    const QString file = m_fixture->path("late.rec");
    m_fixture->key(Qt::Key_S, Qt::ControlModifier);
    m_fixture->answerFile(file);
    const auto *messages = m_fixture->find<MessageBar>("messages");
    const QString kept = QStringLiteral("steps from 0.300015 s"); // ten of those steps are gone
    QVERIFY2(messages->line().contains(kept), qPrintable(messages->line()));
    restart();
    m_fixture->makeSteps(5);
    m_fixture->key(Qt::Key_S, Qt::ControlModifier);
    m_fixture->answerFile(m_fixture->path("whole.rec"));
    QCOMPARE(messages->line(), QString());
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->find<QWidget>("time_slider")->toolTip(), QString());
}

void TestWindowRuns::runThatContinuesAnotherSaysWhereThatIs() {
    goBack(10);
    typeGravity("1.62");
    m_fixture->makeSteps(5);
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_VERIFY2(placeText().endsWith("Earlier steps are in Runs"), qPrintable(placeText()));
}

void TestWindowRuns::recordingOfARunTakenOverSaysWhereItBegins() {
    goBack(10);
    typeGravity("3");
    m_fixture->makeSteps(5);
    QCOMPARE(inspector::ui::remarkOnSaved(m_fixture->session(), "taken.rec"),
             QString("taken.rec: begins at 0.2 s, where the run was taken over; its table (.csv) has what came before, "
                     "too"));
}

void TestWindowRuns::emptyListSaysWhatItWillHold() {
    QVERIFY(!m_fixture->find<QLabel>("runs_empty")->isVisible());
    Fixture other;
    QVERIFY(other.isReady());
    other.trigger("show_runs_dock");
    const auto *text = other.find<QLabel>("runs_empty");
    QVERIFY(text->isVisible() && text->text().startsWith("No run yet"));
    QVERIFY(text->width() > 100 && text->heightForWidth(text->width()) <= text->height()); // all of it is seen
}

void TestWindowRuns::parametersOfARunAreThoseThatArentInitial_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("stepsBefore");
    QTest::addColumn<QString>("expected");
    QTest::newRow("initial") << QString() << 0 << "initial";
    QTest::newRow("from the start") << "1.62" << 0 << "Gravity 1.62 m/s²";
    QTest::newRow("during the run") << "1.62" << 5 << "Gravity 9.81 m/s² → 1.62 m/s²";
}

void TestWindowRuns::parametersOfARunAreThoseThatArentInitial() {
    QFETCH(QString, typed);
    QFETCH(int, stepsBefore);
    QFETCH(QString, expected);
    restart();
    m_fixture->makeSteps(uint64_t(stepsBefore));
    m_fixture->window().refresh();
    if (!typed.isEmpty()) typeGravity(typed);
    m_fixture->makeSteps(5);
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->find<QTreeWidget>("runs")->topLevelItem(0)->text(5), expected);
}

void TestWindowRuns::tickedRunIsShownBesideTheOthers() {
    m_fixture->parameters().set({{QStringLiteral("tilt_x"), 3.0}});
    restart();
    m_fixture->makeSteps(40);
    m_fixture->window().refresh();
    restart();
    m_fixture->makeSteps(10);
    m_fixture->window().refresh();
    tick(1);
    const auto *plot = m_fixture->find<inspector::ui::PlotStack>("plots");
    QVERIFY(m_fixture->session().history().beside().run());
    QTRY_COMPARE(m_fixture->session().samplesBeside()->size(), size_t(40));
    QCOMPARE(m_fixture->session().samplesBeside()->back().time, 0.4);
    const inspector::gl::Frame frame = inspector::ui::currentFrame(m_fixture->session());
    QCOMPARE(frame.ghosts.size(), size_t(1)); // where the ball is, too: all else was the same
    QVERIFY(glm::distance(frame.ghosts[0].ball.position, frame.ball.position) < 1e-12);
    m_fixture->trigger("show_plot_dock");
    m_fixture->window().refresh();
    const QCustomPlot &first = const_cast<inspector::ui::PlotStack *>(plot)->first();
    QCOMPARE(first.graph(first.graphCount() - 1)->dataCount(), 40);
    m_fixture->trigger("show_runs_dock");
    tick(1);
    QVERIFY(!m_fixture->session().history().beside().run() && m_fixture->session().samplesBeside()->empty());
}

void TestWindowRuns::runIsTickedInItsMenuByKeys() {
    restart();
    m_fixture->makeSteps(5);
    m_fixture->window().refresh();
    auto *runs = m_fixture->find<QTreeWidget>("runs");
    runs->setCurrentItem(runs->topLevelItem(1));
    runs->setFocus();
    QContextMenuEvent asked(QContextMenuEvent::Keyboard, {}, {});
    QCoreApplication::sendEvent(runs->viewport(), &asked);
    QTRY_VERIFY(QApplication::activePopupWidget());
    m_fixture->key(Qt::Key_Up);
    m_fixture->key(Qt::Key_Return);
    QCOMPARE(runs->topLevelItem(1)->checkState(0), Qt::Checked);
    QCOMPARE(runs->topLevelItem(0)->checkState(0), Qt::Unchecked);
}

void TestWindowRuns::runBesideIsNamedInTheLegend() {
    QCPLegend *legend = m_fixture->find<inspector::ui::PlotStack>("plots")->first().legend;
    const int before = legend->itemCount();
    tick(0);
    QTRY_VERIFY(!m_fixture->session().samplesBeside()->empty());
    m_fixture->trigger("show_plot_dock"); // in front of the runs
    m_fixture->window().refresh();
    QCOMPARE(legend->itemCount(), before + 1);
    auto *named = qobject_cast<QCPPlottableLegendItem *>(legend->item(before));
    QCOMPARE(named->plottable()->name(), QString("Pale: another run"));
    m_fixture->trigger("show_runs_dock");
    tick(0);
    m_fixture->trigger("show_plot_dock");
    m_fixture->window().refresh();
    QCOMPARE(legend->itemCount(), before);
}

void TestWindowRuns::runBesideIsOfItsMaze() {
    tick(0);
    QTRY_VERIFY(!m_fixture->session().samplesBeside()->empty());
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[1]));
    QVERIFY(m_fixture->session().samplesBeside()->empty());
    QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[0]));
    QCOMPARE(m_fixture->session().samplesBeside()->size(), size_t(30));
}

void TestWindowRuns::runShownIsMarked() {
    restart();
    m_fixture->makeSteps(5);
    m_fixture->window().refresh();
    auto *runs = m_fixture->find<QTreeWidget>("runs");
    const auto marked = [runs] {
        QList<int> rows;
        for (int row = 0; row < runs->topLevelItemCount(); ++row)
            if (runs->topLevelItem(row)->font(0).bold()) rows += row;
        return rows;
    };
    QCOMPARE(marked(), QList<int>{0});
    QTest::mouseClick(runs->viewport(), Qt::LeftButton, {}, runs->visualItemRect(runs->topLevelItem(1)).center());
    m_fixture->key(Qt::Key_Return);
    QTRY_COMPARE(marked(), QList<int>{1});
    m_fixture->press(Qt::Key_End, Qt::ControlModifier);
    QTRY_COMPARE(marked(), QList<int>{0});
    restart(); // without a step it isn't listed
    QTRY_COMPARE(marked(), QList<int>());
}

void TestWindowRuns::recordingWithoutStepsIsNotSaved_data() {
    QTest::addColumn<bool>("isOtherLevel");
    QTest::newRow("after a restart") << false;
    QTest::newRow("after a change of the level") << true;
}

void TestWindowRuns::recordingWithoutStepsIsNotSaved() {
    QFETCH(bool, isOtherLevel);
    if (isOtherLevel) QVERIFY(m_fixture->session().openLevel(m_fixture->session().levels().listed()[1]));
    restart();
    const QString file = m_fixture->path("none.rec");
    m_fixture->key(Qt::Key_S, Qt::ControlModifier);
    m_fixture->answerFile(file);
    QCOMPARE(m_fixture->find<MessageBar>("messages")->line(),
             "'" + file + "': no steps made yet; earlier runs are in Runs");
    QVERIFY(!QFile::exists(file));
}

// Also if another run ends there, and however often it is taken over from there.
void TestWindowRuns::everyRunIsShownFromItsFirstState() {
    restart();
    const phys_state start = ball();
    m_fixture->makeSteps(10);
    for (int run = 0; run < 3; ++run) {
        m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
        QTRY_VERIFY(isAt(0));
        QVERIFY(support::sameBits(ball(), start));
        m_fixture->window().refresh();
        QCOMPARE(placeText(), QString("0.000 s · step 0 of 10"));
        m_fixture->session().takeOver();
        QTRY_VERIFY(!m_fixture->session().isInPast() && isAt(0));
        m_fixture->makeSteps(10);
    }
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_VERIFY(isAt(0));
    m_fixture->session().lookAt(m_fixture->session().runPlace().begin - 1); // the end of the run before
    QTRY_VERIFY(isAt(10));
    m_fixture->session().lookAt(m_fixture->session().runPlace().end + 1);
    QTRY_VERIFY(isAt(0));
}

void TestWindowRuns::barSaysThatAnotherRunIsBeingRepeated() {
    restart();
    m_fixture->makeSteps(5);
    const inspector::Snapshot before = m_fixture->simulation().latest();
    m_fixture->session().lookAt(0);
    auto *bar = m_fixture->find<inspector::ui::TimeBar>("time_bar");
    bar->refresh(before); // as long as nothing newer is shown
    QCOMPARE(placeText(), QString("Repeating the run…"));
    QTRY_COMPARE(placeText(), QString("0.000 s · step 0 of 30"));
}

void TestWindowRuns::takenOverTiltEndsWithTheRun() {
    m_fixture->key(Qt::Key_A); // the autopilot tilts
    m_fixture->makeSteps(30);
    m_fixture->key(Qt::Key_A);
    QVERIFY(!isTilted());
    goBack(5);
    m_fixture->key(Qt::Key_G);
    QTRY_VERIFY(!m_fixture->session().isInPast() && m_fixture->simulation().latest().running);
    m_fixture->key(Qt::Key_Space);
    QVERIFY(isTilted());
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    restart();
    QVERIFY(!isTilted());
    QTRY_COMPARE(m_fixture->simulated("tilt_x"), 0.0);
}

void TestWindowRuns::tiltSetByHandOutlivesARunTakenOver() {
    m_fixture->parameters().set({{"tilt_x", 2.0}});
    m_fixture->makeSteps(10);
    goBack(5);
    m_fixture->session().takeOver();
    restart();
    QCOMPARE(tiltX(), 2.0);
}

void TestWindowRuns::onlyTheLiveRunIsThePresentOne() {
    QCOMPARE(resultOf(0), QString("the present one"));
    restart();
    QCOMPARE(resultOf(0), QString("ended inside"));
    m_fixture->makeSteps(1);
    QCOMPARE(resultOf(0), QString("the present one"));
    QCOMPARE(resultOf(1), QString("ended inside"));
}

// Newer runs are listed above it.
void TestWindowRuns::selectionStaysOnItsRun() {
    auto *runs = m_fixture->find<QTreeWidget>("runs");
    for (uint64_t steps : {10, 5}) {
        restart();
        m_fixture->makeSteps(steps);
        m_fixture->window().refresh();
        if (steps == 10)
            QTest::mouseClick(runs->viewport(), Qt::LeftButton, {},
                              runs->visualItemRect(runs->topLevelItem(1)).center());
        QVERIFY(runs->currentItem());
        QCOMPARE(runs->currentItem()->text(3), QString("0:00.30"));
    }
}

void TestWindowRuns::typedPlaceLeavesTheRunInRunsAndSaysSo() {
    m_fixture->trigger("show_ball_dock");
    m_fixture->window().refresh();
    m_fixture->find<QWidget>("ball_x")->setFocus();
    const uint64_t run = m_fixture->simulation().latest().run;
    m_fixture->key(Qt::Key_A, Qt::ControlModifier);
    m_fixture->type(QStringLiteral("0"));
    m_fixture->key(Qt::Key_Return);
    QCOMPARE(m_fixture->window().statusBar()->currentMessage(), QString("The run before is in Runs (Ctrl+8)"));
    QTRY_VERIFY(m_fixture->simulation().latest().run > run);
    if (!m_fixture->find<QTreeWidget>("runs")->isVisible())
        m_fixture->trigger("show_runs_dock"); // the Ball dock hid it
    QCOMPARE(resultOf(0), QString("ended inside"));
    QCOMPARE(m_fixture->session().history().runs().size(), size_t(1));
}

// What --csv names.
void TestWindowRuns::tableAtTheEndIsOfTheLastRunWithSteps() {
    inspector::Options options;
    options.registry = m_fixture->session().registry();
    options.level = m_fixture->session().level();
    options.csv = m_fixture->path("end.csv");
    restart();
    QString error;
    QVERIFY2(inspector::ui::writeTableOfRun(m_fixture->session(), options, &error), qPrintable(error));
    QCOMPARE(support::contentOf(options.csv).count('\n'), 31);
    const QByteArray beside = support::contentOf(options.csv + ".txt");
    QVERIFY2(beside.contains("\nstepper symplectic-euler "), beside.constData());
    QVERIFY2(beside.endsWith("\nsamples from 0.01 s to 0.3 s\n"), beside.constData());
}

// It follows the ball from the beginning of the run.
void TestWindowRuns::tableOfAnEarlierRunHasItsGhost() {
    inspector::Options options;
    options.registry = m_fixture->session().registry();
    options.level = m_fixture->session().level();
    options.csv = m_fixture->path("end.csv");
    m_fixture->parameters().set({{QStringLiteral("tilt_x"), 3.0}});
    restart();
    m_fixture->trigger("compare");
    m_fixture->makeSteps(30);
    QString error;
    QVERIFY2(inspector::ui::writeTableOfRun(m_fixture->session(), options, &error), qPrintable(error));
    const QByteArray live = support::contentOf(options.csv);
    const QByteArray beside = support::contentOf(options.csv + ".txt");
    restart();
    QVERIFY2(inspector::ui::writeTableOfRun(m_fixture->session(), options, &error), qPrintable(error));
    QVERIFY2(live.contains("distance [m]"), live.left(400).constData());
    QCOMPARE(support::contentOf(options.csv), live);
    QCOMPARE(support::contentOf(options.csv + ".txt"), beside);
}

// Where another run was looked at in between, too.
void TestWindowRuns::ghostOfThePresentStartsWhereItMetTheBall() {
    restart();
    m_fixture->makeSteps(10);
    m_fixture->trigger("compare");
    m_fixture->makeSteps(20);
    const auto ghostAt = [&](uint64_t number) {
        inspector::Sample sample;
        const inspector::SampleRing &samples = m_fixture->simulation().samples();
        return samples.read(samples.first() + number, sample) ? sample[inspector::Channel::Distance] : -1.0;
    };
    const double last = ghostAt(29);
    QVERIFY(std::isnan(ghostAt(9)) && last >= 0.0);
    m_fixture->session().lookAt(5); // of the first run
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(5));
    QVERIFY(ghostAt(9) >= 0.0);
    m_fixture->session().returnToPresent();
    QTRY_VERIFY(std::isnan(ghostAt(9)));
    QCOMPARE(ghostAt(29), last);
}

// Its rows begin with those of the run before.
void TestWindowRuns::tableOfARunTakenOverSaysWhatMadeEachRow() {
    m_fixture->press(Qt::Key_C);
    m_fixture->makeSteps(10);
    goBack(5);
    typeGravity("1.62");
    m_fixture->makeSteps(10);
    goBack(3);
    typeGravity("3.71");
    const QByteArray before = textBesideTable(); // without a step of its own
    QVERIFY2(before.contains("\nfrom 0.36 s: gravity 1.62 m/s^2\n") && !before.contains("3.71"), before.constData());
    m_fixture->makeSteps(10);
    const QByteArray text = textBesideTable();
    QVERIFY2(text.contains("\ngravity 9.81 m/s^2\n"), text.constData());
    QVERIFY2(text.contains("\nfrom 0.31 s: compare exact "), text.constData());
    QVERIFY2(text.contains("\nfrom 0.36 s: gravity 1.62 m/s^2\nfrom 0.36 s: compare starts anew at the ball\n"),
             text.constData());
    QVERIFY2(text.contains("\nfrom 0.43 s: gravity 3.71 m/s^2\nfrom 0.43 s: compare starts anew at the ball\n"),
             text.constData());
    QVERIFY2(text.endsWith("\nsamples from 0.01 s to 0.52 s\n") && !text.contains("rows to"), text.constData());
}

void TestWindowRuns::tableOfARecordingGoneOnFromSaysWhatMadeEachRow() {
    m_fixture->press(Qt::Key_S, Qt::ControlModifier);
    m_fixture->answerFile(m_fixture->path("thirty.rec"));
    m_fixture->drop(m_fixture->path("thirty.rec"));
    QTRY_COMPARE(m_fixture->simulation().latest().replay.position, uint64_t(30));
    m_fixture->press(Qt::Key_G);
    typeGravity("1.62");
    m_fixture->makeSteps(10);
    const QByteArray text = textBesideTable();
    QVERIFY2(text.contains("\ngravity 9.81 m/s^2\n"), text.constData());
    QVERIFY2(text.contains("\nfrom 0.31 s: gravity 1.62 m/s^2\n"), text.constData());
    QVERIFY2(text.endsWith("\nsamples from 0.01 s to 0.4 s\n") && !text.contains("rows to"), text.constData());
}

void TestWindowRuns::wholeMessageIsReadBesideTheFields() {
    m_fixture->press(Qt::Key_C);
    goBack(5);
    typeGravity("1.62");
    m_fixture->window().refresh();
    const QStatusBar *status = m_fixture->window().statusBar();
    const QString message = status->currentMessage();
    QVERIFY2(message.endsWith("is in Runs (Ctrl+8); the ghost starts at the ball again"), qPrintable(message));
    int room = status->width();
    for (const QLabel *field : status->findChildren<QLabel *>())
        if (field->isVisible()) room = std::min(room, field->x());
    QVERIFY2(room > status->fontMetrics().horizontalAdvance(message), qPrintable(QString::number(room)));
    QVERIFY(room < status->width()); // some fields are still there
    m_fixture->press(Qt::Key_R);
    QCOMPARE(status->currentMessage(), QString());
    m_fixture->window().refresh();
    QVERIFY(m_fixture->find<QLabel>("status_ghost")->isVisible());
}

void TestWindowRuns::messageGoesWithTheNextCommand_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::newRow("restart") << Qt::Key_R;
    QTest::newRow("comparison") << Qt::Key_C;
    QTest::newRow("start of the game") << Qt::Key_Return;
}

void TestWindowRuns::messageGoesWithTheNextCommand() {
    QFETCH(Qt::Key, key);
    goBack(5);
    const QStatusBar *status = m_fixture->window().statusBar();
    typeGravity("1.62");
    QVERIFY(!status->currentMessage().isEmpty());
    m_fixture->press(key);
    QCOMPARE(status->currentMessage(), QString());
}

QTEST_MAIN(TestWindowRuns)
#include "tst_window_runs.moc"
