// SPDX-License-Identifier: MIT
// Slip, spin and rough walls: model.md 2.2, 3.6, 4 and 6.5, and the F rows of 12.2.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <cmath>

using namespace support;

namespace {

constexpr double kRigidRadius = 0.0625;

SceneBuilder wallOnTheLeft() {
    return SceneBuilder().ball(kRigidRadius).floor(-9, -9, 9, 9).wall(-1, -9, 0, 9).start(kRigidRadius, 0.0);
}

Experiment rigid(const SceneBuilder &scene, const QByteArray &stepper, double slidingFriction) {
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {0.0, 0.0, -9.81};
    ball.params.sliding_friction = slidingFriction;
    ball.params.restitution_wall = 0.8;
    return ball;
}

/// Steps until the ball rolls again, at most `steps` times; sums the losses on the way.
struct Slide {
    double lostImpact = 0.0;
    double lostSlip = 0.0;
    bool rolls = false;
};

Slide stepUntilItRolls(Experiment &ball, double dt, int steps) {
    Slide slide;
    bool slips = false;
    for (int i = 0; i < steps; ++i) {
        if (!ball.step(dt)) return slide;
        slide.lostImpact += ball.report.lost_impact;
        slide.lostSlip += ball.report.lost_slip;
        slips = slips || ball.state.flags & PHYS_SLIPPING;
        slide.rolls = slips && !(ball.state.flags & PHYS_SLIPPING);
        if (slide.rolls) return slide;
    }
    return slide;
}

} // namespace

class TestRigidModel : public QObject {
    Q_OBJECT

private slots:
    void rollingBallKeepsTheEffectiveRestitution_data() { addStepperRows(); }
    void rollingBallKeepsTheEffectiveRestitution();
    void slipAfterABounceLastsAsLongAsPredicted_data() { addStepperRows(); }
    void slipAfterABounceLastsAsLongAsPredicted();
    void slipsAfterABounceAsOnTheFloorAlone_data() { addStepperRows(); }
    void slipsAfterABounceAsOnTheFloorAlone();
    void roughWallLiftsTheBall_data();
    void roughWallLiftsTheBall();
    void slipEndsInTheComputedVelocity_data() { addStepperRows(); }
    void slipEndsInTheComputedVelocity();
    void resistanceBeginsWhereATurningSlipEnds();
    void spinAboutTheVerticalIsFree_data() { addStepperRows(); }
    void spinAboutTheVerticalIsFree();
    void rollsLikeTheRollingModelWhereFrictionHolds_data() { addStepperRows(); }
    void rollsLikeTheRollingModelWhereFrictionHolds();
    void slipsOnASlopeTooSteepForFriction_data() { addStepperRows(); }
    void slipsOnASlopeTooSteepForFriction();
    void rollsInTheGrooveOfFloorAndRoughWall_data() { addStepperRows(); }
    void rollsInTheGrooveOfFloorAndRoughWall();
    void resistanceDoesNotSpendTheFrictionOfFloorAndKerb_data() { addStepperRows(); }
    void resistanceDoesNotSpendTheFrictionOfFloorAndKerb();
    void strongResistanceInAGrooveHasItsClosedForm_data();
    void strongResistanceInAGrooveHasItsClosedForm();
    void rollingRoundAnUprightEdgeIsResisted_data();
    void rollingRoundAnUprightEdgeIsResisted();
    void whatIsLeftOfAnApproachHasNoPartInAnImpact_data() { addStepperRows(); }
    void whatIsLeftOfAnApproachHasNoPartInAnImpact();
    void staysAtTwoEdgesThatItRollsOver_data();
    void staysAtTwoEdgesThatItRollsOver();
    void ofThreeWallsTheTwoThatPressLeastPress_data() { addStepperRows(); }
    void ofThreeWallsTheTwoThatPressLeastPress();
    void frictionAlonePressesOnAnEdge_data() { addStepperRows(); }
    void frictionAlonePressesOnAnEdge();
    void landsWhileItSlidesAlongARoofsEdge_data() { addStepperRows(); }
    void landsWhileItSlidesAlongARoofsEdge();
};

