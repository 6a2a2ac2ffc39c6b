// SPDX-License-Identifier: MIT
// The state is complete: how a run is driven has no effect on it.
#include "drawn_scene.h"
#include "support/compare.h"
#include "support/effort.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <functional>

using namespace invariants;
using namespace support;

namespace {

constexpr int kRepeatedScenes = 8;

/// In every fourth scene the ball glides in the rigid model.
Drawn drawFloor(Random &random, uint32_t model, int scene) {
    Drawn drawn = draw(random, model);
    if (scene % 4 == 3) drawn.params.rolling_friction = drawn.params.sliding_friction = 0.0;
    return drawn;
}

/// A way to make one step that differs from Experiment::step.
using OtherStep = std::function<bool(Experiment &, double)>;

bool withoutReport(Experiment &ball, double dt) {
    return phys_step(ball.stepper(), &ball.params, dt, &ball.state, &ball.state, nullptr, nullptr) == PHYS_OK;
}

bool intoAnotherState(Experiment &ball, double dt) {
    phys_state next;
    std::memset(static_cast<void *>(&next), 0xff, sizeof next);
    if (phys_step(ball.stepper(), &ball.params, dt, &ball.state, &next, &ball.report, nullptr)) return false;
    ball.state = next;
    return true;
}

bool withAFreshStepper(Experiment &ball, double dt) { return ball.renewStepper() && ball.step(dt); }

bool afterAStepElsewhere(Experiment &ball, double dt) {
    phys_state elsewhere = ball.state;
    elsewhere.velocity = {-elsewhere.velocity.y, elsewhere.velocity.x, 0.0};
    phys_step(ball.stepper(), &ball.params, 3.0 * dt, &elsewhere, &elsewhere, nullptr, nullptr);
    return ball.step(dt);
}

bool afterAnEmptyStep(Experiment &ball, double dt) { return ball.step(0.0) && ball.step(dt); }

bool withOtherFlags(Experiment &ball, double dt) {
    ball.state.flags ^= PHYS_STATE_FLAGS; // they follow from the step that produced the state; steppers never read them
    return ball.step(dt);
}

struct Way {
    const char *name;
    OtherStep step;
};

const std::vector<Way> kWays{{"the same once more", [](Experiment &ball, double dt) { return ball.step(dt); }},
                             {"without a report", withoutReport},
                             {"into another state", intoAnotherState},
                             {"with a fresh stepper", withAFreshStepper},
                             {"after a step from elsewhere", afterAStepElsewhere},
                             {"after an empty step", afterAnEmptyStep},
                             {"with other flags", withOtherFlags}};

} // namespace

class TestDeterminism : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(testSeed())); }
    void sameBitsStepped_data();
    void sameBitsStepped();
    void emptyStepChangesNothing_data() { addStepperAndModelRows(); }
    void emptyStepChangesNothing();
    void allStagesChangeNoBitOfTheMotion_data() { addStepperAndModelRows(); }
    void allStagesChangeNoBitOfTheMotion();
    void timeIsTheCountOfSteps_data() { addStepperRows(); }
    void timeIsTheCountOfSteps();
    void restStaysToTheLastBit_data() { addStepperAndModelRows(); }
    void restStaysToTheLastBit();
};

void TestDeterminism::sameBitsStepped_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<int>("way");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (size_t i = 0; i < kWays.size(); ++i) {
                QTest::addRow("%s, %s, %s", id.constData(), modelName(model).constData(), kWays[i].name)
                    << id << model << static_cast<int>(i);
            }
        }
    }
}

void TestDeterminism::sameBitsStepped() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(int, way);
    Random random(testSeed());
    for (int scene = 0; scene < kRepeatedScenes; ++scene) {
        const Drawn drawn = drawFloor(random, model, scene);
        Experiment a = makeExperiment(drawn, stepper);
        Experiment b = makeExperiment(drawn, stepper);
        for (int i = 0; i < kSegment * kSegments; ++i) {
            a.params.gravity = b.params.gravity = drawn.gravities[static_cast<size_t>(i / kSegment)];
            const bool stepped = a.step(drawn.dt);
            QCOMPARE(kWays[static_cast<size_t>(way)].step(b, drawn.dt), stepped);
            if (!stepped) QCOMPARE(a.status(), PHYS_ERROR_UNSUPPORTED);
            if (!stepped) break;
            QVERIFY(sameBits(a.state, b.state));
            QCOMPARE(phys_state_hash(&a.state), phys_state_hash(&b.state));
        }
    }
}

