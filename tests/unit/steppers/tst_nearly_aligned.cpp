// SPDX-License-Identifier: MIT
// Features whose normals are nearly parallel, nearly opposite or nearly in one plane: an edge a hair beside the centre,
// a mouth hardly lower than the ball; or gravity that hardly opens a contact. Equations there lose digits, and what
// they lose must neither hold the ball nor drive it: model.md 14.1.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace support;

namespace {

constexpr double kAlignedRadius = 0.0078125;

/// A ball at rest around the origin, touching a box with each normal, in the rigid model without bounces.
struct Aligned {
    std::vector<phys_vec3> normals;
    double floor, wall, rolling; ///< friction
    phys_vec3 gravity;
};

phys_box boxAlong(const phys_vec3 &normal) {
    const double n[3] = {normal.x, normal.y, normal.z}, size = std::hypot(n[0], n[1], n[2]);
    double low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double at = -kAlignedRadius * (n[axis] / size);
        low[axis] = n[axis] > 0.0 ? at - kAlignedRadius : n[axis] < 0.0 ? at : -3.0 * kAlignedRadius;
        high[axis] = n[axis] > 0.0 ? at : n[axis] < 0.0 ? at + kAlignedRadius : 3.0 * kAlignedRadius;
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

Experiment ballAmong(const QByteArray &stepper, const Aligned &start) {
    SceneBuilder scene;
    scene.ball(kAlignedRadius).start({0.0, 0.0, -8.0 * kAlignedRadius});
    for (const phys_vec3 &normal : start.normals) scene.box(boxAlong(normal));
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = start.gravity;
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = start.floor;
    ball.params.wall_friction = start.wall;
    ball.params.rolling_friction = start.rolling;
    ball.state.position = {0.0, 0.0, 0.0};
    return ball;
}

const phys_vec3 kFloorNormal{0.0, 0.0, 1.0};

const Aligned kBesideARoofEdge{{{0.958326709, 0.0, -0.285674496}, {0.471160618, 0.0, 0.882047432}, {0.0, 1e-5, -1.0}},
                               0.7,
                               0.7,
                               0.0,
                               {-3.39, -2.38, 0.0}};
const Aligned kBesideAWallEdge{{kFloorNormal, {0.0, -0.923654054, 0.383227333}, {5.3e-7, 1.0, 7.9e-5}},
                               0.7197,
                               0.9531,
                               0.0,
                               {-7.869, 4.859, -21.4765}};
const Aligned kUnderAHairOfARoof{
    {kFloorNormal, {1.0, 0.0, -8.8e-5}, {0.0, -5.5e-9, -1.0}}, 0.9, 0.3, 0.0, {-6.2, 2.5, -6.3}};
const Aligned kUnderTwoHairs{
    {kFloorNormal, {-1.4e-8, 0.0, -1.0}, {4.4e-6, 0.0, -1.0}}, 0.18, 0.3, 0.18, {6.9, -4.8, -17.0}};
const Aligned kAtAWallUnderAHair{
    {kFloorNormal, {0.0, -1.0, 0.0}, {1.8e-8, 0.0, -1.0}}, 0.34, 0.36, 0.02, {-5.5, 1.8, -16.7}};
const Aligned kUnderARoofOfADiameter{{kFloorNormal, {0.0, 8.8e-12, -1.0}}, 0.71, 0.98, 0.0, {-5.863, -2.793, -9.865}};

} // namespace

class TestNearlyAligned : public QObject {
    Q_OBJECT

private slots:
    void noHairHoldsABall_data();
    void noHairHoldsABall();
    void resistanceHoldsABallInANarrowMouth_data() { addStepperRows(); }
    void resistanceHoldsABallInANarrowMouth();
    void resistanceStopsABallInANarrowMouth_data() { addStepperRows(); }
    void resistanceStopsABallInANarrowMouth();
    void aJamInAMouthEndsAsInExact_data() { addStepperRows(); }
    void aJamInAMouthEndsAsInExact();
    void allSlipsEndInAJamForWhichNoConeSuffices_data() { addStepperRows(); }
    void allSlipsEndInAJamForWhichNoConeSuffices();
    void climbsAKerbHoweverShortTheStep_data() { addStepperAndModelRows(); }
    void climbsAKerbHoweverShortTheStep();
    void leavesAWallHoweverShortTheStep_data() { addStepperRows(); }
    void leavesAWallHoweverShortTheStep();
};

void TestNearlyAligned::noHairHoldsABall_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<Aligned>("start");
    QTest::addColumn<phys_vec3>("wanted"); // m/s after 20 ms
    const std::tuple<const char *, Aligned, phys_vec3> rows[] = {
        {"a roof's edge", kBesideARoofEdge, {0.0, -0.00614, 0.0}},
        {"a wall's edge", kBesideAWallEdge, {-0.0137, 0.0, 0.0}},
        {"a roof's edge and a wall", kUnderAHairOfARoof, {0.0, 0.0278, 0.0}},
        {"two roofs' edges", kUnderTwoHairs, {0.0624, -0.0434, 0.0}},
        {"a roof's edge a diameter up", kUnderARoofOfADiameter, {-0.0838, -0.0399, 0.0}},
        {"a wall and a roof's edge", kAtAWallUnderAHair, {-0.0647, 0.0, 0.0}},
    };
    for (const QByteArray &stepper : stepperIds()) {
        for (const auto &[name, start, wanted] : rows)
            QTest::addRow("%s, %s", stepper.constData(), name) << stepper << start << wanted;
    }
}

