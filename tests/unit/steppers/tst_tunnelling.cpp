// SPDX-License-Identifier: MIT
// A ball that hits a thin wall head-on: the table of model.md 10.4, over all phases of the step.
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

using namespace support;

namespace {

// R = h and dt as in model.md 12.3 but rounded to powers of two, so that the limits 0.5, 0.75 and 1.5 m/s are exact.
constexpr double kSmallRadius = 0.00390625;
constexpr double kThickness = 0.00390625;
constexpr double kFlightStep = 0.0078125;
constexpr int kPhases = 64;

SceneBuilder thinWall() {
    return SceneBuilder().ball(kSmallRadius).floor(-100, -1, 100, 1).wall(0.0, -1.0, kThickness, 1.0);
}

/// The outcome at one phase.
struct Flight {
    bool isSeen = false;
    bool isThrough = false;
    bool isDone = false;
};

/// Runs towards +x (direction 1) or -x (-1) from a start such that a step ends `phase` of a step before the contact.
Flight fly(const QByteArray &stepper, bool asReported, double speed, double direction, int phase) {
    Experiment ball(thinWall(), stepper);
    if (hasOwnRow(stepper, "as_reported")) ball.params.stepper[0] = asReported ? 1.0 : 0.0;
    const double face = direction > 0 ? 0.0 : kThickness;
    const double touch = face - direction * kSmallRadius;
    const double ahead = (2.0 + static_cast<double>(phase) / kPhases) * speed * kFlightStep;
    ball.setPosition(touch - direction * ahead, 0.0);
    ball.roll(direction * speed, 0.0);
    Flight passage;
    for (int i = 0; i < 12; ++i) {
        if (!ball.step(kFlightStep)) return passage;
        if (ball.report.event_count > 0) passage.isSeen = true;
    }
    passage.isThrough = direction * (ball.state.position.x - kThickness / 2) > 0;
    passage.isDone = true;
    return passage;
}

} // namespace

class TestTunnelling : public QObject {
    Q_OBJECT

private slots:
    void withoutSubstepsComesOutOnTheRightSide_data();
    void withoutSubstepsComesOutOnTheRightSide();
    void withoutSubstepsIsSeen_data();
    void withoutSubstepsIsSeen();
    void withoutSubstepsMayBePushedOutOnTheFarSide_data();
    void withoutSubstepsMayBePushedOutOnTheFarSide();
    void withoutSubstepsIsMissedAtSomePhase_data();
    void withoutSubstepsIsMissedAtSomePhase();
    void isNeverPassed_data();
    void isNeverPassed();
    void aThousandthOfARadiusIsAWall_data() { addStepperRows(); }
    void aThousandthOfARadiusIsAWall();

private:
    void addRows(std::initializer_list<double> speeds, const QByteArrayList &steppers);
};

void TestTunnelling::addRows(std::initializer_list<double> speeds, const QByteArrayList &steppers) {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("speed");
    for (const QByteArray &id : steppers) {
        for (const double speed : speeds) QTest::addRow("%s, %g m/s", id.constData(), speed) << id << speed;
    }
}

void TestTunnelling::withoutSubstepsComesOutOnTheRightSide_data() {
    addRows({0.25, 0.5, 0.625, 0.75 - 0x1p-10}, discreteStepperIds());
}

void TestTunnelling::withoutSubstepsComesOutOnTheRightSide() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    for (const double direction : {1.0, -1.0}) {
        for (int phase = 0; phase < kPhases; ++phase) {
            const Flight passage = fly(stepper, true, speed, direction, phase);
            QVERIFY(passage.isDone && passage.isSeen && !passage.isThrough);
        }
    }
}

void TestTunnelling::withoutSubstepsIsSeen_data() { addRows({0.75, 1.0, 1.25, 1.5 - 0x1p-10}, discreteStepperIds()); }

void TestTunnelling::withoutSubstepsIsSeen() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    for (int phase = 0; phase < kPhases; ++phase) {
        const Flight passage = fly(stepper, true, speed, 1.0, phase);
        QVERIFY(passage.isDone && (passage.isSeen || passage.isThrough));
    }
}

void TestTunnelling::withoutSubstepsMayBePushedOutOnTheFarSide_data() { addRows({0.875, 1.25}, discreteStepperIds()); }

void TestTunnelling::withoutSubstepsMayBePushedOutOnTheFarSide() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    int through = 0;
    for (int phase = 0; phase < kPhases; ++phase) {
        const Flight passage = fly(stepper, true, speed, 1.0, phase);
        QVERIFY(passage.isDone);
        if (passage.isThrough) ++through;
    }
    QVERIFY(through > 0 && through < kPhases);
}

void TestTunnelling::withoutSubstepsIsMissedAtSomePhase_data() { addRows({1.5, 1.5625, 2.0}, discreteStepperIds()); }

void TestTunnelling::withoutSubstepsIsMissedAtSomePhase() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    int missed = 0;
    for (int phase = 0; phase < kPhases; ++phase) {
        const Flight passage = fly(stepper, true, speed, 1.0, phase);
        QVERIFY(passage.isDone);
        if (!passage.isSeen && passage.isThrough) ++missed;
    }
    QVERIFY(missed > 0 && missed < kPhases);
}

void TestTunnelling::isNeverPassed_data() { addRows({0.25, 0.75, 1.5, 2.0, 5.0, 20.0, 100.0}, stepperIds()); }

void TestTunnelling::isNeverPassed() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, speed);
    for (const double direction : {1.0, -1.0}) {
        for (int phase = 0; phase < kPhases; ++phase) {
            const Flight passage = fly(stepper, false, speed, direction, phase);
            QVERIFY(passage.isDone && passage.isSeen && !passage.isThrough);
        }
    }
}

void TestTunnelling::aThousandthOfARadiusIsAWall() {
    QFETCH(QByteArray, stepper);
    const auto scene =
        SceneBuilder().ball(kSmallRadius).floor(-9, -1, 9, 1).wall(0.0, -1.0, kSmallRadius / 1000.0, 1.0);
    for (int phase = 0; phase < kPhases; ++phase) {
        Experiment ball(scene, stepper);
        ball.setPosition(-0.125 - 2.0 * kFlightStep * phase / kPhases, 0.0);
        ball.roll(2.0, 0.0);
        for (int i = 0; i < 40; ++i) {
            QVERIFY2(ball.step(kFlightStep), ball.error());
            QVERIFY(ball.state.position.x < 0.0);
        }
        QVERIFY(ball.state.velocity.x < 0.0);
    }
}

QTEST_GUILESS_MAIN(TestTunnelling)
#include "tst_tunnelling.moc"