void TestRigidModel::rollingBallKeepsTheEffectiveRestitution() {
    QFETCH(QByteArray, stepper);
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.3);
    ball.setPosition(0.25, 0.0);
    ball.roll(-0.7, 0.4);
    const double dt = 0x1p-12;
    const Slide slide = stepUntilItRolls(ball, dt, 8192);
    QVERIFY2(slide.rolls, ball.error());
    // model.md 12.2: (5 eps - 2)/7 V = 0.2; friction can't change 5v + 2w, so any scheme has it to rounding.
    COMPARE_WITHIN(ball.state.velocity.x, 0.2, rounding(1e4, 1.0));
    COMPARE_WITHIN(ball.state.velocity.y, 0.4, rounding(1e4, 1.0));
    COMPARE_WITHIN(slide.lostImpact, 0.0882, rounding(16, 0.1));
    // Euler's path of the slip is half a step's slip too long or too short: mu_s gn |u0| dt/2, and the same at its end.
    const double slack = promiseOf(stepper).smooth == 0 ? rounding(1e4, 0.3) : 0.3 * 9.81 * 1.26 * dt;
    COMPARE_WITHIN(slide.lostSlip, 0.2268, slack);
}

void TestRigidModel::slipAfterABounceLastsAsLongAsPredicted() {
    QFETCH(QByteArray, stepper);
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.3);
    ball.setPosition(kRigidRadius + 0x1p-20, 0.0);
    ball.roll(-0.5, 0.0);
    const double dt = 0x1p-12;
    QVERIFY2(stepUntilItRolls(ball, dt, 8192).rolls, ball.error());
    // model.md 12.2: t_s, the path, 1/7; the impact is at most a step late, and so is the end of the slip.
    COMPARE_WITHIN(ball.state.time, 0.087374399301004805592, 2.0 * dt);
    COMPARE_WITHIN(ball.state.position.x - kRigidRadius, 0.023715908381701304375, 2.0 * 0.4 * dt);
    COMPARE_WITHIN(ball.state.velocity.x, 1.0 / 7.0, rounding(1e4, 0.5));
}

void TestRigidModel::slipsAfterABounceAsOnTheFloorAlone() {
    QFETCH(QByteArray, stepper);
    constexpr double kDt = 0x1p-7;
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.25);
    ball.params.gravity = {0.25, -0.5, -9.81};
    ball.params.restitution_wall = 0.5;
    ball.setPosition(kRigidRadius, 0.0); // it touches the wall
    ball.roll(-0.5, 0.25);
    Experiment alone = rigid(openFloor(), stepper, 0.25);
    alone.params.gravity = ball.params.gravity;
    alone.state = ball.state;
    alone.state.velocity.x = 0.25;
    QVERIFY2(ball.step(kDt) && alone.step(kDt), ball.error());
    QCOMPARE(ball.report.event_count, 1U);
    const phys_state &found = ball.state, &expected = alone.state;
    COMPARE_WITHIN(found.position.x, expected.position.x, rounding(4, 0.1));
    COMPARE_WITHIN(found.position.y, expected.position.y, rounding(4, 0.1));
    COMPARE_WITHIN(found.velocity.x, expected.velocity.x, rounding(4, 0.5));
    COMPARE_WITHIN(found.velocity.y, expected.velocity.y, rounding(4, 0.5));
    COMPARE_WITHIN(found.spin.x, expected.spin.x, rounding(4, 8.0));
    COMPARE_WITHIN(found.spin.y, expected.spin.y, rounding(4, 8.0));
    COMPARE_WITHIN(ball.report.lost_slip, alone.report.lost_slip, rounding(4, 0.1));
}

void TestRigidModel::roughWallLiftsTheBall_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("wallFriction");
    QTest::addColumn<double>("vz");
    QTest::addColumn<double>("vt");
    for (const QByteArray &id : stepperIds()) {
        QTest::addRow("%s, slides", id.constData()) << id << 0.1 << 0.109398635908 << 0.337486493767;
        QTest::addRow("%s, sticks", id.constData()) << id << 0.3 << 0.2 << 2.0 / 7.0;
    }
}

