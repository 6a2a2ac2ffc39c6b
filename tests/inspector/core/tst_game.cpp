// SPDX-License-Identifier: MIT
// The rules of the game.
#include "core/session/game.h"
#include "core/setup/settings_file.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace inspector;

namespace {

const QStringList kMazes{"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"};

} // namespace

class TestGame : public QObject {
    Q_OBJECT

private slots:
    void init();
    void beginsWithThePromptOfTheFirstLevel();
    void enterStartsTheLevelOnce();
    void leavingTheMazeWhilePlayingWins();
    void leavingTheMazeAtThePromptCountsNothing();
    void secondLeavingCountsNothing();
    void lostGameHasNoBestTimeAndBeginsAgain();
    void enterAfterAWinAsksForTheNextLevel();
    void afterTheLastLevelTheFirstComesAgain();
    void levelThatCannotBeOpenedIsPassedOver();
    void noLevelFollowsAMazeThatIsNotInTheList();
    void choosingAsksForThatLevel();
    void levelsThatDontExistAreIgnored();
    void firstTimeIsARecord();
    void slowerTimeIsNoRecordAndIsNotKept();
    void fasterTimeReplacesTheRecord();
    void assistedRunSetsNoRecord();
    void bestTimesOutliveTheGame();
    void bestTimesBelongToTheMazeNotToItsNumber();
    void theBetterOfTwoWindowsTimesStays();
    void spoiltSettingIsNoBestTime();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_settings;
    std::unique_ptr<Game> m_game;
};

void TestGame::init() {
    m_game.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<QSettings>(m_folder->filePath("settings.ini"), settingsFormat());
    m_game = std::make_unique<Game>(kMazes, *m_settings);
}

void TestGame::beginsWithThePromptOfTheFirstLevel() {
    QCOMPARE(m_game->phase(), Game::Phase::Prompt);
    QCOMPARE(m_game->level(), 0);
    QVERIFY(!m_game->bestTime(0));
}

void TestGame::enterStartsTheLevelOnce() {
    QSignalSpy started(m_game.get(), &Game::started);
    m_game->confirm();
    m_game->confirm();
    QCOMPARE(started.count(), 1);
    QCOMPARE(m_game->phase(), Game::Phase::Playing);
}

void TestGame::leavingTheMazeWhilePlayingWins() {
    m_game->confirm();
    m_game->leaveMaze(12.34, false);
    QCOMPARE(m_game->phase(), Game::Phase::Won);
    QCOMPARE(m_game->time(), 12.34);
}

void TestGame::leavingTheMazeAtThePromptCountsNothing() {
    m_game->leaveMaze(12.34, false);
    QCOMPARE(m_game->phase(), Game::Phase::Prompt);
    QVERIFY(!m_game->bestTime(0));
}

void TestGame::secondLeavingCountsNothing() {
    m_game->confirm();
    m_game->leaveMaze(12.0, false);
    m_game->leaveMaze(1.0, false);
    QCOMPARE(m_game->time(), 12.0);
}

void TestGame::lostGameHasNoBestTimeAndBeginsAgain() {
    m_game->confirm();
    m_game->lose(1.0);
    QCOMPARE(m_game->phase(), Game::Phase::Lost);
    QCOMPARE(m_game->time(), 1.0);
    QVERIFY(!m_game->isRecord() && !m_game->bestTime());
    QSignalSpy started(m_game.get(), &Game::started);
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->confirm();
    QCOMPARE(m_game->phase(), Game::Phase::Playing);
    QCOMPARE(started.count(), 1);
    QCOMPARE(wanted.count(), 0);
}

void TestGame::enterAfterAWinAsksForTheNextLevel() {
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->confirm();
    m_game->leaveMaze(12.0, false);
    m_game->confirm();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toInt(), 1);
    m_game->prompt(1); // opened
    QCOMPARE(m_game->phase(), Game::Phase::Prompt);
    QCOMPARE(m_game->level(), 1);
    QCOMPARE(m_game->time(), 0.0);
}

void TestGame::afterTheLastLevelTheFirstComesAgain() {
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->prompt(9);
    m_game->confirm();
    m_game->leaveMaze(12.0, false);
    m_game->confirm();
    QCOMPARE(wanted[0][0].toInt(), 0);
}

