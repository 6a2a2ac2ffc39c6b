// SPDX-License-Identifier: MIT
// Every run is kept: the user goes back to it, takes it over with a change, saves it afterwards.
#include "gl/view/maze_view.h"
#include "inspector/stepping.h"
#include "support/compare.h"
#include "support/file_limit.h"
#include "support/files.h"
#include "ui/parts/message_bar.h"
#include "ui/parts/number_box.h"
#include "ui/transport/seek_slider.h"
#include "ui/window/save_run.h"
#include "window_fixture.h"

#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QStatusBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeWidget>

using namespace window_test;
using inspector::ui::MessageBar;
using support::sameBits;

class TestWindowPast : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void timeBarIsAlwaysThere();
    void draggedTimeShowsThatMoment();
    void stepBackShowsTheStepBefore();
    void stepsForwardEndAtThePresent();
    void escReturnsToThePresent();
    void spacePlaysWhatWas();
    void plotKeepsTheWholeRun();
    void typedParameterTakesOver();
    void arrowTakesOver();
    void arrowTakesOverFromTheAutopilot();
    void takingOverSaysWhereTheRunBeforeIs();
    void takingOverWithoutAChangeGivesTheSameBits();
    void timeBarSaysTheStateStep();
    void keysJumpFromBounceToBounce();
    void secondJumpGoesOnFromTheFirst();
    void jumpSelectsItsBounceAlone();
    void restartKeepsTheRunBefore();
    void runsNameAllThatTheyWereMadeBy();
    void clickOnAnotherLevelKeepsTheRun();
    void parametersAreThoseOfTheMoment();
    void beginningOfARunThatWasIsNotAboutToStart();
    void ghostChosenInThePastBeginsInThePresent();
    void ghostSwitchedOnInThePastBeginsInThePresent();
    void savedRunRepeats();
    void tableAndPictureAreSaved();
    void tableAfterARestartMissesNothing();
    void fileBesideTheTableSaysWhatMadeEachRow();
    void tableAtTheEndIsOfWhatWasRun();
    void tableWithoutSamplesIsNotWritten_data();
    void tableWithoutSamplesIsNotWritten();
    void refusedNameIsForgottenWithTheNextCommandThatWorks_data();
    void refusedNameIsForgottenWithTheNextCommandThatWorks();
    void whatAFileLimitLosesIsSaidAndTheLastFileIsKept_data();
    void whatAFileLimitLosesIsSaidAndTheLastFileIsKept();
    void saveAsksForAName();
    void recordingIntoAFileIsSeen();

private:
    inspector::Snapshot now() { return m_fixture->simulation().latest(); }
    inspector::Session &session() { return m_fixture->session(); }
    void makeSteps(uint64_t count);
    void goTo(uint64_t step);
    std::vector<double> bounceTimes(); // of those that are jumped to
    bool isAtTime(double time);        // whether its step is shown
    inspector::ui::SeekSlider *slider() { return m_fixture->find<inspector::ui::SeekSlider>("time_slider"); }
    bool isAt(uint64_t step) {
        if (now().current.step != step) return false;
        m_fixture->window().refresh(); // shows this moment, not one before
        return true;
    }

    std::vector<phys_state> m_states; // after each step
};

void TestWindowPast::init() {
    QVERIFY(open());
    m_fixture->parameters().set({{QStringLiteral("tilt_y"), 5.0}, {QStringLiteral("tilt_x"), -3.0}});
    m_states.clear();
}

void TestWindowPast::makeSteps(uint64_t count) {
    for (uint64_t i = 0; i < count; ++i) {
        m_fixture->makeSteps(1);
        m_states.push_back(now().current);
    }
    m_fixture->window().refresh();
}

// With the mouse on the time.
void TestWindowPast::goTo(uint64_t step) {
    m_fixture->window().refresh();
    QTest::mouseClick(slider(), Qt::LeftButton, {}, {slider()->pixelOf(int(step)), slider()->height() / 2});
    QTRY_VERIFY(session().isInPast());
    QTRY_VERIFY(isAt(session().runPlace().place - session().runPlace().begin));
}

void TestWindowPast::timeBarIsAlwaysThere() {
    QVERIFY(m_fixture->find<QWidget>("time_bar")->isVisible());
    makeSteps(20);
    QCOMPARE(slider()->maximum(), 20);
    QCOMPARE(slider()->value(), 20);
    QCOMPARE(m_fixture->find<QLabel>("time_place")->text(), QString("0.200 s · step 20"));
}

