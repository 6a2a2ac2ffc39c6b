// SPDX-License-Identifier: MIT
// How a game ends: what counts as a win, and how long the run took, the same everywhere.
#include "ui/game/clock_text.h"
#include "ui/plots/plot_stack.h"
#include "window_fixture.h"

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QTreeWidget>

#include <algorithm>
#include <memory>

#include <qcustomplot.h>

using namespace window_test;
using inspector::Game;

class TestWindowEndings : public WindowSuite {
    Q_OBJECT

private slots:
    void fallThroughTheBoardIsNoWin_data();
    void fallThroughTheBoardIsNoWin();
    void lostGameBeginsAgain();
    void wayOverTheRimSetsNoBestTime();
    void impossibleStartIsSaid_data();
    void impossibleStartIsSaid();
    void mazeWithoutABoardSaysSo();
    void runBesideTheBoardIsNoWin();
    void bestTimeThatCantBeStoredIsSaid();
    void runsAndClockShowTheTimeOfTheResult();
    void nothingIsLeftToRunAfterAWin();
    void fallAfterARunLeavesItsCurvesTheirHeight();

private:
    void drop(const QByteArray &maze);
    QString strip(); // all of its text
    void playToTheRight(const char *said);
    void winByAutopilot();
};

namespace {

const QByteArray kMazeHead = "physics-maze 1\nunits m\nball 0.006\nstart -0.072 0 0.006\n";
const QByteArray kWholeFloor = "box -0.09 -0.09 -0.005 0.09 0.09 0\n";
const QByteArray kFloorWithGap = "box -0.09 -0.09 -0.005 0 0.09 0\nbox 0.04 -0.09 -0.005 0.09 0.09 0\n";
const QByteArray kThreeRims = "box -0.095 -0.095 -0.005 -0.09 0.095 0.014\nbox -0.09 -0.095 -0.005 0.09 -0.09 0.014\n"
                              "box -0.09 0.09 -0.005 0.09 0.095 0.014\n";
const QByteArray kRightRim = "box 0.09 -0.095 -0.005 0.095 0.095 0.014\n";

QByteArray headWithStart(const char *place) {
    QByteArray head = kMazeHead;
    return head.replace("-0.072 0 0.006", place);
}

} // namespace

void TestWindowEndings::drop(const QByteArray &maze) {
    QFile file(m_fixture->path("mine.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(maze) == maze.size());
    file.close();
    m_fixture->drop(file.fileName());
    QCOMPARE(m_fixture->session().level().path, file.fileName());
}

QString TestWindowEndings::strip() {
    m_fixture->window().refresh();
    QStringList texts;
    for (const QLabel *label : m_fixture->find<QFrame>("game_strip")->findChildren<QLabel *>()) texts << label->text();
    return texts.join(' ');
}

// Until the strip says it.
void TestWindowEndings::playToTheRight(const char *said) {
    m_fixture->press(Qt::Key_Return);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Right);
    QTRY_VERIFY2(strip().contains(said), qPrintable(strip()));
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Right);
}

void TestWindowEndings::fallThroughTheBoardIsNoWin_data() {
    QTest::addColumn<QByteArray>("maze");
    QTest::newRow("no way out") << kMazeHead + kFloorWithGap + kThreeRims + kRightRim;
    QTest::newRow("hole before the way out") << kMazeHead + kFloorWithGap + kThreeRims;
    QTest::newRow("straight down") << headWithStart("0.02 0 0.006") + kFloorWithGap + kThreeRims + kRightRim;
}

void TestWindowEndings::fallThroughTheBoardIsNoWin() {
    QFETCH(QByteArray, maze);
    drop(maze);
    playToTheRight("through a hole");
    QVERIFY2(!strip().contains("done") && !strip().contains("best time"), qPrintable(strip()));
    QVERIFY(!m_fixture->game().bestTime());
    m_fixture->trigger("show_runs_dock");
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->find<QTreeWidget>("runs")->topLevelItem(0)->text(4), QString("through a hole"));
}

void TestWindowEndings::lostGameBeginsAgain() {
    drop(kMazeHead + kFloorWithGap + kThreeRims + kRightRim);
    playToTheRight("Enter: again");
    m_fixture->press(Qt::Key_Return);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Playing);
    QTRY_VERIFY(m_fixture->simulation().latest().current.position.x < -0.05);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
}

// The ball can't roll out, but be thrown.
void TestWindowEndings::wayOverTheRimSetsNoBestTime() {
    drop("physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\n" + kWholeFloor + kThreeRims + kRightRim);
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    phys_state state = m_fixture->simulation().latest().current;
    state.position.x = 1.0;
    m_fixture->simulation().setState(state);
    QTRY_COMPARE(m_fixture->game().phase(), Game::Phase::Won);
    QVERIFY2(strip().contains("no best time: this maze has no way out"), qPrintable(strip()));
    QVERIFY(!m_fixture->game().bestTime());
}