void TestRigidModel::roughWallLiftsTheBall() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, wallFriction);
    QFETCH(double, vz);
    QFETCH(double, vt);
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.3);
    if (!ball.isReady()) QSKIP(ball.error());
    ball.params.wall_friction = wallFriction;
    ball.setPosition(kRigidRadius + 0x1p-12, 0.0);
    ball.roll(-0.7, 0.4);
    bool bounced = false;
    const double dt = 0x1p-10;
    for (int i = 0; i < 4 && !bounced; ++i) {
        QVERIFY2(ball.step(dt), ball.error());
        bounced = ball.state.velocity.x > 0.0;
    }
    QVERIFY(bounced);
    // Just after the bounce; flight may have begun within the same step. The figures have 12 digits.
    const double slack = 5e-13 + rounding(64, 1.0);
    QVERIFY(ball.state.velocity.z <= vz + slack && ball.state.velocity.z >= vz - 9.81 * dt - slack);
    COMPARE_WITHIN(ball.state.velocity.y, vt, slack);
    QVERIFY(ball.state.flags & PHYS_AIRBORNE);
}

void TestRigidModel::slipEndsInTheComputedVelocity() {
    QFETCH(QByteArray, stepper);
    const auto scene = SceneBuilder().ball(0.005).floor(-1, -1, 1, 1).start(0, 0);
    // model.md 12.2: t_s and the ball's state then; from there it rolls with 5/7 of the slope's acceleration.
    const double end = 0.014300320760347717058;
    const double after = 0.015625 - end;
    for (const double dt : {0x1p-12, 0x1p-14, 0x1p-16}) {
        Experiment ball = rigid(scene, stepper, 0.2);
        ball.params.gravity = {0.9, -0.5, -9.7};
        ball.state.velocity = {0.3, 0.2, 0.0};
        ball.state.spin = {-30.0, 80.0, 15.0};
        QVERIFY2(ball.stepFor(0.015625, dt), ball.error());
        QVERIFY(!(ball.state.flags & PHYS_SLIPPING));
        const double vx = 0.33776449191736638954 + 5.0 / 7.0 * 0.9 * after;
        const double vy = 0.18060702829987581534 - 5.0 / 7.0 * 0.5 * after;
        COMPARE_WITHIN(ball.state.velocity.x, vx, rounding(1e4, 1.0));
        COMPARE_WITHIN(ball.state.velocity.y, vy, rounding(1e4, 1.0));
        // 2/7 of the slip's path: half a step of |u0| = 0.112 m/s off, and the clamp's as much again.
        const double slack = promiseOf(stepper).smooth == 0 ? rounding(1e4, 0.01) : 2.0 / 7.0 * 0.112 * dt;
        COMPARE_WITHIN(ball.state.position.x,
                       0.0045598129871729534431 + 0.33776449191736638954 * after + 5.0 / 14.0 * 0.9 * after * after,
                       slack);
        COMPARE_WITHIN(ball.state.position.y,
                       0.0027207722601183883503 + 0.18060702829987581534 * after - 5.0 / 14.0 * 0.5 * after * after,
                       slack);
        COMPARE_EXACT(ball.state.spin.z, 15.0);
    }
}

/// On a slope a slip turns before it ends: where it is across its first direction, nothing ends yet.
void TestRigidModel::resistanceBeginsWhereATurningSlipEnds() {
    const auto scene = SceneBuilder().ball(0.01).floor(-1, -1, 1, 1).start(0, 0);
    for (int direction = 0; direction < 8; ++direction) {
        Experiment swept = rigid(scene, "swept", 0.2), exact = rigid(scene, "exact", 0.2);
        for (Experiment *ball : {&swept, &exact}) {
            ball->params.gravity = {5.0, 0.0, -9.0};
            ball->params.rolling_friction = 0.1;
            ball->state.velocity = {0.04 * std::cos(direction), 0.04 * std::sin(direction), 0.0};
            QVERIFY2(ball->step(0.05), ball->error());
            QVERIFY(!(ball->state.flags & PHYS_SLIPPING));
        }
        // The way that it rolls after that turns by less, in a step of second order.
        COMPARE_WITHIN(swept.state.velocity.x, exact.state.velocity.x, 1e-4);
        COMPARE_WITHIN(swept.state.velocity.y, exact.state.velocity.y, 1e-4);
        COMPARE_WITHIN(swept.state.position.x, exact.state.position.x, 1e-5);
        COMPARE_WITHIN(swept.state.position.y, exact.state.position.y, 1e-5);
    }
}

void TestRigidModel::spinAboutTheVerticalIsFree() {
    QFETCH(QByteArray, stepper);
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.3);
    ball.setPosition(0.5, 0.0);
    ball.roll(-0.7, 0.4);
    ball.state.spin.z = 12.5;
    QVERIFY2(ball.stepTimes(1000, 0.002), ball.error());
    COMPARE_EXACT(ball.state.spin.z, 12.5);
}

