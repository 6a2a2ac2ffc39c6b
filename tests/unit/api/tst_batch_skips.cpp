// SPDX-License-Identifier: MIT
// Steps of a batch that change nothing are skipped, with the bits of steps made one by one.
#include "batch_case.h"

#include <QTest>

using namespace support;
using namespace batch_case;

namespace {

/// A ball that rests on the level.
Case restingCase(uint64_t steps, double dt) {
    Case made = plainCase(1, steps);
    made.dt = dt;
    made.params[0].gravity = {0.0, 0.0, -9.75};
    made.starts[0].flags = PHYS_AT_REST;
    return made;
}

} // namespace

class TestBatchSkips : public QObject {
    Q_OBJECT

private slots:
    void sameBitsOfABallAtRestWhateverItsClock_data();
    void sameBitsOfABallAtRestWhateverItsClock();
    void mostStepsThatChangeNothingAreSkipped_data();
    void mostStepsThatChangeNothingAreSkipped();
};

void TestBatchSkips::sameBitsOfABallAtRestWhateverItsClock_data() {
    QTest::addColumn<double>("dt");
    QTest::addColumn<double>("time");
    QTest::addColumn<quint64>("step");
    const auto row = [](const char *name, double dt, double time, uint64_t step) {
        QTest::newRow(name) << dt << time << quint64(step);
    };
    row("counted", 0.01, 0.03, 3);
    row("not counted", 0.01, 0.035, 3);
    row("before the start", 0.01, -0.05, 3);
    row("at the last step that a double holds", 0.01, 0.01 * double(kMostSteps - 7), kMostSteps - 7);
    row("far beyond it", 0.01, 0.01 * 0x1p60, (uint64_t{1} << 60) - 9);
    row("where steps count as negative", 0.01, 0.01 * 0x1p63, (uint64_t{1} << 63) - 9);
    row("where the number of steps wraps", 0.01, 5.0, UINT64_MAX - 9);
    row("up to the greatest time", 0x1p96, 0.0, 0);
    row("up to the greatest time, not counted", 0x1p96, 0.7 * 0x1p100, 0);
    row("at the greatest time", 0.01, 0x1p100, 0);
}

void TestBatchSkips::sameBitsOfABallAtRestWhateverItsClock() {
    QFETCH(double, dt);
    QFETCH(double, time);
    QFETCH(quint64, step);
    const ScenePtr scene = openRoom();
    for (const bool hasTally : {false, true}) {
        Case given = restingCase(40, dt);
        given.hasTally = hasTally;
        given.starts[0].time = time;
        given.starts[0].step = step;
        const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
        const Results expected = stepOneByOne(stepper.get(), given);
        const Results found =
            runBatch(given, [&](phys_batch &batch) { return phys_batch_run(stepper.get(), &batch, 0, 1, nullptr); });
        QCOMPARE(found.done, expected.done);
        QCOMPARE(found.states[0].time, expected.states[0].time);
        QVERIFY(found == expected);
    }
}

/// One by one they would take years.
void TestBatchSkips::mostStepsThatChangeNothingAreSkipped_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("dt");
    QTest::addColumn<bool>("hasTally");
    for (const QByteArray &id : stepperIds()) {
        const auto row = [&](const char *name, double dt, bool hasTally) {
            QTest::addRow("%s, %s", id.constData(), name) << id << dt << hasTally;
        };
        row("rest", 0.01, false);
        row("rest, tallied", 0.01, true);
        row("dt 0", 0.0, false);
        row("dt 0, tallied", 0.0, true);
    }
}

void TestBatchSkips::mostStepsThatChangeNothingAreSkipped() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, dt);
    QFETCH(bool, hasTally);
    const ScenePtr scene = openRoom();
    Case given = restingCase(kMostSteps, dt);
    given.hasTally = hasTally;
    given.starts[0].step = 3;
    given.starts[0].time = 3 * dt;
    const StepperPtr made = stepperOf(stepper, scene.get());
    const Results found =
        runBatch(given, [&](phys_batch &batch) { return phys_batch_run(made.get(), &batch, 0, 1, nullptr); });
    Results expected{given.starts, {}, {kMostSteps}, {PHYS_OK}, {}, {}};
    if (dt > 0.0) {
        expected.states[0].step += kMostSteps;
        expected.states[0].time = (double(kMostSteps + 2) + 1.0) * dt;
    }
    if (hasTally) {
        expected.impacts = {kImpactsBefore};
        expected.energyLost = {kEnergyBefore};
    }
    QVERIFY(found == expected);
}

QTEST_GUILESS_MAIN(TestBatchSkips)
#include "tst_batch_skips.moc"
