// SPDX-License-Identifier: MIT
// A ball that rolls on a floor with resistance and about a corner or an edge, and sticks at both only as they press
// each other, model.md 14.1: resistance depends on that pressure. The figures are from a program that solves the law of
// the moment for any such pressure and finds the least one by bisection, and the motion from that by Runge and Kutta's
// method. Without that pressure the accelerations would be those of forces beyond Coulomb's cones, 0.02 to 1.3 % off.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <cmath>

using namespace support;

namespace {

struct PrestressedStart {
    phys_box other; ///< what it touches besides the floor, radius 1
    phys_vec3 velocity, spin, gravity;
    double floor, wall, rolling; ///< friction
};

const PrestressedStart kFloorSpent{{{0.8, 0.6, 0.0}, {9.0, 9.0, 9.0}},
                                   {-0.354, 0.472, 0.0},
                                   {-0.472, -0.354, -0.59},
                                   {0.79, 0.86, -0.18},
                                   0.18,
                                   0.64,
                                   0.07};
const PrestressedStart kEdgeSpent{{{0.96, 0.28, 0.0}, {9.0, 9.0, 9.0}},
                                  {0.1792, -0.6144, 0.0},
                                  {0.6144, 0.1792, 0.64},
                                  {1.07, 0.16, -0.86},
                                  1.63,
                                  0.12,
                                  0.24};
const PrestressedStart kBesideACorner{
    {{0.8264427916240862, -9.0, 0.0}, {9.0, -0.20924432231874004, 0.4773058965800758}},
    {0.11140495040841006, 0.44001107029332026, 0.0},
    {-0.44001107029332026, 0.11140495040841006, -0.254125125828481},
    {0.315021662295615, -0.6947815994085702, -0.5205162250484384},
    0.233764598839315,
    2.781841535535284,
    0.026081956920614754};

Experiment prestressedBall(const QByteArray &stepper, const PrestressedStart &start) {
    SceneBuilder scene;
    scene.ball(1.0).start({0.0, 0.0, 1.0}).box({{-9.0, -9.0, -1.0}, {9.0, 9.0, 0.0}}).box(start.other);
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = start.gravity;
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = start.floor;
    ball.params.wall_friction = start.wall;
    ball.params.rolling_friction = start.rolling;
    ball.state.velocity = start.velocity;
    ball.state.spin = start.spin;
    return ball;
}

} // namespace

class TestPrestress : public QObject {
    Q_OBJECT

private slots:
    void resistanceBelongsToThePressureWithWhichBothStick_data();
    void resistanceBelongsToThePressureWithWhichBothStick();
    void thePressureFollowsTheMotion_data() { addStepperRows(); }
    void thePressureFollowsTheMotion();
    void exactFollowsItInOneStep();
};

void TestPrestress::resistanceBelongsToThePressureWithWhichBothStick_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("which");
    for (const QByteArray &stepper : stepperIds()) {
        const char *const names[] = {"an upright edge, friction spent at the floor",
                                     "an upright edge, friction spent there", "a low corner"};
        for (int i = 0; i < 3; ++i) QTest::addRow("%s, %s", stepper.constData(), names[i]) << stepper << i;
    }
}

void TestPrestress::resistanceBelongsToThePressureWithWhichBothStick() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, which);
    const PrestressedStart starts[] = {kFloorSpent, kEdgeSpent, kBesideACorner};
    constexpr phys_vec3 kWanted[] = {{0.214040247, 0.294779671, -0.107399588},
                                     {0.381373455, 0.155291010, -0.0422948018},
                                     {0.136368150, -0.445987395, 0.223320498}}; // z: of the spin
    constexpr double kStep = 1e-6, kRounding = 1e-5;
    const PrestressedStart &start = starts[which];
    Experiment ball = prestressedBall(stepper, start);
    QVERIFY2(ball.step(kStep), ball.error());
    COMPARE_WITHIN((ball.state.velocity.x - start.velocity.x) / kStep, kWanted[which].x, kRounding);
    COMPARE_WITHIN((ball.state.velocity.y - start.velocity.y) / kStep, kWanted[which].y, kRounding);
    COMPARE_WITHIN((ball.state.spin.z - start.spin.z) / kStep, kWanted[which].z, kRounding);
}

constexpr double kPrestressedTime = 0.1;
constexpr phys_vec3 kPrestressedEnd{0.0198224730092911, -0.0606849244413858, 1.0};

void TestPrestress::thePressureFollowsTheMotion() {
    QFETCH(QByteArray, stepper);
    constexpr int kSteps = 1000;
    Experiment ball = prestressedBall(stepper, kEdgeSpent);
    QVERIFY2(ball.stepTimes(kSteps, kPrestressedTime / kSteps), ball.error());
    COMPARE_WITHIN(ball.state.position.x, kPrestressedEnd.x, 1e-6);
    COMPARE_WITHIN(ball.state.position.y, kPrestressedEnd.y, 1e-6);
}

void TestPrestress::exactFollowsItInOneStep() {
    Experiment ball = prestressedBall("exact", kEdgeSpent);
    QVERIFY2(ball.step(kPrestressedTime), ball.error());
    COMPARE_WITHIN(ball.state.position.x, kPrestressedEnd.x, 1e-11);
    COMPARE_WITHIN(ball.state.position.y, kPrestressedEnd.y, 1e-11);
}

QTEST_GUILESS_MAIN(TestPrestress)
#include "tst_prestress.moc"