void TestRigidModel::rollsLikeTheRollingModelWhereFrictionHolds() {
    QFETCH(QByteArray, stepper);
    Experiment a(openFloor(), stepper, PHYS_MODEL_ROLLING);
    Experiment b(openFloor(), stepper, PHYS_MODEL_RIGID);
    for (Experiment *ball : {&a, &b}) {
        ball->setLaw(0.3, -0.2, 0.1);
        ball->roll(-0.5, 0.25);
    }
    for (int i = 0; i < 500; ++i) {
        QVERIFY2(a.step(0.01), a.error());
        QVERIFY2(b.step(0.01), b.error());
        QVERIFY(sameBits(a.state, b.state));
    }
}

void TestRigidModel::slipsOnASlopeTooSteepForFriction() {
    QFETCH(QByteArray, stepper);
    // model.md 2.2 F2: rolls iff |g_t| <= 7/2 mu_s gn = 3.5 * 0.125 * 8 = 3.5, exactly.
    for (const bool above : {false, true}) {
        Experiment ball = rigid(openFloor(1000.0), stepper, 0.125);
        ball.params.gravity = {above ? 3.5 * (1.0 + 0x1p-20) : 3.5, 0.0, -8.0};
        QVERIFY2(ball.stepFor(1.0, 1.0 / 128.0), ball.error());
        // Slipping: v' = g_t - mu_s gn = 2.5, which at the limit equals that of rolling: 5/7 of 3.5.
        COMPARE_WITHIN(ball.state.velocity.x, 2.5, 2.0 * 3.5 * 0x1p-20);
        QCOMPARE((ball.state.flags & PHYS_SLIPPING) != 0, above);
    }
    Experiment ball = rigid(openFloor(1000.0), stepper, 0.125);
    ball.params.gravity = {5.0, 0.0, -8.0};
    QVERIFY2(ball.stepFor(1.0, 1.0 / 128.0), ball.error());
    COMPARE_WITHIN(ball.state.velocity.x, 4.0, rounding(1e3, 4.0));
    // w' = (5/2) mu_s gn.
    COMPARE_WITHIN(ball.state.spin.y * kRigidRadius, 2.5, rounding(1e3, 4.0));
}

void TestRigidModel::rollsInTheGrooveOfFloorAndRoughWall() {
    QFETCH(QByteArray, stepper);
    if (promiseOf(stepper).heats) QSKIP("Explicit Euler doesn't stay in contact: model.md 10.3");
    Experiment ball = rigid(wallOnTheLeft(), stepper, 0.5);
    ball.params.gravity = {-0.8, 0.5, -9.81};
    ball.params.wall_friction = 0.25; // at least 5/36, model.md 12.2
    const double dt = 0x1p-10;
    QVERIFY2(ball.stepFor(1.0, dt), ball.error());
    // a = (5/9) 0.5; contacts that are solved in turn are of first order (model.md 6.5).
    const double slack = promiseOf(stepper).smooth == 0 ? rounding(1e4, 1.0) : dt;
    COMPARE_WITHIN(ball.state.velocity.y, 5.0 / 9.0 * 0.5, slack);
    COMPARE_WITHIN(ball.state.position.y, 5.0 / 9.0 * 0.5 / 2.0, slack);
    COMPARE_EXACT(ball.state.position.x, kRigidRadius);
}

void TestRigidModel::resistanceDoesNotSpendTheFrictionOfFloorAndKerb() {
    QFETCH(QByteArray, stepper);
    // Both contacts stick, the ball stops and starts back. Without resistance the floor needs 0.04336 N of friction, so
    // that from there on mu_s has no effect: model.md 13.5.
    const double R = 0.006, h = 0.005, c = std::sqrt(R * R - (R - h) * (R - h)), v = -0.05;
    const auto rolled = [&](double friction, int steps) {
        Experiment ball(
            SceneBuilder().ball(R).box({{-1, -1, -0.02}, {1, 1, 0}}).box({{c, -1, -0.02}, {1, 1, h}}).start(0, 0),
            stepper, PHYS_MODEL_RIGID);
        ball.params.gravity = {2.9136, 1.8527, -9.1823};
        ball.params.rolling_friction = 0.027;
        ball.params.sliding_friction = friction;
        ball.params.wall_friction = 0.15;
        ball.state.velocity = {0.0, v, 0.0};
        ball.state.spin = {-v / R, 0.0, -(v / R) * (1.0 - (R - h) / R) * R / c};
        return ball.stepTimes(steps, 0.05 / steps) ? ball.state.velocity.y : NAN;
    };
    const bool findsStops = promiseOf(stepper).impacts != 1;
    for (const double friction : {0.0434, 0.0446, 0.0455, 0.046, 0.05, 0.06}) {
        for (const int steps : {50, 500}) {
            // Both decelerations act for at most a step too long.
            const double slack = findsStops ? 1e-6 : 4.0 * 0.05 / steps;
            COMPARE_WITHIN(rolled(friction, steps), 0.00923421, slack);
            COMPARE_WITHIN(rolled(friction, steps), rolled(0.3, steps), rounding(1e4, -v));
        }
    }
}