void TestWindowPast::draggedTimeShowsThatMoment() {
    makeSteps(40);
    m_fixture->window().refresh();
    const int middle = slider()->height() / 2;
    drag(slider(), {slider()->pixelOf(40), middle}, {slider()->pixelOf(10), middle});
    QTRY_VERIFY(session().isInPast() && isAt(uint64_t(slider()->value())));
    QVERIFY(slider()->value() < 20);
    QVERIFY(sameBits(now().current, m_states[now().current.step - 1]));
    QVERIFY(!now().running);
}

void TestWindowPast::stepBackShowsTheStepBefore() {
    makeSteps(10);
    m_fixture->key(Qt::Key_Comma);
    QTRY_VERIFY(isAt(9));
    QVERIFY(sameBits(now().current, m_states[8]));
    m_fixture->key(Qt::Key_Comma);
    QTRY_VERIFY(isAt(8));
    QVERIFY(sameBits(now().current, m_states[7]));
    QVERIFY(sameBits(now().previous, m_states[6]));
}

void TestWindowPast::stepsForwardEndAtThePresent() {
    makeSteps(10);
    goTo(8);
    m_fixture->key(Qt::Key_Period);
    QTRY_VERIFY(isAt(9));
    QVERIFY(session().isInPast());
    m_fixture->key(Qt::Key_Period);
    QTRY_VERIFY(isAt(10));
    QTRY_VERIFY(!session().isInPast());
    makeSteps(1); // a new one
    QCOMPARE(now().current.step, uint64_t(11));
}

void TestWindowPast::escReturnsToThePresent() {
    makeSteps(10);
    goTo(3);
    m_fixture->key(Qt::Key_Escape);
    QVERIFY(!session().isInPast());
    QTRY_VERIFY(isAt(10));
    QVERIFY(sameBits(now().current, m_states[9]));
}

void TestWindowPast::spacePlaysWhatWas() {
    makeSteps(20);
    goTo(3);
    m_fixture->key(Qt::Key_Space);
    QTRY_VERIFY(!session().isInPast()); // up to the present
    QTRY_VERIFY(isAt(20));
    QVERIFY(!now().running);
    QVERIFY(sameBits(now().current, m_states[19]));
}

void TestWindowPast::plotKeepsTheWholeRun() {
    makeSteps(20);
    const inspector::SampleRing &samples = m_fixture->simulation().samples();
    goTo(5);
    QCOMPARE(samples.last() - samples.first(), uint64_t(20));
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(isAt(20));
    QCOMPARE(samples.last() - samples.first(), uint64_t(20));
}

void TestWindowPast::typedParameterTakesOver() {
    makeSteps(40);
    goTo(20);
    const uint64_t place = now().current.step;
    auto *box = m_fixture->find<inspector::ui::NumberBox>("gravity_box");
    box->setFocus();
    box->selectAll();
    m_fixture->type("3");
    m_fixture->key(Qt::Key_Return);
    QVERIFY(!session().isInPast());
    QTRY_COMPARE(m_fixture->simulated("gravity"), 3.0);
    QTRY_VERIFY(isAt(place));
    const inspector::SampleRing &samples = m_fixture->simulation().samples();
    QTRY_COMPARE(samples.last() - samples.first(), place);          // the rest isn't this run's
    QVERIFY(session().history().oldFuture()->size() >= 40 - place); // but is remembered
    const phys_state before = m_states[place];
    makeSteps(1);
    QCOMPARE(now().current.step, place + 1);
    QVERIFY(!sameBits(now().current, before));
    QCOMPARE(samples.last() - samples.first(), place + 1);
}

void TestWindowPast::arrowTakesOver() {
    makeSteps(20);
    goTo(10);
    m_fixture->window().view().setFocus(); // the time bar has the keyboard after a click
    QTest::keyPress(&m_fixture->window().view(), Qt::Key_Up);
    QTRY_VERIFY(!session().isInPast());
    QTRY_VERIFY(now().running);
    QTest::keyRelease(&m_fixture->window().view(), Qt::Key_Up);
}

void TestWindowPast::arrowTakesOverFromTheAutopilot() {
    m_fixture->key(Qt::Key_A);
    makeSteps(20);
    goTo(10);
    m_fixture->window().view().setFocus();
    QTest::keyPress(&m_fixture->window().view(), Qt::Key_Up);
    QTRY_VERIFY(!session().isInPast());
    QVERIFY(!session().hasAutopilot());
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 1.0);
    QTest::keyRelease(&m_fixture->window().view(), Qt::Key_Up);
}

