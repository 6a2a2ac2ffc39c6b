// SPDX-License-Identifier: MIT
// The engine on its thread: the same bits, nothing lost, nobody waits. No test depends on the speed.
#include "core/simulation/simulation.h"
#include "inspector/core/scenes.h"
#include "inspector/recording/recorded_steps.h"
#include "support/compare.h"

#include <QDeadlineTimer>
#include <QThread>

#include <cmath>
#include <memory>

using namespace inspector;

class TestSimulation : public QObject {
    Q_OBJECT

private slots:
    void startsPausedAtTheStart();
    void aSnapshotStaysAsItWasWhenTaken();
    void threadGivesTheSameBitsAsStepsByHand();
    void blockedWindowThreadLosesNoStepAndNoSample();
    void speedChangesHowManyStepsRunButNeverDt_data();
    void speedChangesHowManyStepsRunButNeverDt();
    void speedIsKeptInItsLimits();
    void latestInputsWin();
    void inputsAreShownWhilePaused();
    void singleStepIsOneStepAndPauses();
    void pauseStopsSteps();
    void restartClearsTheSamples();
    void stateCanBeSetBack();
    void stepperChangesOnTheFly();
    void inputsAfterAStepperCount();
    void otherSceneStartsPaused();
    void failedStepPausesAndIsReportedOnce();
    void leavingTheMazeIsReportedOnceAndTheFallEnds();
    void samplesGoOnToTheEndOfTheFall();
    void pilotOnTheThreadGivesTheSameBitsAsByHand();
    void commandsAreObeyedWhileAnEarlierRunIsRepeated();
    void samplesOfALongRunAreThereAgainAfterALookAtAnother();
    void deletingARunningSimulationEndsItsThread();
};

namespace {

std::unique_ptr<Simulation> simulationOf(const Scene &scene) {
    return std::make_unique<Simulation>(scene, defaultStepper(scene));
}

// Collects the signals of the stepping thread in this thread's event loop. (A QSignalSpy would be called in the
// sender's thread, which it doesn't support before Qt 6.6.)
template<typename Value>
class Received {
public:
    Received(Simulation &simulation, void (Simulation::*signal)(Value)) {
        QObject::connect(&simulation, signal, &m_here, [this](const Value &value) { m_values.append(value); });
    }
    Received(Simulation &simulation, void (Simulation::*signal)(const Value &)) requires(!std::is_arithmetic_v<Value>) {
        QObject::connect(&simulation, signal, &m_here, [this](const Value &value) { m_values.append(value); });
    }
    qsizetype count() const { return m_values.size(); }
    const Value &operator[](qsizetype i) const { return m_values[i]; }

private:
    QObject m_here;
    QList<Value> m_values;
};

// Keeps this thread busy, without its event loop, until that many samples exist.
void waitBlocked(const Simulation &simulation, uint64_t samples) {
    const QDeadlineTimer deadline(30000);
    while (simulation.samples().last() < samples && !deadline.hasExpired()) QThread::yieldCurrentThread();
    QVERIFY(simulation.samples().last() >= samples);
}

// One that can show its past.
std::unique_ptr<Simulation> simulationWithHistory() {
    const Scene scene = levelScene(1);
    const Origin origin = originOf(makeRegistry(nullptr), PHYS_STEPPER_DEFAULT, LEVELS_FOLDER "/01.txt");
    return std::make_unique<Simulation>(scene, defaultStepper(scene), origin);
}

// Of 200,000 steps or some more, made as fast as can be.
void makeLongRun(Simulation &simulation) {
    simulation.setDt(1e-6);
    simulation.run();
    waitBlocked(simulation, simulation.samples().last() + 200000);
    simulation.pause();
    QTRY_VERIFY(!simulation.latest().running);
}

uint64_t samplesIn(const Simulation &simulation) { return simulation.samples().last() - simulation.samples().first(); }

class ShiftingPilot : public Pilot {
public:
    Tilt tilt(const phys_state &state, double) const override {
        return {radians(5.0), state.position.x > -0.02 ? -0.1 : 0.1};
    }
};

} // namespace

void TestSimulation::startsPausedAtTheStart() {
    const auto simulation = simulationOf(levelScene(1));
    const Snapshot snapshot = simulation->latest();
    QVERIFY(!snapshot.running);
    QCOMPARE(snapshot.current.step, uint64_t(0));
    QCOMPARE(snapshot.current.position.x, -0.054); // start of level 01
}

void TestSimulation::aSnapshotStaysAsItWasWhenTaken() {
    const auto simulation = simulationOf(levelScene(1));
    const Snapshot &then = simulation->latest();
    for (uint64_t step = 1; step <= 4; ++step) { // more than there are slots
        simulation->stepOnce();
        QTRY_COMPARE(simulation->latest().current.step, step);
        QCOMPARE(then.current.step, uint64_t(0));
    }
}

