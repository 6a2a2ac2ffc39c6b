// SPDX-License-Identifier: MIT
// The open objects together, used as the window uses them.
#include "core/session/session.h"
#include "core/setup/settings_file.h"
#include "inspector/stepping.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

using namespace inspector;

class TestSession : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void opensWhatTheOptionsAskFor();
    void missingLevelGivesOneLineAndNoSession();
    void changedParameterArrivesInTheSimulation();
    void enterStartsTheSimulationFromTheStart();
    void heldKeyTiltsTheParametersAndReleaseLevelsThem();
    void slidersTiltStaysWhileNoKeyIsHeld();
    void keysStartFromTheSlidersTilt();
    void autopilotWinsTheLevelWithoutARecord();
    void autopilotOffLevelsTheBoard();
    void nextLevelOpensAfterAWin();
    void levelThatCantBeReadChangesNothing();
    void unknownStepperChangesNothing();
    void otherStepperGoesOnFromTheSameState();
    void steppingIsSetAsAWhole();
    void refusedSteppingChangesNothing_data();
    void refusedSteppingChangesNothing();
    void paceOutOfRangeIsRefused_data();
    void paceOutOfRangeIsRefused();
    void levelBesideTheListKeepsTheGamesPlace();
    void pluginsAreLoadedAsTheOptionsSay();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_settings;
    std::unique_ptr<Session> m_session;
};

namespace {

Options optionsFor(int level) {
    Options options;
    options.registry = makeRegistry(nullptr);
    options.levels = levelsIn(LEVELS_FOLDER);
    options.level = options.levels[size_t(level) - 1];
    options.speed = Simulation::kFastest;
    return options;
}

} // namespace

void TestSession::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<QSettings>(m_folder->filePath("settings.ini"), settingsFormat());
    QString error;
    m_session = Session::open(optionsFor(1), *m_settings, &error);
    QVERIFY2(m_session, qPrintable(error));
}

void TestSession::cleanup() { m_session.reset(); }

void TestSession::opensWhatTheOptionsAskFor() {
    Options options = optionsFor(3);
    options.stepper = "rk4";
    options.dt = 0.005;
    options.speed = 2.0;
    options.settings = {{"tilt_x", 4.0}, {"rolling_friction", 0.01}};
    const auto session = Session::open(options, *m_settings, nullptr);
    QVERIFY(session);
    QCOMPARE(session->level().name, QString("03"));
    QCOMPARE(session->game().level(), 2);
    QCOMPARE(session->stepperId(), QByteArray("rk4"));
    QTRY_COMPARE(session->simulation().latest().dt, 0.005);
    QTRY_COMPARE(session->simulation().latest().statistics.speedAsked, 2.0);
    QTRY_COMPARE(session->simulation().latest().inputs.params.rolling_friction, 0.01);
    QCOMPARE(session->simulation().latest().inputs.tilt.x, radians(4.0));
    QVERIFY(!session->simulation().latest().running);
}

void TestSession::missingLevelGivesOneLineAndNoSession() {
    Options options = optionsFor(1);
    options.level = levelOfFile("nowhere/none.txt");
    QString error;
    QVERIFY(!Session::open(options, *m_settings, &error));
    QVERIFY2(error.contains("nowhere/none.txt"), qPrintable(error));
}

void TestSession::changedParameterArrivesInTheSimulation() {
    QVERIFY(m_session->parameters().set({{"restitution_wall", 0.125}}));
    QTRY_COMPARE(m_session->simulation().latest().inputs.params.restitution_wall, 0.125);
}

void TestSession::enterStartsTheSimulationFromTheStart() {
    m_session->simulation().stepOnce();
    QTRY_COMPARE(m_session->simulation().latest().current.step, uint64_t(1));
    m_session->game().confirm();
    QTRY_VERIFY(m_session->simulation().latest().running);
    QTRY_VERIFY(m_session->simulation().latest().current.step > 10);
    QCOMPARE(m_session->game().phase(), Game::Phase::Playing);
    Sample sample;
    QVERIFY(m_session->simulation().samples().read(m_session->simulation().samples().first(), sample));
    QCOMPARE(sample.step, uint64_t(1));
}