void TestWindowPast::takingOverSaysWhereTheRunBeforeIs() {
    makeSteps(20);
    goTo(10);
    m_fixture->key(Qt::Key_G);
    QCOMPARE(m_fixture->window().statusBar()->currentMessage(),
             QString("What came before this moment, and after it, is in Runs (Ctrl+8)"));
}

void TestWindowPast::takingOverWithoutAChangeGivesTheSameBits() {
    makeSteps(40);
    goTo(20);
    const uint64_t place = now().current.step;
    const std::vector<phys_state> before = m_states;
    session().takeOver();
    QTRY_VERIFY(isAt(place));
    makeSteps(40 - place);
    QVERIFY(sameBits(now().current, before[39]));
}

// Its time and step continue from the run that was taken over, of which it isn't a part.
void TestWindowPast::timeBarSaysTheStateStep() {
    makeSteps(40);
    goTo(20);
    const uint64_t place = now().current.step;
    session().takeOver();
    QTRY_VERIFY(isAt(place));
    makeSteps(5);
    const QString present = QStringLiteral("%1 s · step %2");
    const auto *label = m_fixture->find<QLabel>("time_place");
    QCOMPARE(label->text(), present.arg(0.01 * double(place + 5), 0, 'f', 3).arg(place + 5));
    m_fixture->key(Qt::Key_Comma);
    QTRY_VERIFY(isAt(place + 4));
    const QString past = present.arg(0.01 * double(place + 4), 0, 'f', 3).arg(place + 4);
    QCOMPARE(label->text(), past + QStringLiteral(" of %1").arg(place + 5));
}

std::vector<double> TestWindowPast::bounceTimes() {
    std::vector<double> times;
    const inspector::EventLog &log = m_fixture->simulation().events();
    inspector::LoggedEvent event;
    for (uint64_t i = log.first(); i < log.last(); ++i)
        if (log.read(i, event) && event.isBounce() && !event.isSlow()) times.push_back(event.event.time);
    return times;
}

bool TestWindowPast::isAtTime(double time) {
    m_fixture->window().refresh();
    return now().previous.time < time && time <= now().current.time;
}

void TestWindowPast::keysJumpFromBounceToBounce() {
    m_fixture->trigger("show_bounces_dock");
    makeSteps(250);
    const std::vector<double> times = bounceTimes();
    QVERIFY(times.size() >= 2);
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_VERIFY(isAt(0));
    m_fixture->key(Qt::Key_Right, Qt::ControlModifier);
    QTRY_VERIFY(isAtTime(times[0]));
    m_fixture->key(Qt::Key_Right, Qt::ControlModifier);
    QTRY_VERIFY(isAtTime(times[1]));
    m_fixture->key(Qt::Key_Left, Qt::ControlModifier);
    QTRY_VERIFY(isAtTime(times[0]));
}

// Also while that isn't shown yet.
void TestWindowPast::secondJumpGoesOnFromTheFirst() {
    makeSteps(250);
    const std::vector<double> times = bounceTimes();
    QVERIFY(times.size() >= 3);
    for (int i = 0; i < 3; ++i) m_fixture->key(Qt::Key_Left, Qt::ControlModifier);
    QTRY_VERIFY(isAtTime(times[times.size() - 3]));
    for (int i = 0; i < 2; ++i) m_fixture->key(Qt::Key_Right, Qt::ControlModifier);
    QTRY_VERIFY(isAtTime(times.back()));
}

// With Ctrl held down from one jump to the next.
void TestWindowPast::jumpSelectsItsBounceAlone() {
    m_fixture->trigger("show_bounces_dock");
    makeSteps(250);
    const auto *table = m_fixture->find<QTableView>("bounces_table");
    const auto selected = [&] {
        m_fixture->window().refresh();
        QStringList times;
        for (const QModelIndex &row : table->selectionModel()->selectedRows()) times += row.data().toString();
        return times.join(' ');
    };
    QTest::keyPress(&m_fixture->window().view(), Qt::Key_Control, Qt::ControlModifier);
    m_fixture->key(Qt::Key_Left, Qt::ControlModifier);
    QTRY_VERIFY(!selected().isEmpty());
    const QString last = selected();
    QVERIFY2(!last.contains(' '), qPrintable(last));
    m_fixture->key(Qt::Key_Left, Qt::ControlModifier);
    QTRY_VERIFY2(!selected().isEmpty() && selected().toDouble() < last.toDouble(), qPrintable(selected()));
    QVERIFY(!m_fixture->find<QLabel>("bounces_detail")->text().contains("Click a bounce"));
    QTest::keyRelease(&m_fixture->window().view(), Qt::Key_Control);
}