void TestDeterminism::emptyStepChangesNothing() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(4.0), stepper, model);
    // Even against a wall that the ball touches and runs into: model.md 11.
    ball.setPosition(0.0625, 0.0625);
    ball.roll(-1.0, -2.0);
    ball.state.time = 0.1;
    ball.state.flags = PHYS_AT_REST;
    const phys_state before = ball.state;
    QVERIFY2(ball.step(0.0), ball.error());
    QVERIFY(sameBits(ball.state, before));
    QCOMPARE(ball.report.substeps, 0U);
    QCOMPARE(ball.report.event_count, 0U);
    COMPARE_EXACT(ball.report.energy_after, ball.report.energy_before);
    COMPARE_EXACT(ball.report.energy_scheme, 0.0);
}

void TestDeterminism::allStagesChangeNoBitOfTheMotion() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed());
    for (int scene = 0; scene < 2 * kRepeatedScenes; ++scene) {
        Drawn drawn = drawFloor(random, model, scene);
        // Every other scene without boxes inside the room: few enough to need no grid.
        if (scene % 2 == 1) {
            const auto &boxes = drawn.scene.boxes();
            SceneBuilder few;
            few.ball(drawn.scene.radius()).start(drawn.scene.start());
            for (size_t i = 0; i < 5; ++i) few.box(boxes[i]);
            drawn.scene = few;
        }
        Experiment a = makeExperiment(drawn, stepper);
        Experiment b = makeExperiment(drawn, stepper);
        b.params.options = PHYS_OPTION_ALL_STAGES;
        for (int i = 0; i < kSegment * kSegments; ++i) {
            a.params.gravity = b.params.gravity = drawn.gravities[static_cast<size_t>(i / kSegment)];
            const bool stepped = a.step(drawn.dt);
            QCOMPARE(b.step(drawn.dt), stepped);
            if (!stepped) break;
            QVERIFY(sameBits(a.state, b.state));
        }
    }
}

void TestDeterminism::timeIsTheCountOfSteps() {
    QFETCH(QByteArray, stepper);
    Experiment ball(openFloor(), stepper);
    // model.md 10.6: n dt, not a sum of n roundings of 0.001.
    QVERIFY2(ball.stepTimes(100'000, 0.001), ball.error());
    QCOMPARE(ball.state.step, uint64_t{100'000});
    COMPARE_EXACT(ball.state.time, 100'000 * 0.001);
}

void TestDeterminism::restStaysToTheLastBit() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    if (promiseOf(stepper).heats) QSKIP("Explicit Euler doesn't stay in contact: model.md 10.3");
    // Leaning on a corner, on a slope that resistance holds along neither wall.
    Experiment ball(squareRoom(1.0).start(0.0625, 0.0625), stepper, model);
    ball.params.gravity = {-0.3, -0.7, -9.81};
    ball.params.rolling_friction = 0.001;
    QVERIFY2(ball.step(0.01), ball.error());
    const phys_state first = ball.state;
    QVERIFY(first.flags & PHYS_AT_REST);
    const uint64_t steps = effort(100'000, 1'000'000, 10'000'000);
    for (uint64_t i = 1; i < steps; ++i) {
        if (phys_step(ball.stepper(), &ball.params, 0.01, &ball.state, &ball.state, nullptr, nullptr)) QFAIL("step");
    }
    QCOMPARE(ball.state.step, steps);
    ball.state.step = first.step;
    ball.state.time = first.time;
    QVERIFY(sameBits(ball.state, first));
}

QTEST_GUILESS_MAIN(TestDeterminism)
#include "tst_determinism.moc"
