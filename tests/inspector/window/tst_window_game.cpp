// SPDX-License-Identifier: MIT
// The game from the first prompt to the tenth level, and what is said when something goes wrong.
#include "ui/game/game_overlay.h"
#include "ui/parts/message_bar.h"
#include "ui/window/unattended_run.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QImage>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

using namespace window_test;
using inspector::Game;

class TestWindowGame : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepare(); }

private slots:
    void init();
    void cleanup();
    void promptIsShownAtTheStart();
    void clockIsShownWhilePlaying();
    void pauseIsSaid();
    void promptHidesWhereTheBallRollsWithoutTheGame();
    void autopilotWinsALevel_data();
    void autopilotWinsALevel();
    void enterGoesOnToTheNextLevel();
    void afterTheTenthComesTheFirst();
    void bestTimeIsListed();
    void restartAfterAWinPrompts();
    void clickOnALevelOpensIt();
    void fileThatIsNoMazeIsShownAndChangesNothing();
    void failedStepIsShownAndPauses();
    void messageIsDismissed();
    void unattendedRunEndsWhenTheLevelIsWon();
    void windowIsGrabbedToAFile();

private:
    const inspector::ui::OverlayText &text();
    void win();

    std::unique_ptr<Fixture> m_fixture;
};

void TestWindowGame::init() {
    m_fixture = std::make_unique<Fixture>();
    QVERIFY(m_fixture->isReady());
}

void TestWindowGame::cleanup() { m_fixture.reset(); }

const inspector::ui::OverlayText &TestWindowGame::text() {
    m_fixture->window().refresh();
    return m_fixture->find<inspector::ui::GameOverlay>("game_overlay")->text();
}

void TestWindowGame::win() {
    m_fixture->session().setSpeed(inspector::Simulation::kFastest);
    m_fixture->session().setAutopilot(true);
    m_fixture->press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_fixture->game().phase(), Game::Phase::Won, 30000);
}

void TestWindowGame::promptIsShownAtTheStart() {
    QCOMPARE(text().title, QString("Level 1"));
    QCOMPARE(text().line, QString("Press Enter to start"));
}

void TestWindowGame::clockIsShownWhilePlaying() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(text().clock > QString("0:00.00"));
    QVERIFY(text().title.isEmpty());
}

void TestWindowGame::pauseIsSaid() {
    m_fixture->press(Qt::Key_Return);
    QTRY_VERIFY(m_fixture->simulation().latest().current.step > 0);
    m_fixture->press(Qt::Key_Escape);
    QTRY_COMPARE(text().title, QString("Paused"));
}

void TestWindowGame::promptHidesWhereTheBallRollsWithoutTheGame() {
    m_fixture->press(Qt::Key_Space);
    QTRY_COMPARE(text(), inspector::ui::OverlayText{});
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

void TestWindowGame::afterTheTenthComesTheFirst() {
    m_fixture->game().choose(9);
    win();
    QVERIFY2(text().hint.contains("level 1 "), qPrintable(text().hint));
    m_fixture->press(Qt::Key_Return);
    QCOMPARE(m_fixture->game().level(), 0);
}

// A person's win, at the second of the clock that the simulation would have told.
void TestWindowGame::bestTimeIsListed() {
    m_fixture->press(Qt::Key_Return);
    m_fixture->game().leaveMaze(83.456, false);
    QCOMPARE(m_fixture->find<QTreeWidget>("levels")->topLevelItem(0)->text(1), QString("1:23.45"));
    QVERIFY2(text().line.startsWith("1:23.45") && text().line.contains("best"), qPrintable(text().line));
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

void TestWindowGame::fileThatIsNoMazeIsShownAndChangesNothing() {
    QFile file(m_fixture->path("broken.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("physics-maze 1\nunits m\nball nonsense\n");
    file.close();
    QVERIFY(!m_fixture->session().openLevel(inspector::levelOfFile(file.fileName())));
    const QString line = m_fixture->window().messages().line();
    QVERIFY2(line.contains("broken.txt") && line.contains("3"), qPrintable(line));
    QVERIFY(m_fixture->window().messages().isVisible());
    QCOMPARE(m_fixture->session().level().name, QString("01"));
    QVERIFY(!QApplication::activeModalWidget());
}

// A ball that is faster than any number of substeps allows.
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
    m_fixture->window().messages().showLine("something");
    QVERIFY(m_fixture->window().messages().isVisible());
    click(m_fixture->find<QToolButton>("dismiss"));
    QVERIFY(!m_fixture->window().messages().isVisible());
    QVERIFY(m_fixture->window().messages().line().isEmpty());
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
    QVERIFY(finished.wait(30000));
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

QTEST_MAIN(TestWindowGame)
#include "tst_window_game.moc"