void TestWindowPast::restartKeepsTheRunBefore() {
    makeSteps(30);
    m_fixture->key(Qt::Key_R);
    QTRY_VERIFY(isAt(0));
    makeSteps(20);
    m_fixture->trigger("show_runs_dock");
    m_fixture->window().refresh();
    auto *runs = m_fixture->find<QTreeWidget>("runs");
    QCOMPARE(runs->topLevelItemCount(), 2);
    runs->setFocus();
    runs->setCurrentItem(runs->topLevelItem(1)); // the one before
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(isAt(30));
    QVERIFY(sameBits(now().current, m_states[29]));
    const inspector::SampleRing &samples = m_fixture->simulation().samples();
    QTRY_COMPARE(samples.last() - samples.first(), uint64_t(30));
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(isAt(20));
    QTRY_COMPARE(samples.last() - samples.first(), uint64_t(20));
}

void TestWindowPast::runsNameAllThatTheyWereMadeBy() {
    makeSteps(3);
    m_fixture->window().refresh();
    chooseStepper(session(), "exact");
    chooseDt(session(), 0.001);
    makeSteps(3);
    m_fixture->window().refresh();
    m_fixture->trigger("show_runs_dock");
    m_fixture->window().refresh();
    const QTreeWidgetItem *run = m_fixture->find<QTreeWidget>("runs")->topLevelItem(0);
    QCOMPARE(run->text(0), QString("Level 1"));
    QCOMPARE(run->text(1), QString("Symplectic Euler, Exact"));
    QCOMPARE(run->text(2), QString("10 ms, 1 ms"));
}

void TestWindowPast::clickOnAnotherLevelKeepsTheRun() {
    makeSteps(30);
    auto *levels = m_fixture->find<QTreeWidget>("levels");
    const QRect third = levels->visualItemRect(levels->topLevelItem(2));
    QTest::mouseClick(levels->viewport(), Qt::LeftButton, {}, third.center());
    QTRY_VERIFY(isAt(0));
    QCOMPARE(session().level().name, QString("03"));
    session().lookAt(session().history().runs().front().end);
    QTRY_VERIFY(isAt(30));
    QVERIFY(sameBits(now().current, m_states[29]));
    QCOMPARE(session().level().name, QString("01"));
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(isAt(0));
    QCOMPARE(session().level().name, QString("03"));
}

void TestWindowPast::parametersAreThoseOfTheMoment() {
    const auto gravity = [&] {
        return m_fixture->parameters().value(m_fixture->parameters().indexOf(QStringLiteral("gravity")));
    };
    makeSteps(20);
    m_fixture->parameters().set({{QStringLiteral("gravity"), 5.0}});
    makeSteps(20);
    goTo(10);
    QTRY_COMPARE(gravity(), 9.81);
    m_fixture->key(Qt::Key_Escape);
    QCOMPARE(gravity(), 5.0);
    QTRY_COMPARE(m_fixture->simulated("gravity"), 5.0);
}

void TestWindowPast::beginningOfARunThatWasIsNotAboutToStart() {
    const auto *label = m_fixture->find<QLabel>("status_ball");
    m_fixture->window().refresh();
    QCOMPARE(label->text(), QString("Ball: about to start"));
    makeSteps(10);
    m_fixture->key(Qt::Key_Home, Qt::ControlModifier);
    QTRY_VERIFY(session().isInPast() && isAt(0));
    QCOMPARE(label->text(), QString("Ball: at rest"));
}

void TestWindowPast::ghostChosenInThePastBeginsInThePresent() {
    m_fixture->press(Qt::Key_5, Qt::ControlModifier); // its dock
    session().comparison().start({"exact", 1});
    QTRY_VERIFY(now().ghost);
    makeSteps(20);
    m_fixture->key(Qt::Key_Comma);
    QTRY_VERIFY(session().isInPast() && now().current.step == 19);
    auto *box = m_fixture->find<inspector::ui::NumberBox>("comparison_substeps");
    box->setFocus(Qt::TabFocusReason);
    box->selectAll();
    QTest::keyClicks(box, "10");
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(session().isInPast());
    m_fixture->press(Qt::Key_Escape);
    QTRY_VERIFY(!session().isInPast());
    QTRY_COMPARE(now().current.step, uint64_t(20));
    makeSteps(1);
    QCOMPARE(now().ghost->met.step, uint64_t(20));
    const auto *made = session().comparison().made(now().ghost->number);
    QVERIFY(made && made->ghostChoice == (inspector::GhostChoice{"exact", 10}));
}

