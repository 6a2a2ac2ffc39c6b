// SPDX-License-Identifier: MIT
// A report has no effect on a step: with and without one, every bit of the state is the same. Steps without a report
// may take a shortcut, which must cover everything that the long way does.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <algorithm>

#include <cmath>
#include <limits>
#include <utility>

using namespace support;

namespace {

constexpr double kOddDt = 0.004;

} // namespace

class Reports : public QObject {
    Q_OBJECT

private slots:
    void passesStayWithinTheirCap_data() { addStepperAndModelRows(); }
    void passesStayWithinTheirCap();
    void changeNoBitOfABallThatAlmostTouchesAWall_data() { addStepperAndModelRows(); }
    void changeNoBitOfABallThatAlmostTouchesAWall();
    void changeNoBitOfABallThatRollsCloseBesideAWall_data() { addStepperAndModelRows(); }
    void changeNoBitOfABallThatRollsCloseBesideAWall();
    void changeNoBitOfABallThatHitsARoughWall_data() { addStepperAndModelRows(); }
    void changeNoBitOfABallThatHitsARoughWall();
    void changeNoBitOfABallThatRollsAlongAnAxis_data() { addStepperAndModelRows(); }
    void changeNoBitOfABallThatRollsAlongAnAxis();

private:
    static void compareSteps(Experiment &ball);
};

/// A step that fails does so with and without a report.
/// Reported whether or not anything was hit: a cap is a property of the stepper.
void Reports::passesStayWithinTheirCap() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(1.0).ball(0.0625).start(0.5, 0.5), stepper, model);
    ball.roll(1.0, 1.0);
    uint32_t most = 0;
    for (int step = 0; step < 100; ++step) { // into a corner and back
        QVERIFY2(ball.step(0.01), ball.error());
        QCOMPARE(ball.report.pass_cap, 64U);
        most = std::max(most, ball.report.passes);
    }
    QVERIFY(most >= 1 && most <= 64);
}

void Reports::compareSteps(Experiment &ball) {
    for (int step = 0; step < 20; ++step) {
        phys_state without = ball.state;
        const phys_status status =
            phys_step(ball.stepper(), &ball.params, kOddDt, &without, &without, nullptr, nullptr);
        QCOMPARE(ball.step(kOddDt), status == PHYS_OK);
        QVERIFY2(sameBits(ball.state, without), "step " + QByteArray::number(step) + ": x " +
                                                    digits(ball.state.position.x) + " m with a report, " +
                                                    digits(without.position.x) + " m without");
    }
}

/// Farther away than its radius by one rounding step, which the scene's tolerance counts as a contact.
void Reports::changeNoBitOfABallThatAlmostTouchesAWall() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(4.0), stepper, model);
    ball.params.wall_friction = 0.25;
    ball.setPosition(std::nextafter(phys_scene_radius(ball.scene()), std::numeric_limits<double>::infinity()), 2.0);
    ball.setLaw(-0.5, 0.25, 0x1p-7);
    compareSteps(ball);
}

/// So close that looking ahead takes many small steps, without touching anything.
void Reports::changeNoBitOfABallThatRollsCloseBesideAWall() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(4.0), stepper, model);
    ball.setPosition(phys_scene_radius(ball.scene()) + 2e-14, 2.0);
    ball.setLaw(0.0, 0.25, 0x1p-7);
    ball.roll(0.0, 0.5);
    compareSteps(ball);
}

/// The rolling spin acts along the wall at its face: a rough wall lifts the ball off the floor.
void Reports::changeNoBitOfABallThatHitsARoughWall() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(4.0), stepper, model);
    ball.params.wall_friction = 0.25;
    ball.setPosition(phys_scene_radius(ball.scene()), 2.0);
    ball.setLaw(-0.5, 0.25, 0x1p-7);
    ball.roll(-1e-5, 1e-4);
    compareSteps(ball);
}

/// Zeros have a sign too.
void Reports::changeNoBitOfABallThatRollsAlongAnAxis() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    for (const auto &[vx, vy] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        Experiment ball(squareRoom(4.0), stepper, model);
        ball.setPosition(2.0, 2.0);
        ball.setLaw(0.0, 0.0, 0x1p-7);
        ball.roll(vx, vy);
        compareSteps(ball);
    }
}

QTEST_GUILESS_MAIN(Reports)
#include "tst_reports.moc"
