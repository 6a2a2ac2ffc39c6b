// SPDX-License-Identifier: MIT
// In random scenes, after each step: every number is finite and the ball is outside of all walls.
#include "drawn_scene.h"
#include "property/extremes/watch.h"
#include "support/effort.h"
#include "support/stepper_rows.h"

#include <QTest>

using namespace invariants;
using namespace support;

class TestSafety : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(testSeed())); }
    void staysFiniteAndOutsideOfWalls_data() { addStepperAndModelRows(); }
    void staysFiniteAndOutsideOfWalls();
    void staysInItsRoomAtAnyStepLength_data();
    void staysInItsRoomAtAnyStepLength();
};

void TestSafety::staysFiniteAndOutsideOfWalls() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed() + 10);
    const uint64_t scenes = effort(20, 100, 2000);
    for (uint64_t scene = 0; scene < scenes; ++scene) {
        const Drawn drawn = draw(random, model);
        Experiment ball = makeExperiment(drawn, stepper);
        extremes::Watch watch(ball);
        for (const phys_vec3 &gravity : drawn.gravities) {
            ball.params.gravity = gravity;
            if (!watch.step(kSegment, drawn.dt)) break;
        }
        const QByteArray where = "scene " + QByteArray::number(static_cast<qulonglong>(scene)) + ": ";
        QVERIFY2(watch.problem().isEmpty(), where + watch.problem());
        QVERIFY2(watch.refusal().isEmpty() || watch.refusal() == "PHYS_ERROR_UNSUPPORTED", where + ball.error());
    }
}

void TestSafety::staysInItsRoomAtAnyStepLength_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<double>("dt");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (const double dt : {0x1p-12, 0x1p-9, 0x1p-5}) {
                QTest::addRow("%s, %s, %g s", id.constData(), modelName(model).constData(), dt) << id << model << dt;
            }
            // Steppers that find every impact inside the step.
            if (id != "swept" && id != "exact") continue;
            QTest::addRow("%s, %s, 0.25 s", id.constData(), modelName(model).constData()) << id << model << 0.25;
        }
    }
}

void TestSafety::staysInItsRoomAtAnyStepLength() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(double, dt);
    Random random(testSeed() + 11);
    for (int scene = 0; scene < 8; ++scene) {
        Drawn drawn = draw(random, model);
        drawn.params.wall_friction = 0.0; // the ball stays on the floor
        Experiment ball = makeExperiment(drawn, stepper);
        extremes::Watch watch(ball);
        for (const phys_vec3 &gravity : drawn.gravities) {
            ball.params.gravity = gravity;
            if (!watch.step(32, dt)) break;
        }
        const phys_vec3 &p = ball.state.position;
        QVERIFY2(watch.problem().isEmpty(), watch.problem());
        QVERIFY2(watch.refusal().isEmpty() || watch.refusal() == "PHYS_ERROR_UNSUPPORTED", ball.error());
        QVERIFY(p.x > 0.0 && p.x < 4.0 && p.y > 0.0 && p.y < 4.0);
    }
}

QTEST_GUILESS_MAIN(TestSafety)
#include "tst_safety.moc"