void TestSimulation::threadGivesTheSameBitsAsStepsByHand() {
    const auto simulation = simulationOf(levelScene(4));
    simulation->setDt(0.002);
    simulation->setInputs(tilted(4.0, 3.0));
    simulation->setSpeed(Simulation::kFastest);
    simulation->run();
    waitBlocked(*simulation, 2000);
    simulation->pause();
    QTRY_VERIFY(!simulation->latest().running);

    const auto engine = engineOn(levelScene(4));
    engine->setDt(0.002);
    engine->setInputs(tilted(4.0, 3.0));
    const phys_state reached = simulation->latest().current;
    Sample sample;
    for (uint64_t i = 0; i < reached.step; ++i) {
        QVERIFY(engine->step(nullptr));
        QVERIFY(simulation->samples().read(i, sample));
        QCOMPARE(sample.step, i + 1);
        sample[Channel::StepTime] = engine->sample()[Channel::StepTime]; // a manual step isn't timed
        QVERIFY(support::sameBits(sample.values, engine->sample().values));
    }
    QCOMPARE(phys_state_hash(&engine->state()), phys_state_hash(&reached));
}

// This thread never returns to its event loop while the steps run; nevertheless all of them are in the ring.
void TestSimulation::blockedWindowThreadLosesNoStepAndNoSample() {
    const auto simulation = simulationOf(openFloor());
    simulation->setDt(0.001);
    simulation->setSpeed(Simulation::kFastest);
    simulation->run();
    waitBlocked(*simulation, 5000);
    Sample sample;
    for (uint64_t i = 0; i < 5000; ++i) {
        QVERIFY(simulation->samples().read(i, sample));
        QCOMPARE(sample.step, i + 1);
    }
}

void TestSimulation::speedChangesHowManyStepsRunButNeverDt_data() {
    QTest::addColumn<double>("speed");
    QTest::newRow("slowest") << Simulation::kSlowest;
    QTest::newRow("real time") << 1.0;
    QTest::newRow("fastest") << Simulation::kFastest;
}

void TestSimulation::speedChangesHowManyStepsRunButNeverDt() {
    QFETCH(double, speed);
    const auto simulation = simulationOf(openFloor());
    simulation->setDt(0.0009765625); // 2^-10: sums are exact
    simulation->setSpeed(speed);
    simulation->run();
    waitBlocked(*simulation, 20);
    Sample sample;
    for (uint64_t i = 0; i < 20; ++i) {
        QVERIFY(simulation->samples().read(i, sample));
        QCOMPARE(sample.time, double(i + 1) * 0.0009765625);
    }
    QTRY_COMPARE(simulation->latest().statistics.speedAsked, speed);
    QCOMPARE(simulation->latest().dt, 0.0009765625);
    const auto interval = std::chrono::duration<double>(simulation->latest().interval).count();
    QVERIFY(std::abs(interval * speed - 0.0009765625) < 1e-9 * speed); // to the clock's nanosecond
}

void TestSimulation::speedIsKeptInItsLimits() {
    const auto simulation = simulationOf(openFloor());
    simulation->setSpeed(1e9);
    QTRY_COMPARE(simulation->latest().statistics.speedAsked, Simulation::kFastest);
    simulation->setSpeed(0.0);
    QTRY_COMPARE(simulation->latest().statistics.speedAsked, Simulation::kSlowest);
}

void TestSimulation::latestInputsWin() {
    const auto simulation = simulationOf(openFloor());
    for (int i = 1; i <= 100; ++i) simulation->setInputs(tilted(i / 10.0, 0.0));
    simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(1));
    QCOMPARE(simulation->latest().inputs.tilt.x, radians(10.0));
}

void TestSimulation::inputsAreShownWhilePaused() {
    const auto simulation = simulationOf(openFloor());
    simulation->setInputs(tilted(3.0, 0.0));
    QTRY_COMPARE(simulation->latest().inputs.tilt.x, radians(3.0));
    QCOMPARE(simulation->latest().current.step, uint64_t(0));
}

void TestSimulation::singleStepIsOneStepAndPauses() {
    const auto simulation = simulationOf(openFloor());
    Received<bool> running(*simulation, &Simulation::runningChanged);
    simulation->run();
    QTRY_COMPARE(running.count(), 1);
    simulation->stepOnce();
    QTRY_COMPARE(running.count(), 2);
    QCOMPARE(running[1], false);
    QTRY_VERIFY(simulation->latest().current.step > 0);
    simulation->restart();
    for (uint64_t i = 1; i <= 3; ++i) simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(3));
    QVERIFY(!simulation->latest().running);
}