void TestNearlyAligned::noHairHoldsABall() {
    QFETCH(QByteArray, stepper);
    QFETCH(Aligned, start);
    QFETCH(phys_vec3, wanted);
    for (const int steps : {20, 40}) {
        Experiment ball = ballAmong(stepper, start);
        QVERIFY2(ball.stepTimes(static_cast<uint64_t>(steps), 0.02 / steps), ball.error());
        const phys_vec3 &v = ball.state.velocity;
        const double off = std::hypot(v.x - wanted.x, v.y - wanted.y, v.z - wanted.z);
        const double speed = std::hypot(wanted.x, wanted.y, wanted.z);
        QVERIFY2(off < 0.06 * speed,
                 qPrintable(QStringLiteral("%1 steps: (%2, %3, %4)").arg(steps).arg(v.x).arg(v.y).arg(v.z)));
        QVERIFY((ball.state.flags & PHYS_AT_REST) == 0);
    }
}

void TestNearlyAligned::resistanceHoldsABallInANarrowMouth() {
    QFETCH(QByteArray, stepper);
    const Aligned mouth{{kFloorNormal, {1.1e-4, 0.0, -1.0}}, 0.24, 0.96, 0.23, {-9.8, 0.45, -13.6}};
    Experiment ball = ballAmong(stepper, mouth);
    QVERIFY2(ball.stepTimes(20, 1e-3), ball.error());
    QVERIFY(ball.state.flags & PHYS_AT_REST);
    QCOMPARE(ball.state.spin.z, 0.0);
}

void TestNearlyAligned::resistanceStopsABallInANarrowMouth() {
    QFETCH(QByteArray, stepper);
    const double radius = 0.006, roof = 0.0119991;
    SceneBuilder scene;
    scene.ball(radius).start({0.0, 0.0, radius});
    scene.box({{-0.12, -0.12, -0.03}, {0.12, 0.12, 0.0}}).box({{0.0072, -0.12, roof}, {0.12, 0.12, 0.022}});
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {1.7, 0.16, -9.66};
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = 0.35;
    ball.params.wall_friction = 0.7;
    ball.params.rolling_friction = 0.014;
    ball.state.velocity = {0.3, 0.12, 0.0};
    ball.state.spin = {-20.0, 50.0, 0.0};
    QVERIFY2(ball.stepTimes(200, 1e-3), ball.error());
    QVERIFY(ball.state.flags & PHYS_AT_REST);
}

/// It rolls against the edge of a roof.
void TestNearlyAligned::aJamInAMouthEndsAsInExact() {
    QFETCH(QByteArray, stepper);
    constexpr double R = 0.006, kRoof = 0.01198850398049792, kDuration = 0.2;
    SceneBuilder scene;
    scene.ball(R).start({0.0, 0.0, R}).box({{-0.12, -0.12, -0.03}, {0.12, 0.12, 0.0}});
    scene.box({{0.0072, -0.12, kRoof}, {0.12, 0.12, kRoof + 0.01}});
    scene.box({{-0.12, 0.0053856847889216337, kRoof}, {0.12, 0.12, kRoof + 0.01}});
    const auto endOf = [&](const QByteArray &id, uint64_t steps) {
        Experiment ball(scene, id, PHYS_MODEL_RIGID);
        ball.params.gravity = {3.343296965142553, 3.3432969651425504, -8.5953959074458695};
        ball.params.restitution_floor = 0.0;
        ball.params.restitution_wall = 0.12934824264244407;
        ball.params.sliding_friction = 0.11821121339025477;
        ball.params.wall_friction = 0.61020272428770006;
        ball.state.velocity = {0.015323817904719589, -0.0072833328765059564, 0.0};
        if (!ball.stepTimes(steps, kDuration / static_cast<double>(steps))) qFatal("%s", ball.error());
        return ball.state.position;
    };
    const phys_vec3 end = endOf(stepper, 32000), wanted = endOf("exact", 1);
    COMPARE_WITHIN(end.x, wanted.x, 1e-3 * R);
    COMPARE_WITHIN(end.y, wanted.y, 1e-3 * R);
}