void TestRigidModel::strongResistanceInAGrooveHasItsClosedForm_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("height"); // of the kerb, in radii
    QTest::addColumn<double>("resistance");
    QTest::addColumn<double>("wallFriction");
    QTest::addColumn<double>("slope"); // g_y; the kerb's edge sticks or slips, without resistance it does the same
    QTest::addColumn<bool>("sticks");
    for (const QByteArray &stepper : stepperIds()) {
        QTest::addRow("%s, edge sticks", stepper.constData()) << stepper << 0.6735 << 0.5266 << 0.4527 << -2.67 << true;
        QTest::addRow("%s, edge slips the other way without resistance", stepper.constData())
            << stepper << 0.776 << 0.4341 << 0.3721 << -2.31 << false;
    }
}

void TestRigidModel::strongResistanceInAGrooveHasItsClosedForm() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, height);
    QFETCH(double, resistance);
    QFETCH(double, wallFriction);
    QFETCH(double, slope);
    QFETCH(bool, sticks);
    // Along a kerb whose edge has the normal (-s, 0, k): least friction has none across the groove, model.md 14.1.
    const double R = 0.006, k = 1.0 - height, s = std::sqrt(1.0 - k * k), v = -0.08, T = 0.0194;
    const phys_vec3 g{sticks ? 2.63 : 0.394, slope, -8.0};
    const double onEdge = g.x / s, onFloor = -g.z - k * onEdge;
    const double turn = (1.0 - k) / s; // om_z/om_x while both stick
    // Resistance and, once it slips, the edge's friction take from the motion along y.
    const double a = sticks ? (slope + resistance * onFloor) / (1.0 + 0.4 * (1.0 + turn * turn))
                            : (slope + resistance * onFloor - (1.0 - k) * wallFriction * onEdge) / 1.4;
    for (const int steps : {40, 400}) {
        Experiment ball(SceneBuilder()
                            .ball(R)
                            .box({{-1, -1, -0.02}, {1, 1, 0}})
                            .box({{s * R, -1, -0.02}, {1, 1, height * R}})
                            .start(0, 0),
                        stepper, PHYS_MODEL_RIGID);
        ball.params.gravity = g;
        ball.params.rolling_friction = resistance;
        ball.params.sliding_friction = 0.6;
        ball.params.wall_friction = wallFriction;
        ball.state.velocity = {0.0, v, 0.0};
        ball.state.spin = {-v / R, 0.0, -v / R * turn};
        QVERIFY2(ball.stepTimes(steps, T / steps), ball.error());
        COMPARE_WITHIN(ball.state.velocity.y, v + a * T, rounding(1e4, -v));
    }
}

void TestRigidModel::rollingRoundAnUprightEdgeIsResisted_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("slidingFriction");
    QTest::addColumn<double>("wallFriction");
    for (const QByteArray &stepper : stepperIds()) {
        QTest::addRow("%s, 1 and 1", stepper.constData()) << stepper << 1.0 << 1.0;
        QTest::addRow("%s, 0.3 and 0.6", stepper.constData()) << stepper << 0.3 << 0.6;
        QTest::addRow("%s, 0.6 and 0.3", stepper.constData()) << stepper << 0.6 << 0.3;
    }
}