void TestWindowPast::ghostSwitchedOnInThePastBeginsInThePresent() {
    makeSteps(20);
    m_fixture->key(Qt::Key_Comma);
    QTRY_VERIFY(session().isInPast() && now().current.step == 19);
    m_fixture->key(Qt::Key_C);
    m_fixture->key(Qt::Key_Escape);
    QTRY_VERIFY(!session().isInPast());
    QTRY_VERIFY(now().ghost);
    QCOMPARE(now().ghost->met.step, uint64_t(20));
}

void TestWindowPast::savedRunRepeats() {
    makeSteps(30);
    m_fixture->key(Qt::Key_R);
    QTRY_VERIFY(isAt(0));
    makeSteps(40);
    QString error;
    const QString path = m_fixture->path("kept.rec");
    QVERIFY2(session().saveRun(path, &error), qPrintable(error));
    QVERIFY(session().openRecording(path));
    QCOMPARE(session().replay()->recording().length(), uint64_t(40));
    QTRY_COMPARE(session().replay()->verdict(now()), QString("same: 40 steps"));
}

void TestWindowPast::tableAndPictureAreSaved() {
    makeSteps(30);
    for (const char *name : {"kept.csv", "kept.png"}) {
        m_fixture->trigger("save_run");
        auto *dialog = m_fixture->window().findChild<QFileDialog *>();
        QVERIFY(dialog);
        emit dialog->fileSelected(m_fixture->path(name)); // what it says once a name is chosen
        delete dialog;
        QVERIFY2(QFile::exists(m_fixture->path(name)), name);
    }
    QFile table(m_fixture->path("kept.csv"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QCOMPARE(table.readAll().trimmed().split('\n').size(), 31);
    QFile beside(m_fixture->path("kept.csv.txt"));
    QVERIFY(beside.open(QIODevice::ReadOnly));
    const QByteArrayList settings = beside.readAll().trimmed().split('\n');
    QVERIFY(settings.join('|').contains("|stepper symplectic-euler "));
    QCOMPARE(settings.last(), QByteArray("samples from 0.01 s to 0.3 s"));
    const QImage picture(m_fixture->path("kept.png"));
    QCOMPARE(picture.size(), m_fixture->window().view().size());
    m_fixture->trigger("picture_scale_1");
    QCOMPARE(m_fixture->window().view().picture(2).size(), 2 * m_fixture->window().view().size());
}

void TestWindowPast::tableAfterARestartMissesNothing() {
    makeSteps(30);
    m_fixture->key(Qt::Key_R);
    QTRY_VERIFY(isAt(0));
    makeSteps(20);
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("kept.csv"));
    QCOMPARE(m_fixture->find<MessageBar>("messages")->line(), QString());
    const QByteArrayList settings = support::contentOf(m_fixture->path("kept.csv.txt")).trimmed().split('\n');
    QCOMPARE(settings.last(), QByteArray("samples from 0.01 s to 0.2 s"));
}

void TestWindowPast::fileBesideTheTableSaysWhatMadeEachRow() {
    m_fixture->parameters().set({{"tilt_x", 1.0}});
    makeSteps(10);
    QVERIFY(chooseDt(m_fixture->session(), 0.001));
    makeSteps(10);
    m_fixture->parameters().set({{"tilt_x", 2.0}});
    QVERIFY(chooseStepper(m_fixture->session(), "rk4"));
    makeSteps(10);
    m_fixture->parameters().set({{"restitution_wall", 0.9}}); // makes no row
    m_fixture->trigger("save_run");
    m_fixture->answerFile(m_fixture->path("kept.csv"));
    const QByteArray text = support::contentOf(m_fixture->path("kept.csv.txt"));
    QVERIFY2(text.contains("\nstepper symplectic-euler "), text.constData());
    QVERIFY2(text.contains("\ndt 0.01 s\n"), text.constData());
    QVERIFY2(text.contains("\nrestitution_wall 0.5\n"), text.constData());
    QVERIFY2(text.contains("\ntilt varies: columns tilt_x, tilt_y\n"), text.constData());
    QVERIFY2(text.contains("\nfrom 0.101 s: dt 0.001 s\n"), text.constData());
    QVERIFY2(text.contains("\nfrom 0.111 s: stepper rk4 "), text.constData());
    QCOMPARE(text.count("from 0."), 3); // with the samples'
}

// What --csv names: the options are those of the start.
void TestWindowPast::tableAtTheEndIsOfWhatWasRun() {
    inspector::Options options;
    options.registry = session().registry();
    options.level = session().level();
    options.csv = m_fixture->path("end.csv");
    QVERIFY(chooseStepper(session(), "rk4"));
    m_fixture->key(Qt::Key_C);
    makeSteps(5);
    QString error;
    QVERIFY2(inspector::ui::writeTableOfRun(session(), options, &error), qPrintable(error));
    const QByteArray beside = support::contentOf(options.csv + ".txt");
    QVERIFY2(beside.contains("\nstepper rk4 ") && beside.contains("\ncompare exact "), beside.constData());
    QVERIFY2(beside.endsWith("\nsamples from 0.01 s to 0.05 s\n"), beside.constData());
    const QByteArray table = support::contentOf(options.csv);
    QVERIFY2(table.startsWith("time [s],step,") && table.contains(",distance [m],"), table.constData());
    QCOMPARE(table.count('\n'), 6);
}

void TestWindowPast::tableWithoutSamplesIsNotWritten_data() {
    QTest::addColumn<QString>("action");
    for (const char *action : {"save_run", "save_plot"}) QTest::newRow(action) << action;
}

void TestWindowPast::tableWithoutSamplesIsNotWritten() {
    QFETCH(QString, action);
    const QString file = m_fixture->path("none.csv");
    m_fixture->trigger(action);
    m_fixture->answerFile(file);
    QCOMPARE(m_fixture->find<MessageBar>("messages")->line(), "'" + file + "': no samples");
    QVERIFY(!QFile::exists(file));
    QVERIFY(!QFile::exists(file + ".txt"));
}

void TestWindowPast::refusedNameIsForgottenWithTheNextCommandThatWorks_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<int>("key");
    for (const char *action : {"save_run", "save_plot"})
        for (const Qt::Key next : {Qt::Key_R, Qt::Key_Space, Qt::Key_T})
            QTest::newRow(qPrintable(QString(action) + ", " + QChar(next))) << QString(action) << int(next);
}

