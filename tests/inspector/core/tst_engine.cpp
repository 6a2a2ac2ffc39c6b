// SPDX-License-Identifier: MIT
// The engine, stepped manually.
#include "inspector/core/scenes.h"
#include "inspector/core/wall_ahead.h"

#include <cmath>

using namespace inspector;

class TestEngine : public QObject {
    Q_OBJECT

private slots:
    void startsAtTheScenesStart();
    void stepMovesOnByDt();
    void sameInputsGiveTheSameBits();
    void twoEnginesOnOneSceneDontDisturbEachOther();
    void stateSetEarlierGoesOnWithTheSameBits();
    void failedStepLeavesTheStateAndGivesOneLine();
    void restartGoesBackToTheStart();
    void otherStepperGoesOnFromTheSameState();
    void pilotIsAskedOncePerControlPeriod();
    void pilotsTiltTakesThePlaceOfTheInputs();
    void withoutPilotTheInputsCountAgain();
    void restartHasTheInputsTilt();
    void otherSceneHasTheInputsTilt();
    void sampleTellsWhatTheStepDid();
    void sampleTellsTheGapToTheNearestWall();
    void lowKerbIsAWall();
    void flushTilesAreNoWalls();
    void farFromWallsThereIsNoGap();
};

namespace {

class CountingPilot : public Pilot {
public:
    Tilt tilt(const phys_state &, double) const override {
        ++m_questions;
        return {radians(4.0), 0.0};
    }
    int questions() const { return m_questions; }

private:
    mutable int m_questions = 0;
};

void makeSteps(Engine &engine, int count) {
    QString error;
    for (int i = 0; i < count; ++i) QVERIFY2(engine.step(&error), qPrintable(error));
}

} // namespace

void TestEngine::startsAtTheScenesStart() {
    const auto engine = engineOn(levelScene(1));
    phys_state start;
    phys_scene_start(engine->scene().get(), &start);
    QCOMPARE(phys_state_hash(&engine->state()), phys_state_hash(&start));
}

void TestEngine::stepMovesOnByDt() {
    const auto engine = engineOn(openFloor());
    engine->setDt(0.25);
    makeSteps(*engine, 2);
    QCOMPARE(engine->state().time, 0.5);
    QCOMPARE(engine->state().step, uint64_t(2));
    QCOMPARE(engine->previous().time, 0.25);
}

void TestEngine::sameInputsGiveTheSameBits() {
    const auto one = engineOn(levelScene(3));
    const auto other = engineOn(levelScene(3));
    for (Engine *engine : {one.get(), other.get()}) {
        engine->setInputs(tilted(3.0, 2.0));
        makeSteps(*engine, 500);
    }
    QCOMPARE(phys_state_hash(&one->state()), phys_state_hash(&other->state()));
}

void TestEngine::twoEnginesOnOneSceneDontDisturbEachOther() {
    const Scene scene = levelScene(3);
    const auto alone = engineOn(levelScene(3));
    const auto one = engineOn(scene);
    const auto other = engineOn(scene);
    alone->setInputs(tilted(3.0, 2.0));
    one->setInputs(tilted(3.0, 2.0));
    other->setInputs(tilted(-5.0, 1.0));
    for (int i = 0; i < 300; ++i) {
        makeSteps(*alone, 1);
        makeSteps(*one, 1);
        makeSteps(*other, 1);
    }
    QCOMPARE(phys_state_hash(&one->state()), phys_state_hash(&alone->state()));
}

void TestEngine::stateSetEarlierGoesOnWithTheSameBits() {
    const auto engine = engineOn(levelScene(2));
    engine->setInputs(tilted(3.0, 3.0));
    makeSteps(*engine, 100);
    const phys_state fork = engine->state();
    makeSteps(*engine, 100);
    const uint64_t first = phys_state_hash(&engine->state());
    engine->setState(fork);
    makeSteps(*engine, 100);
    QCOMPARE(phys_state_hash(&engine->state()), first);
}

void TestEngine::failedStepLeavesTheStateAndGivesOneLine() {
    const auto engine = engineOn(openFloor());
    makeSteps(*engine, 3);
    const uint64_t before = phys_state_hash(&engine->state());
    Inputs wrong = initialInputs();
    wrong.params.restitution_wall = 2.0;
    engine->setInputs(wrong);
    QString error;
    QVERIFY(!engine->step(&error));
    QVERIFY2(error.contains("restitution_wall"), qPrintable(error));
    QVERIFY(!error.contains(QLatin1Char('\n')));
    QCOMPARE(phys_state_hash(&engine->state()), before);
}

void TestEngine::restartGoesBackToTheStart() {
    const auto engine = engineOn(openFloor());
    engine->setInputs(tilted(5.0, 0.0));
    makeSteps(*engine, 50);
    engine->restart();
    QCOMPARE(engine->state().step, uint64_t(0));
    QCOMPARE(engine->state().position.x, 0.0);
    QCOMPARE(engine->inputs().tilt.x, radians(5.0)); // inputs are kept
}