/// It slips along the edge of a roof on a floor. Without slip at both it turns about the line through the two points,
/// with the angular momentum about that line that it had: neither impulse has a moment about it.
void TestNearlyAligned::allSlipsEndInAJamForWhichNoConeSuffices() {
    QFETCH(QByteArray, stepper);
    constexpr double R = 0.006, kSine = 0.0466, kSpeed = 1.05, kStep = 1e-7;
    const double cosine = std::sqrt(1.0 - kSine * kSine);
    SceneBuilder scene;
    scene.ball(R).start({kSine * R, 0.0, R}).box({{-0.1, -0.1, -0.02}, {0.1, 0.1, 0.0}});
    scene.box({{-0.1, -0.1, R + cosine * R}, {0.0, 0.1, R + cosine * R + 0.01}});
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {-0.5, -1.5, -9.8};
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = 2.86;
    ball.params.wall_friction = 0.266;
    ball.state.velocity = {0.0, kSpeed, 0.0};
    ball.state.spin = {-176.0, -61.0, -52.0};
    const phys_vec3 before = ball.state.spin;
    QVERIFY2(ball.stepTimes(1, kStep), ball.error());
    const double size = std::hypot(kSine, 1.0 + cosine); // of the way from one point to the other, in R
    const double alongX = kSine / size, alongZ = -(1.0 + cosine) / size, arm = R * alongX;
    const double momentum = 0.4 * R * R * (before.x * alongX + before.z * alongZ) - arm * kSpeed;
    const double turn = momentum / (0.4 * R * R + arm * arm);
    COMPARE_WITHIN(ball.state.velocity.y, -arm * turn, 1e-5 * kSpeed);
    COMPARE_WITHIN(ball.state.spin.x, turn * alongX, 1e-5 * kSpeed / R);
    COMPARE_WITHIN(ball.state.spin.y, 0.0, 1e-5 * kSpeed / R);
    COMPARE_WITHIN(ball.state.spin.z, turn * alongZ, 1e-5 * kSpeed / R);
}

/// Beyond the tilt at which it tips by a share so small that it leaves the floor by less than rounding in a step.
void TestNearlyAligned::climbsAKerbHoweverShortTheStep() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    constexpr double R = 0.006, kHeight = 0.5 * R, kShare = 1e-6, kGravity = 9.81;
    const double edge = std::sqrt(R * R - (R - kHeight) * (R - kHeight)), tipping = edge / (R - kHeight);
    SceneBuilder scene;
    scene.ball(R).start({0.0, 0.0, R});
    scene.box({{-1.0, -1.0, -1.0}, {1.0, 1.0, 0.0}}).box({{edge, -1.0, 0.0}, {1.0, 1.0, kHeight}});
    for (const double dt : {1e-5, 1e-6, 1e-7}) {
        Experiment ball(scene, stepper, model);
        ball.params.gravity = {kGravity * tipping * (1.0 + kShare), 0.0, -kGravity};
        QVERIFY2(ball.stepTimes(100, dt), ball.error());
        // Across the edge, whose normal is (-edge, R - height)/R.
        const double acceleration = kShare * kGravity * tipping * (R - kHeight) / R, end = 100.0 * dt;
        const phys_vec3 &v = ball.state.velocity;
        COMPARE_WITHIN(v.x * (R - kHeight) / R + v.z * edge / R, acceleration * end, 0.02 * acceleration * end);
    }
}

/// The friction of a spinning ball on the floor, 4.5 m/s^2, drives it off a wall against gravity.
void TestNearlyAligned::leavesAWallHoweverShortTheStep() {
    QFETCH(QByteArray, stepper);
    constexpr double R = 0.25, kAway = 0.45 * 10.0 - 3.0;
    SceneBuilder scene;
    scene.ball(R).start({0.0, 0.0, R});
    scene.box({{-5.0, -5.0, -1.0}, {5.0, 5.0, 0.0}}).box({{-5.0, R, 0.0}, {5.0, 5.0, 2.0}});
    for (const double dt : {1e-6, 1e-8, 1e-10}) {
        Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
        ball.params.gravity = {0.0, 3.0, -10.0};
        ball.params.sliding_friction = 0.45;
        ball.state.spin.x = 8.0;
        QVERIFY2(ball.stepTimes(200, dt), ball.error());
        COMPARE_WITHIN(ball.state.velocity.y, -kAway * 200.0 * dt, 1e-3 * kAway * 200.0 * dt);
    }
}

QTEST_GUILESS_MAIN(TestNearlyAligned)
#include "tst_nearly_aligned.moc"