void TestSession::heldKeyTiltsTheParametersAndReleaseLevelsThem() {
    Parameters &parameters = m_session->parameters();
    const int tilt = parameters.indexOf("tilt_x");
    m_session->setKeys({.right = true});
    for (int i = 0; i < 100; ++i) m_session->advanceKeys(0.02);
    QVERIFY(std::abs(parameters.value(tilt) - kPlayTilt) < 1e-3); // 17 time constants
    m_session->setKeys({});
    for (int i = 0; i < 100; ++i) m_session->advanceKeys(0.02);
    QCOMPARE(parameters.value(tilt), 0.0);
}

void TestSession::slidersTiltStaysWhileNoKeyIsHeld() {
    Parameters &parameters = m_session->parameters();
    QVERIFY(parameters.set({{"tilt_x", 11.0}}));
    for (int i = 0; i < 100; ++i) m_session->advanceKeys(0.02);
    QCOMPARE(parameters.value(parameters.indexOf("tilt_x")), 11.0);
}

void TestSession::keysStartFromTheSlidersTilt() {
    Parameters &parameters = m_session->parameters();
    QVERIFY(parameters.set({{"tilt_x", 6.0}}));
    m_session->setKeys({.right = true});
    m_session->advanceKeys(0.001);
    QVERIFY(std::abs(parameters.value(parameters.indexOf("tilt_x")) - 6.0) < 0.01);
}

void TestSession::autopilotWinsTheLevelWithoutARecord() {
    QVERIFY(m_session->setAutopilot(true));
    m_session->game().confirm();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->game().phase(), Game::Phase::Won, 30000);
    QVERIFY(m_session->game().time() > 0.0);
    QVERIFY(!m_session->game().bestTime(0));
}

void TestSession::autopilotOffLevelsTheBoard() {
    QVERIFY(m_session->setAutopilot(true));
    m_session->simulation().stepOnce();
    QTRY_VERIFY(!(m_session->simulation().latest().inputs.tilt == Tilt{}));
    QVERIFY(m_session->setAutopilot(false));
    QTRY_VERIFY(m_session->simulation().latest().inputs.tilt == Tilt{});
}

void TestSession::nextLevelOpensAfterAWin() {
    QVERIFY(m_session->setAutopilot(true));
    m_session->game().confirm();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->game().phase(), Game::Phase::Won, 30000);
    QSignalSpy opened(m_session.get(), &Session::levelOpened);
    m_session->game().confirm();
    QCOMPARE(opened.count(), 1);
    QCOMPARE(m_session->level().name, QString("02"));
    QCOMPARE(m_session->game().level(), 1);
    QCOMPARE(m_session->game().phase(), Game::Phase::Prompt);
    QVERIFY(m_session->hasAutopilot()); // it plays on
    m_session->game().confirm();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->game().phase(), Game::Phase::Won, 30000);
}

void TestSession::levelThatCantBeReadChangesNothing() {
    QSignalSpy failed(m_session.get(), &Session::failed);
    const Scene before = m_session->scene();
    QVERIFY(!m_session->openLevel(levelOfFile("nowhere/none.txt")));
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed[0][0].toString().contains("nowhere/none.txt"));
    QCOMPARE(m_session->scene(), before);
    QCOMPARE(m_session->level().name, QString("01"));
}

void TestSession::unknownStepperChangesNothing() {
    QSignalSpy failed(m_session.get(), &Session::failed);
    QVERIFY(!chooseStepper(*m_session, "perpetual-motion"));
    QVERIFY(failed[0][0].toString().contains("perpetual-motion"));
    QCOMPARE(m_session->stepperId(), QByteArray(PHYS_STEPPER_DEFAULT));
}