/// The edge's normal turns: a ball that follows it in straight substeps has a gap to close in each of them.
void TestRigidModel::rollingRoundAnUprightEdgeIsResisted() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, slidingFriction);
    QFETCH(double, wallFriction);
    constexpr double R = 0.01, T = 0.005;
    struct End {
        phys_vec3 velocity;
        double lostRolling;
    };
    const auto run = [&](const QByteArray &id, int steps) {
        const SceneBuilder floorAndPillar =
            SceneBuilder().ball(R).floor(-1, -1, 1, 1).box({{-1, -1, 0}, {-0.008, -0.006, 1}}).start(0, 0);
        Experiment ball = rigid(floorAndPillar, id, slidingFriction);
        ball.params.gravity = {-4, -2, -9};
        ball.params.wall_friction = wallFriction;
        ball.params.rolling_friction = 0.1;
        ball.state.velocity = {0.03, -0.04, 0};
        ball.state.spin = {4, 3, -5};
        End end{};
        for (int i = 0; i < steps && ball.step(T / steps); ++i) end.lostRolling += ball.report.lost_rolling;
        if (ball.state.flags != 0) end.lostRolling = NAN; // it neither slips nor leaves the floor
        end.velocity = ball.state.velocity;
        return end;
    };
    const End reference = run("exact", 1);
    QVERIFY(reference.lostRolling > 2e-4);
    for (const int steps : {10, 100, 1000}) {
        const End end = run(stepper, steps);
        COMPARE_WITHIN(end.lostRolling, reference.lostRolling, 0.01 / steps * reference.lostRolling);
        COMPARE_WITHIN(end.velocity.x, reference.velocity.x, 0.02 / steps * reference.velocity.x);
    }
}

/// A wall and both edges of an upright slot: two of them hold the ball, and either edge may be the second one with the
/// wall or with the other edge. All slips are vertical.
/// Let go on one edge of a wedge, the ball rolls down over it into the other, which alone is hit, with friction.
void TestRigidModel::whatIsLeftOfAnApproachHasNoPartInAnImpact() {
    QFETCH(QByteArray, stepper);
    constexpr int kSteps = 8000;
    Experiment ball(SceneBuilder()
                        .ball(0.006)
                        .box({{-0.24, -0.24, -0.054}, {-0.005315619662932391, 0.24, 0.0}})
                        .box({{0.005315619662932391, -0.023088200904668427, -0.054},
                              {0.24, 0.019718363261323105, -0.0023626351781111544}})
                        .start({0.0, 0.0, -0.6}),
                    stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {-1.977952861248388, -3.1165477911643795, -9.089055635436926};
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.rolling_friction = 0.0627238457723299;
    ball.params.sliding_friction = 0.6046824204889044;
    ball.params.wall_friction = 0.045677977638866406;
    ball.state.position = {0.00019805865964938024, 0.0, 0.0023662948580199955};
    QVERIFY2(ball.stepTimes(kSteps, 0.06486232841586086 / kSteps), ball.error());
    const double off = ball.state.position.y / 0.006 + 0.822839484; // of exact, and of an integrator of its own
    QVERIFY2(std::abs(off) < 1e-3, qPrintable(QStringLiteral("off by %1 R").arg(off)));
}

void TestRigidModel::staysAtTwoEdgesThatItRollsOver_data() {
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &id : higherOrderStepperIds()) QTest::newRow(id.constData()) << id;
}

