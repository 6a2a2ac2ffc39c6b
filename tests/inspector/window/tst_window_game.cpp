// SPDX-License-Identifier: MIT
// The game from the first prompt to the tenth level, and the messages when something fails.
#include "gl/view/maze_view.h"
#include "inspector/stepping.h"
#include "ui/game/clock_text.h"
#include "ui/game/game_strip.h"
#include "ui/parts/message_bar.h"
#include "ui/window/unattended_run.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

using namespace window_test;
using inspector::Game;

class TestWindowGame : public WindowSuite {
    Q_OBJECT

private slots:
    void promptIsShownAtTheStart();
    void clockIsShownWhilePlaying();
    void pauseIsSaid();
    void restartOfAPausedGamePrompts();
    void runWithoutTheGameSaysHowToPlay();
    void longStepSaysWhenTheNextOneComes();
    void levelAfterTheAutopilotsIsLevel();
    void autopilotWinsALevel_data();
    void autopilotWinsALevel();
    void enterGoesOnToTheNextLevel();
    void afterTheLastComesTheFirst();
    void bestTimeIsListed();
    void newBestTimeIsSaid();
    void restartAfterAWinPrompts();
    void clickOnALevelOpensIt();
    void ownLevelsHaveTheirNames();
    void refusedLevelIsNotMarked();
    void fileThatIsNoMazeIsShownAndChangesNothing();
    void failedStepIsShownAndPauses();
    void messageIsDismissed();
    void refusedCommandIsForgottenWithTheNextThatWorks();
    void failedStepIsForgottenAtARestart();
    void failedStepStaysWhileTheKeysTilt();
    void nothingTheGameSaysMovesTheView();
    void escClosesTheResultAndSaysHowToGoOn();
    void clickClosesTheResult();
    void defaultPhysicsSetABestTime();
    void otherPhysicsSetNoBestTimeAndSayWhy_data();
    void otherPhysicsSetNoBestTimeAndSayWhy();
    void goingOnAtTheEndOfAWonRecordingIsAWin();
    void goingOnInThePastAfterTheExitIsAWin();
    void afterAWinAllViewsShowOneMoment();
    void unattendedRunEndsWhenTheLevelIsWon();
    void windowIsGrabbedToAFile();
    void pictureLeavesOutWhatTheClockMeasures();

private:
    const inspector::ui::GameText &text();
    void win();
    void openBrokenFile();
    void openOwnLevels(const QTemporaryDir &folder);
    void leaveByHand();
    bool isOneMoment();
};

const inspector::ui::GameText &TestWindowGame::text() {
    m_fixture->window().refresh();
    return m_fixture->find<inspector::ui::GameStrip>("game_strip")->text();
}

void TestWindowGame::win() {
    m_fixture->session().setSpeed(inspector::Simulation::kFastest);
    m_fixture->session().setAutopilot(true);
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->game().phase(), Game::Phase::Won);
}

void TestWindowGame::promptIsShownAtTheStart() {
    QCOMPARE(text().title, QString("Level 1"));
    QCOMPARE(text().line, QString("Press Enter to start"));
}

void TestWindowGame::clockIsShownWhilePlaying() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(text().clock > QString("0:00.00"));
    QCOMPARE(text().title, QString("Level 1"));
    QVERIFY(text().line.isEmpty());
    QCOMPARE(text().hint, QString("Arrow keys or sliders tilt the board · Space: pause"));
}

void TestWindowGame::pauseIsSaid() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    m_fixture->press(Qt::Key_Escape);
    QTRY_COMPARE(text().title, QString("Paused"));
}

void TestWindowGame::restartOfAPausedGamePrompts() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    m_fixture->press(Qt::Key_Space);
    QTRY_COMPARE(text().title, QString("Paused"));
    m_fixture->press(Qt::Key_R);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(0));
    QCOMPARE(text().title, QString("Level 1"));
    QCOMPARE(text().line, QString("Press Enter to start"));
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    QVERIFY(m_fixture->simulation().latest().running);
}