void TestSession::otherStepperGoesOnFromTheSameState() {
    m_session->simulation().stepOnce();
    QTRY_COMPARE(m_session->simulation().latest().current.step, uint64_t(1));
    QVERIFY(chooseStepper(*m_session, "velocity-verlet"));
    m_session->simulation().stepOnce();
    QTRY_COMPARE(m_session->simulation().latest().current.step, uint64_t(2));
}

void TestSession::steppingIsSetAsAWhole() {
    const Stepping wanted{"explicit-euler", 0.002, {{"model", PHYS_MODEL_RIGID}, {"as_reported", 1.0}}};
    QVERIFY(m_session->setStepping(wanted));
    QCOMPARE(m_session->stepping(), wanted);
    QTRY_COMPARE(m_session->simulation().latest().dt, 0.002);
    QTRY_COMPARE(m_session->simulation().latest().inputs.params.model, uint32_t(PHYS_MODEL_RIGID));
    // What the settings leave out: the model stays, the stepper's own row has its initial value.
    QVERIFY(m_session->setStepping({"explicit-euler", 0.002, {}}));
    const Stepping plain{"explicit-euler", 0.002, {{"model", PHYS_MODEL_RIGID}, {"as_reported", 0.0}}};
    QCOMPARE(m_session->stepping(), plain);
}

void TestSession::refusedSteppingChangesNothing_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("dt");
    QTest::addColumn<QString>("row");
    QTest::newRow("stepper") << QByteArray("no-such-stepper") << 0.002 << "model";
    QTest::newRow("dt") << QByteArray("rk4") << 0.0 << "model";
    QTest::newRow("row that it hasn't") << QByteArray("exact") << 0.002 << "as_reported";
}

void TestSession::refusedSteppingChangesNothing() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, dt);
    QFETCH(QString, row);
    const Stepping before = m_session->stepping();
    QSignalSpy failed(m_session.get(), &Session::failed);
    QVERIFY(!m_session->setStepping({stepper, dt, {{row, 1.0}}}));
    QCOMPARE(failed.count(), 1);
    QCOMPARE(m_session->stepping(), before);
}

void TestSession::paceOutOfRangeIsRefused_data() {
    QTest::addColumn<double>("value");
    QTest::newRow("zero") << 0.0;
    QTest::newRow("negative") << -1.0;
    QTest::newRow("huge") << 1e9;
    QTest::newRow("not a number") << std::nan("");
}

void TestSession::paceOutOfRangeIsRefused() {
    QFETCH(double, value);
    QSignalSpy failed(m_session.get(), &Session::failed);
    QVERIFY(!chooseDt(*m_session, value));
    QVERIFY(!m_session->setSpeed(value));
    QCOMPARE(failed.count(), 2);
    QCOMPARE(m_session->dt(), Engine::kDefaultDt);
    QCOMPARE(m_session->speed(), Simulation::kFastest);
}

void TestSession::levelBesideTheListKeepsTheGamesPlace() {
    const QString copy = m_folder->filePath("mine.txt");
    QVERIFY(QFile::copy(LEVELS_FOLDER "/05.txt", copy));
    QVERIFY(m_session->openLevel(m_session->levels().listed()[1]));
    QVERIFY(m_session->openLevel(levelOfFile(copy)));
    QCOMPARE(m_session->level().name, QString("mine"));
    QCOMPARE(m_session->game().level(), 1);
    QCOMPARE(m_session->game().phase(), Game::Phase::Prompt);
}

void TestSession::pluginsAreLoadedAsTheOptionsSay() {
    Options options = optionsFor(1);
    options.pluginLoader = [](const Registry &, const QString &path, QString *error) {
        *error = path + " is refused";
        return false;
    };
    const auto session = Session::open(options, *m_settings, nullptr);
    QSignalSpy failures(session.get(), &Session::failed);
    QVERIFY(!session->loadPlugin("any.so"));
    QCOMPARE(failures.value(0).value(0).toString(), QString("any.so is refused"));
}

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