/// Out of the inner corner of a hole, whose edges have nearly the same normal.
void TestRigidModel::staysAtTwoEdgesThatItRollsOver() {
    QFETCH(QByteArray, stepper);
    constexpr int kSteps = 100;
    Experiment ball(SceneBuilder()
                        .ball(1.0)
                        .box({{-20.0, -20.0, -4.0}, {-0.4, 20.0, 0.0}})
                        .box({{-20.0, -20.0, -4.0}, {20.0, -0.4, 0.0}})
                        .start({0.0, 0.0, -5.5}),
                    stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {-4.0, -5.0, -7.6};
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = ball.params.wall_friction = 1.0;
    ball.state.position = {0.0, 0.0, std::sqrt(1.0 - 0.4 * 0.4)};
    QVERIFY2(ball.stepTimes(kSteps, 1.0 / kSteps), ball.error());
    const double off = std::hypot(ball.state.position.x + 1.157552, ball.state.position.y + 1.227512); // of exact
    QVERIFY2(off < 1e-3, qPrintable(QStringLiteral("off by %1 R").arg(off)));
}

void TestRigidModel::ofThreeWallsTheTwoThatPressLeastPress() {
    QFETCH(QByteArray, stepper);
    const double R = 0.01, dt = 1e-5;
    Experiment ball(SceneBuilder()
                        .ball(R)
                        .box({{R, -1, -1}, {1, 1, 1}})
                        .box({{-1, 0.6 * R, -1}, {-0.8 * R, 1, 1}})
                        .box({{0.8 * R, 0.6 * R, -1}, {1, 1, 1}})
                        .start({0, 0, 0}),
                    stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {3.0, 8.0, 0.0};
    ball.params.wall_friction = 0.5;
    ball.state.spin = {10.0, 5.0, 0.0};
    QVERIFY2(ball.stepTimes(10, dt), ball.error());
    // The edges' reactions sum up to 8/0.6: model.md 14.1.
    COMPARE_WITHIN(ball.state.velocity.z, -0.5 * 8.0 / 0.6 * 10.0 * dt, rounding(1e4, 1e-3));
}

/// Gravity pulls the ball from one of two edges, and the friction of the other presses it there.
void TestRigidModel::frictionAlonePressesOnAnEdge() {
    QFETCH(QByteArray, stepper);
    const double R = 0.01, T = 1.6e-3;
    const int steps = 10;
    struct {
        double speed;
        phys_vec3 end; ///< velocity by `exact`
    } const ways[] = {{0.05, {0.028113981036, 0.036913581267, -0.021331803400}},
                      {-0.05, {-0.019464254349, -0.026293370706, 0.014456856473}}};
    for (const auto &way : ways) {
        Experiment ball(SceneBuilder()
                            .ball(R)
                            .box({{0.8 * R, -1, -1}, {1, -0.6 * R, 1}})
                            .box({{-1, -1, -1}, {-0.6 * R, 1, -0.8 * R}})
                            .start({0, 0, 0}),
                        stepper, PHYS_MODEL_RIGID);
        ball.params.gravity = {9.0, 0.0, -3.0};
        ball.params.wall_friction = 1.0;
        const double along = way.speed / std::hypot(0.48, 0.64, 0.36);
        ball.state.velocity = {0.48 * along, 0.64 * along, -0.36 * along};
        ball.state.spin = {-3.0, -12.0, 2.0};
        QVERIFY2(ball.stepTimes(steps, T / steps), ball.error());
        const double slack = promiseOf(stepper).smooth == 1 ? 2e-2 : 2e-4; // of the weight
        COMPARE_WITHIN(ball.state.velocity.x, way.end.x, slack * 9.5 * T);
        COMPARE_WITHIN(ball.state.velocity.y, way.end.y, slack * 9.5 * T);
        COMPARE_WITHIN(ball.state.velocity.z, way.end.z, slack * 9.5 * T);
    }
}

/// Friction on the floor throws the ball off the edge, which therefore takes no part in the landing, 13.2.
void TestRigidModel::landsWhileItSlidesAlongARoofsEdge() {
    QFETCH(QByteArray, stepper);
    constexpr double kEdgeX = 0.014717049886568537, kEdgeZ = 0.010651638929163256;
    const SceneBuilder scene = SceneBuilder()
                                   .ball(0.01)
                                   .floor(-0.3, -0.3, 0.3, 0.3)
                                   .box({{kEdgeX, -0.3, kEdgeZ}, {0.06, 0.3, 0.03}})
                                   .start(0.0, 0.0);
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {2.5339760725920835, -1.5117374132487857, -9.3557316793992502};
    ball.params.rolling_friction = ball.params.restitution_wall = 0.0;
    ball.params.sliding_friction = 1.2699480959475755;
    ball.params.wall_friction = 1.3937088709323142;
    ball.params.restitution_floor = 0.17396365178491713;
    ball.state.position = {0.004738255190795803, -0.0053311346715594699, 0.010000749983475945};
    ball.state.velocity = {0.0035893577390645587, -0.13541968086521736, -0.055028533216194754};
    ball.state.spin = {19.861697667090528, -5.1913275967134851, 14.777152074408304};
    QVERIFY2(ball.stepTimes(16, 1.25e-5), ball.error());
    COMPARE_WITHIN(ball.state.velocity.x, -0.01181, 1e-4);
    COMPARE_WITHIN(ball.state.velocity.y, -0.15377, 1e-4);
    COMPARE_WITHIN(ball.state.velocity.z, 0.00785, 1e-4);
}

QTEST_GUILESS_MAIN(TestRigidModel)
#include "tst_rigid_model.moc"