void TestWindowGame::runWithoutTheGameSaysHowToPlay() {
    m_fixture->press(Qt::Key_Space);
    QTRY_COMPARE(text().line, QString("Free run"));
    QCOMPARE(text().title, QString("Level 1"));
    QCOMPARE(text().hint, QString("Arrow keys or sliders tilt the board · Enter: play"));
    m_fixture->press(Qt::Key_R);
    m_fixture->press(Qt::Key_Space);
    QTRY_COMPARE(m_fixture->simulation().latest().running, false);
    m_fixture->makeSteps(1);
    QCOMPARE(text().title, QString("Paused"));
}

void TestWindowGame::longStepSaysWhenTheNextOneComes() {
    chooseDt(m_fixture->session(), 10.0);
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(text().hint.startsWith("One step of dt takes 10 s · the next one in "));
    m_fixture->press(Qt::Key_Space);
    QTRY_VERIFY(!text().hint.startsWith("One step"));
}

void TestWindowGame::levelAfterTheAutopilotsIsLevel() {
    win();
    QVERIFY(m_fixture->simulation().latest().inputs.tilt.x != 0.0);
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(0));
    QCOMPARE(m_fixture->simulation().latest().inputs.tilt.x, 0.0);
}

void TestWindowGame::autopilotWinsALevel_data() {
    QTest::addColumn<int>("level");
    for (const int level : {1, 5, 10}) QTest::addRow("level %d", level) << level;
}

void TestWindowGame::autopilotWinsALevel() {
    QFETCH(int, level);
    m_fixture->game().choose(level - 1);
    win();
    QCOMPARE(text().title, QStringLiteral("Level %1 done").arg(level));
    QVERIFY(m_fixture->game().time() > 1.0);
}

void TestWindowGame::enterGoesOnToTheNextLevel() {
    win();
    m_fixture->press(Qt::Key_Return);
    QCOMPARE(m_fixture->game().level(), 1);
    QTRY_COMPARE(text().title, QString("Level 2"));
    QCOMPARE(m_fixture->find<QTreeWidget>("levels")->currentItem()->text(0), QString("Level 2"));
}

void TestWindowGame::afterTheLastComesTheFirst() {
    m_fixture->game().choose(int(m_fixture->session().levels().listed().size()) - 1);
    win();
    QVERIFY2(text().hint.contains("Level 1 "), qPrintable(text().hint));
    m_fixture->press(Qt::Key_Return);
    QCOMPARE(m_fixture->game().level(), 0);
}

// A player's win, at the time that the simulation would have reported.
void TestWindowGame::bestTimeIsListed() {
    m_fixture->press(Qt::Key_Return);
    m_fixture->game().leaveMaze(83.456, false);
    QCOMPARE(m_fixture->find<QTreeWidget>("levels")->topLevelItem(0)->text(1), QString("1:23.45"));
}

void TestWindowGame::newBestTimeIsSaid() {
    const auto winIn = [this](double time) {
        m_fixture->key(Qt::Key_Return);
        m_fixture->game().leaveMaze(time, false);
        QString said = QStringLiteral("%1 %2").arg(text().clock, text().line);
        m_fixture->key(Qt::Key_R);
        return said;
    };
    QCOMPARE(winIn(83.456), QString("1:23.45 a new best time"));
    QCOMPARE(winIn(90.0), QString("1:30.00 best time 1:23.45"));
    QCOMPARE(winIn(83.0), QString("1:23.00 a new best time"));
}

void TestWindowGame::restartAfterAWinPrompts() {
    win();
    m_fixture->press(Qt::Key_R);
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Prompt);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, 0u);
}

void TestWindowGame::clickOnALevelOpensIt() {
    auto *levels = m_fixture->find<QTreeWidget>("levels");
    const QRect third = levels->visualItemRect(levels->topLevelItem(2));
    QTest::mouseClick(levels->viewport(), Qt::LeftButton, {}, third.center());
    QCOMPARE(m_fixture->game().level(), 2);
    QCOMPARE(m_fixture->session().level().name, QString("03"));
    QTRY_COMPARE(text().title, QString("Level 3"));
}