void TestWindowEndings::impossibleStartIsSaid_data() {
    QTest::addColumn<QByteArray>("start");
    QTest::addColumn<QString>("said");
    QTest::newRow("beside") << headWithStart("-0.5 0 0.006") << "the ball starts beside the board";
    QTest::newRow("below") << headWithStart("0 0 -0.2") << "the ball starts below the board";
    QTest::newRow("floor") << headWithStart("-0.072 0 0") << "the ball starts in a box";
    QTest::newRow("wall") << headWithStart("-0.0925 0 0.006") << "the ball starts in a box";
    QTest::newRow("possible") << kMazeHead << "this maze has no way out";
}

void TestWindowEndings::impossibleStartIsSaid() {
    QFETCH(QByteArray, start);
    QFETCH(QString, said);
    drop(start + kWholeFloor + kThreeRims + kRightRim);
    QTRY_VERIFY2(strip().contains(said), qPrintable(strip()));
    QCOMPARE(strip().contains("the ball starts"), said.startsWith("the ball"));
}

void TestWindowEndings::mazeWithoutABoardSaysSo() {
    drop(kMazeHead);
    QTRY_VERIFY2(strip().contains("Press Enter to start") && strip().contains("this maze has no board"),
                 qPrintable(strip()));
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->game().phase(), Game::Phase::Lost);
    QTRY_VERIFY2(strip().contains("lost") && strip().contains("this maze has no board"), qPrintable(strip()));
}

void TestWindowEndings::runBesideTheBoardIsNoWin() {
    drop(headWithStart("-0.5 0 0.006") + kWholeFloor + kThreeRims);
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->game().phase() != Game::Phase::Playing);
    QVERIFY2(!strip().contains("done") && !strip().contains("best time"), qPrintable(strip()));
    QVERIFY2(strip().contains("the ball starts beside the board"), qPrintable(strip()));
    QVERIFY(!m_fixture->game().bestTime());
}

void TestWindowEndings::bestTimeThatCantBeStoredIsSaid() {
    const QString file = m_fixture->settings().fileName();
    m_fixture->settings().sync();
    QVERIFY(QFile::remove(file) && QDir().mkdir(file));
    drop(kMazeHead + kWholeFloor + kThreeRims);
    playToTheRight("a new best time, which can't be stored");
}

// Until the ball has fallen.
void TestWindowEndings::winByAutopilot() {
    m_fixture->session().setSpeed(inspector::Simulation::kFastest);
    m_fixture->session().setAutopilot(true);
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->game().phase(), Game::Phase::Won);
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
}

// The ball falls for a while after it has left.
void TestWindowEndings::runsAndClockShowTheTimeOfTheResult() {
    m_fixture->trigger("show_runs_dock");
    winByAutopilot();
    const QString time = inspector::ui::clockText(m_fixture->game().time());
    const double end = m_fixture->simulation().latest().current.time;
    QVERIFY(inspector::ui::clockText(end) != time);
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->find<QTreeWidget>("runs")->topLevelItem(0)->text(3), time);
    m_fixture->press(Qt::Key_Comma);
    QTRY_VERIFY(m_fixture->session().isInPast() && m_fixture->simulation().latest().current.time < end);
    QTRY_VERIFY2(strip().contains(time), qPrintable(strip()));
    const QString file = m_fixture->path("won.rec");
    m_fixture->press(Qt::Key_S, Qt::ControlModifier);
    m_fixture->answerFile(file);
    m_fixture->drop(file);
    QTRY_VERIFY(m_fixture->session().isReplaying());
    m_fixture->press(Qt::Key_End, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulation().latest().current.time, end);
    QTRY_VERIFY2(strip().contains(time), qPrintable(strip()));
}

// Space would make a single step.
void TestWindowEndings::nothingIsLeftToRunAfterAWin() {
    QVERIFY(m_fixture->find<QAction>("run")->isEnabled());
    winByAutopilot();
    const uint64_t end = m_fixture->simulation().latest().current.step;
    QTRY_VERIFY(!m_fixture->find<QAction>("run")->isEnabled());
    m_fixture->press(Qt::Key_Space);
    m_fixture->press(Qt::Key_Comma);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, end - 1);
    QTRY_VERIFY(m_fixture->find<QAction>("run")->isEnabled()); // plays the past
    m_fixture->press(Qt::Key_End, Qt::ControlModifier);
    QTRY_VERIFY(!m_fixture->find<QAction>("run")->isEnabled());
    m_fixture->press(Qt::Key_R);
    QTRY_VERIFY(m_fixture->find<QAction>("run")->isEnabled());
}

void TestWindowEndings::fallAfterARunLeavesItsCurvesTheirHeight() {
    winByAutopilot();
    const double left = m_fixture->game().time();
    const inspector::SampleRing &samples = m_fixture->simulation().samples();
    double before = 0.0;
    double after = 0.0;
    inspector::Sample sample;
    for (uint64_t number = samples.first(); number < samples.last(); ++number) {
        QVERIFY(samples.read(number, sample));
        double &largest = sample.time <= left ? before : after;
        largest = std::max(largest, sample[inspector::Channel::Speed]);
    }
    QVERIFY(after > 2.0 * before);
    m_fixture->window().refresh();
    const QCPRange range = m_fixture->find<inspector::ui::PlotStack>("plots")->first().yAxis->range();
    QVERIFY2(range.upper >= before && range.upper < 1.2 * before, qPrintable(QString::number(range.upper / before)));
}

QTEST_MAIN(TestWindowEndings)
#include "tst_window_endings.moc"