void TestEngine::otherStepperGoesOnFromTheSameState() {
    const Scene scene = openFloor();
    const auto engine = engineOn(scene);
    engine->setInputs(tilted(5.0, 0.0));
    makeSteps(*engine, 50);
    const phys_state before = engine->state();
    QString error;
    const Stepper other = makeStepper(makeRegistry(&error), "explicit-euler", scene, &error);
    QVERIFY2(other, qPrintable(error));
    engine->setStepper(other);
    QCOMPARE(phys_state_hash(&engine->state()), phys_state_hash(&before));
    makeSteps(*engine, 1);
    QCOMPARE(engine->state().step, before.step + 1);
}

void TestEngine::pilotIsAskedOncePerControlPeriod() {
    const auto pilot = std::make_shared<CountingPilot>();
    const auto engine = engineOn(openFloor());
    engine->setDt(0.005);
    engine->setPilot(pilot);
    makeSteps(*engine, 40);
    QCOMPARE(pilot->questions(), int(40 * 0.005 / pilot->period()));
}

void TestEngine::pilotsTiltTakesThePlaceOfTheInputs() {
    const auto engine = engineOn(openFloor());
    engine->setPilot(std::make_shared<CountingPilot>());
    engine->setInputs(tilted(-7.0, -7.0));
    makeSteps(*engine, 10);
    QCOMPARE(engine->inputs().tilt.x, radians(4.0));
    QVERIFY(engine->state().velocity.x > 0.0);
    QCOMPARE(engine->state().velocity.y, 0.0);
}

void TestEngine::withoutPilotTheInputsCountAgain() {
    const auto engine = engineOn(openFloor());
    engine->setInputs(tilted(-7.0, 0.0));
    engine->setPilot(std::make_shared<CountingPilot>());
    makeSteps(*engine, 1);
    engine->setPilot(nullptr);
    QCOMPARE(engine->inputs().tilt.x, radians(-7.0));
}

void TestEngine::restartHasTheInputsTilt() {
    const auto engine = engineOn(openFloor());
    engine->setPilot(std::make_shared<CountingPilot>());
    makeSteps(*engine, 1);
    engine->restart();
    QCOMPARE(engine->inputs().tilt.x, 0.0);
}

void TestEngine::otherSceneHasTheInputsTilt() {
    const auto engine = engineOn(openFloor());
    engine->setPilot(std::make_shared<CountingPilot>());
    makeSteps(*engine, 1);
    const Scene scene = levelScene(2);
    engine->setScene(scene, defaultStepper(scene));
    QCOMPARE(engine->inputs().tilt.x, 0.0);
}

void TestEngine::sampleTellsWhatTheStepDid() {
    const auto engine = engineOn(openFloor());
    engine->setInputs(tilted(3.0, -4.0));
    makeSteps(*engine, 7);
    const Sample sample = engine->sample();
    const phys_state &state = engine->state();
    QCOMPARE(sample.time, state.time);
    QCOMPARE(sample.step, state.step);
    QCOMPARE(sample[Channel::PositionX], state.position.x);
    QCOMPARE(sample[Channel::VelocityY], state.velocity.y);
    QCOMPARE(sample[Channel::Speed], std::hypot(state.velocity.x, state.velocity.y));
    QCOMPARE(sample[Channel::TiltX], 3.0);
    QCOMPARE(sample[Channel::TiltY], -4.0);
    double energy = 0.0;
    phys_energy(engine->scene().get(), &engine->inputs().params, &state, &energy);
    QCOMPARE(sample[Channel::Energy], energy);
}

// Level and at rest, 0.07 m to the left of a face; the ball's radius is 6 mm.
void TestEngine::sampleTellsTheGapToTheNearestWall() {
    const auto engine = engineOn(wallAhead(0.07));
    makeSteps(*engine, 1);
    QVERIFY(std::abs(engine->sample()[Channel::WallGap] - (0.07 - 0.006)) < 1e-12);
}

// The edge of a kerb of 0.4 R that the ball almost touches is in the ball's way, although not far above its lowest
// point.
void TestEngine::lowKerbIsAWall() {
    constexpr double kRadius = 0.006;
    constexpr double kDistance = 0.9 * kRadius;
    const auto engine = engineOn(wallAhead(kDistance, 0.4 * kRadius));
    const double gap = std::hypot(kDistance, 0.6 * kRadius) - kRadius;
    QVERIFY(std::abs(engine->sample()[Channel::WallGap] - gap) < 1e-12);
}

void TestEngine::flushTilesAreNoWalls() {
    const auto engine =
        engineOn(sceneOf({{{-1.0, -1.0, -0.01}, {0.02, 1.0, 0.0}}, {{0.02, -0.5, -0.01}, {1.0, 0.5, 0.0}}}));
    makeSteps(*engine, 1);
    QVERIFY(std::isnan(engine->sample()[Channel::WallGap]));
}

void TestEngine::farFromWallsThereIsNoGap() {
    const auto engine = engineOn(wallAhead(0.5));
    makeSteps(*engine, 1);
    QVERIFY(std::isnan(engine->sample()[Channel::WallGap]));
}

QTEST_GUILESS_MAIN(TestEngine)
#include "tst_engine.moc"