// Commands are executed in order: once a later one is seen, a step after the pause would be visible, too.
void TestSimulation::pauseStopsSteps() {
    const auto simulation = simulationOf(openFloor());
    simulation->setDt(0.001);
    simulation->run();
    waitBlocked(*simulation, 10);
    simulation->pause();
    QTRY_VERIFY(!simulation->latest().running);
    const uint64_t step = simulation->latest().current.step;
    simulation->setSpeed(2.0);
    QTRY_COMPARE(simulation->latest().statistics.speedAsked, 2.0);
    QCOMPARE(simulation->latest().current.step, step);
    QCOMPARE(simulation->latest().interval, Clock::duration::zero());
}

void TestSimulation::restartClearsTheSamples() {
    const auto simulation = simulationOf(openFloor());
    simulation->stepOnce();
    simulation->stepOnce();
    simulation->restart();
    QTRY_COMPARE(simulation->latest().run, uint64_t(1));
    QCOMPARE(simulation->samples().first(), simulation->samples().last());
    QCOMPARE(simulation->samples().generation(), uint64_t(1));
    QCOMPARE(simulation->latest().current.step, uint64_t(0));
}

void TestSimulation::stateCanBeSetBack() {
    const auto simulation = simulationOf(openFloor());
    simulation->setInputs(tilted(4.0, 0.0));
    for (int i = 0; i < 5; ++i) simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(5));
    const phys_state kept = simulation->latest().current;
    simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(6));
    const uint64_t expected = hashOf(simulation->latest());
    simulation->setState(kept);
    simulation->stepOnce();
    QTRY_VERIFY(simulation->latest().run == 1 && simulation->latest().current.step == 6);
    QCOMPARE(hashOf(simulation->latest()), expected);
}

void TestSimulation::stepperChangesOnTheFly() {
    const Scene scene = openFloor();
    const auto simulation = simulationOf(scene);
    simulation->setInputs(tilted(4.0, 0.0));
    simulation->stepOnce();
    QString error;
    const Stepper other = makeStepper(makeRegistry(&error), "explicit-euler", scene, &error);
    QVERIFY2(other, qPrintable(error));
    simulation->setStepper(other, tilted(0.0, 4.0));
    simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(2));
    // Explicit Euler moves with the old velocity, which had no component along y.
    QCOMPARE(simulation->latest().current.position.y, 0.0);
    QVERIFY(simulation->latest().current.velocity.y > 0.0);
}

// The thread may find the mailbox or the command first; repeated many times, as it is a race.
void TestSimulation::inputsAfterAStepperCount() {
    const Scene scene = openFloor();
    const auto simulation = simulationOf(scene);
    const Stepper other = defaultStepper(scene);
    for (uint64_t i = 1; i <= 200; ++i) {
        simulation->setStepper(other, tilted(0.0, 4.0));
        simulation->setInputs(tilted(3.0, 0.0));
        simulation->stepOnce();
        QTRY_COMPARE(simulation->latest().current.step, i);
        QCOMPARE(simulation->latest().inputs.tilt.x, radians(3.0));
    }
}

void TestSimulation::otherSceneStartsPaused() {
    const auto simulation = simulationOf(levelScene(1));
    simulation->run();
    waitBlocked(*simulation, 1);
    const Scene other = levelScene(2);
    simulation->setScene(other, defaultStepper(other));
    QTRY_COMPARE(simulation->latest().run, uint64_t(1));
    QVERIFY(!simulation->latest().running);
    phys_state start;
    phys_scene_start(other.get(), &start);
    QCOMPARE(simulation->latest().current.position.x, start.position.x);
}

void TestSimulation::failedStepPausesAndIsReportedOnce() {
    const auto simulation = simulationOf(openFloor());
    Received<QString> failed(*simulation, &Simulation::failed);
    Inputs wrong = initialInputs();
    wrong.params.restitution_wall = 2.0;
    simulation->setInputs(wrong);
    simulation->run();
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY2(failed[0].contains("restitution_wall"), qPrintable(failed[0]));
    QTRY_VERIFY(!simulation->latest().running);
    QCOMPARE(simulation->latest().current.step, uint64_t(0));
    simulation->setInputs(initialInputs());
    simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(1));
    QCOMPARE(failed.count(), 1);
}