// Three levels, of which the second can't be opened.
void TestWindowGame::openOwnLevels(const QTemporaryDir &folder) {
    for (const char *name : {"3.txt", "007b.txt"}) QVERIFY(QFile::copy(LEVELS_FOLDER "/01.txt", folder.filePath(name)));
    QFile broken(folder.filePath("4.txt"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("physics-maze 1\nbox 1 2\n") > 0);
    broken.close();
    QVERIFY(open(1, inspector::gl::Drawing::Flat, folder.path()));
}

void TestWindowGame::ownLevelsHaveTheirNames() {
    const QTemporaryDir folder;
    openOwnLevels(folder);
    const auto *levels = m_fixture->find<QTreeWidget>("levels");
    QStringList names;
    for (int i = 0; i < levels->topLevelItemCount(); ++i) names += levels->topLevelItem(i)->text(0);
    QCOMPARE(names, QStringList({"Level 3", "Level 4", "007b"}));
    QCOMPARE(text().title, QString("Level 3"));
    leaveByHand();
    m_fixture->press(Qt::Key_Return);
    QVERIFY2(m_fixture->window().messages().line().contains("4.txt"), "it is refused");
    QTRY_VERIFY2(text().hint.startsWith("Enter: 007b"), qPrintable(text().hint));
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE(text().title, QString("007b"));
    QCOMPARE(m_fixture->window().windowTitle(), QString("007b – Physics inspector"));
}

// The press selects its row after the level was refused.
void TestWindowGame::refusedLevelIsNotMarked() {
    const QTemporaryDir folder;
    openOwnLevels(folder);
    auto *levels = m_fixture->find<QTreeWidget>("levels");
    const QRect second = levels->visualItemRect(levels->topLevelItem(1));
    QTest::mouseClick(levels->viewport(), Qt::LeftButton, {}, second.center());
    QVERIFY(m_fixture->window().messages().line().contains("4.txt"));
    QTRY_COMPARE(levels->selectedItems(), QList<QTreeWidgetItem *>{levels->topLevelItem(0)});
    QCOMPARE(levels->currentItem(), levels->topLevelItem(0));
}

void TestWindowGame::openBrokenFile() {
    QFile file(m_fixture->path("broken.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("physics-maze 1\nunits m\nball nonsense\n");
    file.close();
    QVERIFY(!m_fixture->session().openLevel(inspector::levelOfFile(file.fileName())));
}

void TestWindowGame::fileThatIsNoMazeIsShownAndChangesNothing() {
    openBrokenFile();
    const QString line = m_fixture->window().messages().line();
    QVERIFY2(line.contains("broken.txt") && line.contains("3"), qPrintable(line));
    QVERIFY(m_fixture->window().messages().isVisible());
    QCOMPARE(m_fixture->session().level().name, QString("01"));
    QVERIFY(!QApplication::activeModalWidget());
}

// A ball too fast for the allowed number of substeps.
void TestWindowGame::failedStepIsShownAndPauses() {
    phys_state state = m_fixture->simulation().latest().current;
    state.velocity.x = 1e6;
    m_fixture->simulation().setState(state);
    m_fixture->simulation().run();
    QTRY_VERIFY(!m_fixture->window().messages().line().isEmpty());
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QVERIFY(!QApplication::activeModalWidget());
}

void TestWindowGame::messageIsDismissed() {
    m_fixture->window().messages().showLine("something", inspector::ui::Cause::Command);
    QVERIFY(m_fixture->window().messages().isVisible());
    click(m_fixture->find<QToolButton>("dismiss"));
    QVERIFY(!m_fixture->window().messages().isVisible());
    QVERIFY(m_fixture->window().messages().line().isEmpty());
}

void TestWindowGame::refusedCommandIsForgottenWithTheNextThatWorks() {
    openBrokenFile();
    QVERIFY(m_fixture->window().messages().isVisible());
    m_fixture->game().choose(2);
    QVERIFY(!m_fixture->window().messages().isVisible());
}

void TestWindowGame::failedStepIsForgottenAtARestart() {
    phys_state state = m_fixture->simulation().latest().current;
    state.velocity.x = 1e6;
    m_fixture->simulation().setState(state);
    m_fixture->trigger("step");
    QTRY_VERIFY(m_fixture->window().messages().isVisible());
    m_fixture->key(Qt::Key_R);
    QTRY_VERIFY(!m_fixture->window().messages().isVisible());
}

// The board levels itself, which isn't a command of the user.
void TestWindowGame::failedStepStaysWhileTheKeysTilt() {
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().running);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    QTRY_VERIFY(m_fixture->simulated("tilt_y") > 4.0);
    phys_state state = m_fixture->simulation().latest().current;
    state.velocity.x = 1e6;
    m_fixture->simulation().setState(state);
    QTRY_VERIFY(m_fixture->window().messages().isVisible());
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Up);
    QTRY_COMPARE(m_fixture->simulated("tilt_y"), 0.0);
    QVERIFY(m_fixture->window().messages().isVisible());
}

// Nothing covers the board, and nothing makes it jump.
void TestWindowGame::nothingTheGameSaysMovesTheView() {
    const QWidget &view = m_fixture->window().view();
    const QRect place(view.mapTo(&m_fixture->window(), QPoint()), view.size());
    const auto isSame = [&] {
        m_fixture->window().refresh();
        const auto *strip = m_fixture->find<QWidget>("game_strip");
        const QRect said(strip->mapTo(&m_fixture->window(), QPoint()), strip->size());
        return !said.intersects(place) && place == QRect(view.mapTo(&m_fixture->window(), QPoint()), view.size());
    };
    QVERIFY(isSame()); // the prompt
    m_fixture->key(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    QVERIFY(isSame());
    m_fixture->key(Qt::Key_Space);
    QTRY_COMPARE(text().title, QString("Paused"));
    QVERIFY(isSame());
    leaveByHand();
    QVERIFY(isSame());
}

// Leaves the maze in one step of a game that a user plays.
void TestWindowGame::leaveByHand() {
    if (m_fixture->game().phase() != Game::Phase::Playing) m_fixture->key(Qt::Key_Return);
    phys_state state = m_fixture->simulation().latest().current;
    state.position.x += 10.0;
    m_fixture->simulation().setState(state);
    m_fixture->simulation().stepOnce();
    QTRY_COMPARE(m_fixture->game().phase(), Game::Phase::Won);
}

void TestWindowGame::escClosesTheResultAndSaysHowToGoOn() {
    leaveByHand();
    QCOMPARE(text().title, QString("Level 1 done"));
    m_fixture->key(Qt::Key_Escape);
    for (int i = 0; i < 2; ++i) { // it stays closed
        QVERIFY(!text().isResult);
        QCOMPARE(text().line, QString());
        QCOMPARE(text().hint, QString("Level 1 done · a new best time · Enter: Level 2 · R: again"));
        QCOMPARE(text().clock, inspector::ui::clockText(m_fixture->game().time()));
    }
}

void TestWindowGame::clickClosesTheResult() {
    leaveByHand();
    QVERIFY(text().isResult);
    click(m_fixture->find<QWidget>("game_strip"));
    QVERIFY(!text().isResult);
}

void TestWindowGame::defaultPhysicsSetABestTime() {
    leaveByHand();
    QVERIFY(m_fixture->game().bestTime(0).has_value());
    QVERIFY2(text().line.endsWith("a new best time"), qPrintable(text().line));
}

void TestWindowGame::otherPhysicsSetNoBestTimeAndSayWhy_data() {
    QTest::addColumn<QString>("what");
    for (const char *what : {"gravity", "stepper", "dt", "speed"}) QTest::newRow(what) << what;
}

void TestWindowGame::otherPhysicsSetNoBestTimeAndSayWhy() {
    QFETCH(QString, what);
    m_fixture->key(Qt::Key_Return);
    if (what == "gravity") m_fixture->parameters().set({{what, 3.0}});
    if (what == "stepper") chooseStepper(m_fixture->session(), "rk4");
    if (what == "dt") chooseDt(m_fixture->session(), 0.005);
    if (what == "speed") m_fixture->session().setSpeed(0.5);
    m_fixture->parameters().set({{"gravity", 9.81}}); // too late
    leaveByHand();
    QVERIFY(!m_fixture->game().bestTime(0).has_value());
    QVERIFY2(text().line.contains("no best time"), qPrintable(text().line));
}

// The time of the exit counts, not that of the end of the fall.
void TestWindowGame::goingOnAtTheEndOfAWonRecordingIsAWin() {
    win();
    const double time = m_fixture->game().time();
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QVERIFY(m_fixture->session().saveRun(m_fixture->path("won.rec"), nullptr));
    m_fixture->drop(m_fixture->path("won.rec"));
    QTRY_VERIFY(m_fixture->session().isReplaying());
    m_fixture->key(Qt::Key_End, Qt::ControlModifier);
    QTRY_VERIFY(m_fixture->simulation().latest().replay.position > 0 &&
                m_fixture->simulation().latest().replay.position == m_fixture->simulation().latest().replay.end);
    m_fixture->key(Qt::Key_G);
    QTRY_COMPARE(text().title, QString("Level 1 done"));
    QCOMPARE(m_fixture->game().time(), time);
    QVERIFY2(text().line.contains("no best time"), qPrintable(text().line));
}

void TestWindowGame::goingOnInThePastAfterTheExitIsAWin() {
    win();
    const double time = m_fixture->game().time();
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    m_fixture->key(Qt::Key_Comma);
    QVERIFY(m_fixture->session().isInPast());
    m_fixture->key(Qt::Key_G);
    QVERIFY(!m_fixture->session().isInPast());
    QTRY_COMPARE(text().title, QString("Level 1 done"));
    QCOMPARE(m_fixture->game().time(), time);
}

// The watched speed is the ball's.
bool TestWindowGame::isOneMoment() {
    m_fixture->window().refresh();
    const inspector::Snapshot now = m_fixture->simulation().latest();
    const QTreeWidget *list = m_fixture->find<QTreeWidget>("watched");
    const phys_vec3 &v = now.current.velocity;
    const double speed = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    const double watched = list->findItems("Speed", Qt::MatchExactly).value(0)->text(1).toDouble();
    return std::abs(watched - speed) < 1e-5 * speed;
}

void TestWindowGame::afterAWinAllViewsShowOneMoment() {
    m_fixture->trigger("show_watch_dock");
    win();
    QTRY_VERIFY(!m_fixture->simulation().latest().running);
    QVERIFY(isOneMoment());
    const uint64_t end = m_fixture->simulation().latest().current.step;
    QVERIFY(m_fixture->session().saveRun(m_fixture->path("won.rec"), nullptr));
    m_fixture->key(Qt::Key_Comma);
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, end - 1);
    QVERIFY(isOneMoment());

    m_fixture->drop(m_fixture->path("won.rec"));
    QTRY_VERIFY(m_fixture->session().isReplaying());
    m_fixture->key(Qt::Key_End, Qt::ControlModifier);
    QTRY_COMPARE(m_fixture->simulation().latest().replay.position, end);
    QVERIFY(isOneMoment());
}

void TestWindowGame::unattendedRunEndsWhenTheLevelIsWon() {
    inspector::Options options;
    options.autopilot = true;
    options.grab = m_fixture->path("won.png");
    m_fixture->session().setSpeed(inspector::Simulation::kFastest);
    m_fixture->session().setAutopilot(true);
    inspector::ui::UnattendedRun run(m_fixture->session(), options);
    QSignalSpy finished(&run, &inspector::ui::UnattendedRun::finished);
    run.start();
    QVERIFY(finished.wait(kPatience));
    QCOMPARE(finished[0][0].toString(), QString());
    QCOMPARE(m_fixture->game().phase(), Game::Phase::Won);
}

void TestWindowGame::windowIsGrabbedToAFile() {
    QString error;
    QVERIFY(m_fixture->window().grabTo(m_fixture->path("window.png"), &error));
    const QSize size = QImage(m_fixture->path("window.png")).size();
    QCOMPARE(size, m_fixture->window().size() * m_fixture->window().devicePixelRatio());
    QVERIFY(!m_fixture->window().grabTo(m_fixture->path("missing/window.png"), &error));
    QVERIFY2(error.contains("missing/window.png"), qPrintable(error));
}

void TestWindowGame::pictureLeavesOutWhatTheClockMeasures() {
    QVERIFY(m_fixture->window().grabTo(m_fixture->path("window.png"), nullptr));
    QCOMPARE(m_fixture->window().findChild<QLabel *>("status_lost")->text(), QString("Lost: –"));
    QCOMPARE(m_fixture->window().findChild<QLabel *>("status_rate")->text(), QString("Steps/s: –"));
    m_fixture->window().refresh();
    QCOMPARE(m_fixture->window().findChild<QLabel *>("status_rate")->text(), QString("Steps/s: 0"));
}

QTEST_MAIN(TestWindowGame)
#include "tst_window_game.moc"