void TestWindowPast::refusedNameIsForgottenWithTheNextCommandThatWorks() {
    QFETCH(QString, action);
    QFETCH(int, key);
    makeSteps(5);
    m_fixture->trigger(action);
    m_fixture->answerFile(m_fixture->path("none/run.csv"));
    auto *messages = m_fixture->find<MessageBar>("messages");
    QVERIFY2(messages->line().contains("No such file"), qPrintable(messages->line()));
    m_fixture->key(Qt::Key(key));
    QCOMPARE(messages->line(), QString());
}

void TestWindowPast::whatAFileLimitLosesIsSaidAndTheLastFileIsKept_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("name");
    for (const char *name : {"kept.rec", "kept.csv", "kept.png"}) QTest::newRow(name) << "save_run" << name;
    for (const char *name : {"plot.csv", "plot.png", "plot.pdf"}) QTest::newRow(name) << "save_plot" << name;
}

void TestWindowPast::whatAFileLimitLosesIsSaidAndTheLastFileIsKept() {
    QFETCH(QString, action);
    QFETCH(QString, name);
    const QString file = m_fixture->path(name);
    support::write(file, "the last one");
    makeSteps(30);
    m_fixture->trigger(action);
    const support::FileLimit limit(100);
    m_fixture->answerFile(file);
    QCOMPARE(m_fixture->find<MessageBar>("messages")->line(), "'" + file + "': File too large");
    QCOMPARE(support::contentOf(file), QByteArray("the last one"));
}

void TestWindowPast::saveAsksForAName() {
    makeSteps(5);
    m_fixture->key(Qt::Key_S, Qt::ControlModifier);
    const auto *dialog = m_fixture->window().findChild<QFileDialog *>();
    QVERIFY(dialog);
    QCOMPARE(dialog->nameFilters().size(), 3);
}

void TestWindowPast::recordingIntoAFileIsSeen() {
    const auto *sign = m_fixture->find<QLabel>("time_recording");
    m_fixture->window().refresh();
    QVERIFY(!sign->isVisible());
    session().startRecording(m_fixture->path("live.rec"));
    m_fixture->window().refresh();
    QVERIFY(sign->isVisible());
}

QTEST_MAIN(TestWindowPast)
#include "tst_window_past.moc"