// From the middle of 2 m of floor at 20 degrees: out after sqrt(2 * 1 / (5/7 * 9.81 * sin 20)) = 0.91 s.
void TestSimulation::leavingTheMazeIsReportedOnceAndTheFallEnds() {
    const auto simulation = simulationOf(openFloor());
    Received<Departure> left(*simulation, &Simulation::leftMaze);
    Received<bool> running(*simulation, &Simulation::runningChanged);
    simulation->setInputs(tilted(20.0, 0.0));
    simulation->setSpeed(Simulation::kFastest);
    simulation->run();
    QTRY_COMPARE(running.count(), 2); // started, and stopped by itself
    QTRY_COMPARE(left.count(), 1);
    const double time = left[0].time;
    QVERIFY(time > 0.89 && time < 0.95); // rolling friction 0.002 delays it by less than a hundredth; steps of 10 ms
    QTRY_VERIFY(!simulation->latest().running);
    QVERIFY(simulation->latest().current.flags & PHYS_OUT);
    QVERIFY(simulation->latest().current.position.z < 0.0);
}

// The last sample is of the moment shown, and each step has one, also when the run is shown again as the past.
void TestSimulation::samplesGoOnToTheEndOfTheFall() {
    const auto simulation = simulationOf(openFloor());
    phys_state state = simulation->latest().current;
    state.position.x = 0.99;
    state.velocity.x = 1.0;
    simulation->setState(state);
    simulation->setSpeed(Simulation::kFastest);
    simulation->run();
    QTRY_VERIFY(simulation->latest().current.flags & PHYS_OUT);
    QTRY_VERIFY(!simulation->latest().running);
    const phys_state end = simulation->latest().current;
    const uint64_t last = simulation->samples().last();
    QCOMPARE(last - simulation->samples().first(), end.step);
    Sample sample;
    QVERIFY(simulation->samples().read(last - 1, sample));
    QCOMPARE(sample.step, end.step);
    QCOMPARE(sample.time, end.time);
}

void TestSimulation::pilotOnTheThreadGivesTheSameBitsAsByHand() {
    const auto pilot = std::make_shared<ShiftingPilot>();
    const auto simulation = simulationOf(levelScene(5));
    simulation->setPilot(pilot);
    simulation->setSpeed(Simulation::kFastest);
    simulation->run();
    waitBlocked(*simulation, 300);
    simulation->pause();
    QTRY_VERIFY(!simulation->latest().running);
    const phys_state reached = simulation->latest().current;

    const auto engine = engineOn(levelScene(5));
    engine->setPilot(pilot);
    while (engine->state().step < reached.step) QVERIFY(engine->step(nullptr));
    QCOMPARE(phys_state_hash(&engine->state()), phys_state_hash(&reached));
}

// Two commands, one after the other: the first may come together with the request for the earlier run.
void TestSimulation::commandsAreObeyedWhileAnEarlierRunIsRepeated() {
    const auto simulation = simulationWithHistory();
    makeLongRun(*simulation);
    const uint64_t samples = samplesIn(*simulation);
    simulation->restart();
    simulation->stepOnce();
    const std::optional<Past> past = simulation->past(nullptr);
    QVERIFY(past);
    const Received<bool> obeyed(*simulation, &Simulation::runningChanged);
    simulation->lookBack(*past);
    const uint64_t seek = simulation->seek(5);
    simulation->run();
    QTRY_COMPARE(obeyed.count(), 1);
    simulation->pause();
    QTRY_COMPARE(obeyed.count(), 2);
    QVERIFY(simulation->latest().replay.seeks < seek);
    QTRY_COMPARE_WITH_TIMEOUT(simulation->latest().replay.seeks, seek, 60000); // only ends what hangs
    QCOMPARE(simulation->latest().replay.position, uint64_t(5));
    QCOMPARE(samplesIn(*simulation), samples);
}

void TestSimulation::samplesOfALongRunAreThereAgainAfterALookAtAnother() {
    const auto simulation = simulationWithHistory();
    simulation->stepOnce();
    simulation->restart();
    makeLongRun(*simulation);
    const uint64_t samples = samplesIn(*simulation);
    const std::optional<Past> past = simulation->past(nullptr);
    QVERIFY(past);
    simulation->lookBack(*past);
    simulation->seek(0);
    QTRY_COMPARE(samplesIn(*simulation), uint64_t(1));
    simulation->returnToPresent();
    QTRY_COMPARE_WITH_TIMEOUT(samplesIn(*simulation), samples, 60000); // only ends what hangs
}

void TestSimulation::deletingARunningSimulationEndsItsThread() {
    for (int i = 0; i < 5; ++i) {
        const auto simulation = simulationOf(openFloor());
        simulation->setDt(1.0 + i); // deadlines far away
        simulation->run();
    }
}

QTEST_GUILESS_MAIN(TestSimulation)
#include "tst_simulation.moc"