void TestGame::levelThatCannotBeOpenedIsPassedOver() {
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->confirm();
    m_game->leaveMaze(12.0, false);
    m_game->confirm(); // wants the second, which isn't opened
    QCOMPARE(m_game->nextLevel(), 2);
    m_game->confirm();
    QCOMPARE(wanted[1][0].toInt(), 2);
    m_game->prompt(2);
    QCOMPARE(m_game->nextLevel(), 3);
}

void TestGame::noLevelFollowsAMazeThatIsNotInTheList() {
    QSignalSpy levels(m_game.get(), &Game::levelWanted);
    QSignalSpy again(m_game.get(), &Game::againWanted);
    m_game->prompt(-1, "own");
    m_game->confirm();
    m_game->leaveMaze(1.0, false);
    m_game->confirm();
    QCOMPARE(levels.count(), 0);
    QCOMPARE(again.count(), 1);
}

void TestGame::choosingAsksForThatLevel() {
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->choose(6);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toInt(), 6);
    QCOMPARE(m_game->level(), 0); // not before it is open
}

void TestGame::levelsThatDontExistAreIgnored() {
    QSignalSpy wanted(m_game.get(), &Game::levelWanted);
    m_game->choose(-1);
    m_game->choose(10);
    m_game->prompt(10);
    QCOMPARE(wanted.count(), 0);
    QCOMPARE(m_game->level(), 0);
}

void TestGame::firstTimeIsARecord() {
    m_game->confirm();
    m_game->leaveMaze(12.0, false);
    QVERIFY(m_game->isRecord());
    QCOMPARE(m_game->bestTime(0), 12.0);
}

void TestGame::slowerTimeIsNoRecordAndIsNotKept() {
    for (const double time : {12.0, 13.0}) {
        m_game->prompt(0);
        m_game->confirm();
        m_game->leaveMaze(time, false);
    }
    QVERIFY(!m_game->isRecord());
    QCOMPARE(m_game->bestTime(0), 12.0);
}

void TestGame::fasterTimeReplacesTheRecord() {
    for (const double time : {12.0, 11.5}) {
        m_game->prompt(0);
        m_game->confirm();
        m_game->leaveMaze(time, false);
    }
    QVERIFY(m_game->isRecord());
    QCOMPARE(m_game->bestTime(0), 11.5);
}

void TestGame::assistedRunSetsNoRecord() {
    m_game->confirm();
    m_game->leaveMaze(1.0, true);
    QCOMPARE(m_game->phase(), Game::Phase::Won);
    QVERIFY(!m_game->isRecord());
    QVERIFY(!m_game->bestTime(0));
}

void TestGame::bestTimesOutliveTheGame() {
    m_game->prompt(2);
    m_game->confirm();
    m_game->leaveMaze(7.25, false);
    m_settings->sync();
    QSettings again(m_settings->fileName(), settingsFormat());
    const Game other(kMazes, again);
    QCOMPARE(other.bestTime(2), 7.25);
    QVERIFY(!other.bestTime(1));
}

void TestGame::bestTimesBelongToTheMazeNotToItsNumber() {
    m_game->confirm();
    m_game->leaveMaze(7.25, false);
    const Game other({"z", "a"}, *m_settings);
    QVERIFY(!other.bestTime(0));
    QCOMPARE(other.bestTime(1), 7.25);
}

void TestGame::theBetterOfTwoWindowsTimesStays() {
    QSettings settings(m_settings->fileName(), settingsFormat());
    Game other(kMazes, settings);
    QVERIFY(!other.bestTime(0)); // as it is when that window opens
    m_game->confirm();
    m_game->leaveMaze(5.0, false);
    other.confirm();
    other.leaveMaze(9.0, false);
    QVERIFY(!other.isRecord());
    const QSettings after(m_settings->fileName(), settingsFormat());
    QCOMPARE(after.value("best_times/a").toDouble(), 5.0);
}

void TestGame::spoiltSettingIsNoBestTime() {
    for (const char *text : {"soon", "-3", "0", "nan", "inf", "1e999", ""}) {
        m_settings->setValue("best_times/" + kMazes[0], text);
        QVERIFY2(!m_game->bestTime(0), text);
    }
}

QTEST_GUILESS_MAIN(TestGame)
#include "tst_game.moc"
