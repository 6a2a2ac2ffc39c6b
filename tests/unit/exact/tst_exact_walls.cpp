// SPDX-License-Identifier: MIT
// The rigid model at a wall with friction, model.md 6.5. Reference values: Newton's and Euler's equations with plain
// vectors and a linear system for the contact forces, integrated to 30 digits.
#include "run.h"

#include <QtTest>

using exact::kU;
using exact::Run;

class ExactWalls : public QObject {
    Q_OBJECT
private slots:
    void followsTheReference_data();
    void followsTheReference();
    void twoStepsAreOne_data() { followsTheReference_data(); }
    void twoStepsAreOne();
    void spinsDownBetweenRoughWalls_data();
    void spinsDownBetweenRoughWalls();
    void fallsBetweenSmoothWalls();
    void hopsAlongARoughWallEndInContact();
    void comingToLeanOnASmoothWallIsReported_data();
    void comingToLeanOnASmoothWallIsReported();
    void rubbingTurnsIntoRolling();
    void ballClimbsAWallThatItsSpinGrips();
    void aShorterBoxInTheSameFaceChangesNothing();
};

namespace {

constexpr double kR = 0x1p-4;

/// A ball that slips at all of its contacts throughout.
struct Stay {
    bool isEdge, flies;
    double wallFriction;
    phys_vec3 gravity, spin;
    double time;
    phys_vec3 position, velocity, spinAfter;
    double heat;
};

/// At the face y = 0 of a wall, or at its corner (0, 0).
void start(Run &run, const Stay &stay) {
    const double up = stay.flies ? 0.25 : 0.0;
    run.state.position = {0.0, kR, kR + up};
    run.state.velocity = {0.5, 0.0, up};
    if (stay.isEdge) run.state.position = {0.28 * kR, 0.96 * kR, kR + up};
    if (stay.isEdge) run.state.velocity = {0.96 * 0.125, -0.28 * 0.125, up};
    run.state.spin = stay.spin;
    run.params.model = PHYS_MODEL_RIGID;
    run.params.rolling_friction = 0.0;
    run.params.sliding_friction = stay.flies || !stay.isEdge ? 0.25 : 0.125;
    run.params.wall_friction = stay.wallFriction;
    run.params.gravity = stay.gravity;
}

std::vector<phys_box> sceneOf(const Stay &stay) {
    return {exact::floorOver(-8, -8, 8, 8), {{-2, -2, 0}, {stay.isEdge ? 0.0 : 2.0, 0, 2}}};
}

double apart(const phys_vec3 &a, const phys_vec3 &b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

} // namespace

void ExactWalls::followsTheReference_data() {
    QTest::addColumn<Stay>("stay");
    QTest::newRow("smooth edge") << Stay{true,
                                         false,
                                         0.0,
                                         {0.5, -3, -9},
                                         {8, 4, 2},
                                         0x1p-6,
                                         {0.019591039412844246333, 0.059350157326871370037, 0.0625},
                                         {0.14766301331457791862, -0.048742447264844306966, 0.0},
                                         {7.3183279298819078873, 3.8279647992839121985, 2.0},
                                         0.0079274220536118896998};
    QTest::newRow("rough face") << Stay{false,
                                        false,
                                        0.25,
                                        {0.5, -1.5, -9},
                                        {4, 12, 3},
                                        0x1p-5,
                                        {0.01625219098954988266, 0.0625, 0.0625},
                                        {0.53924683166224809561, 0.0, 0.0},
                                        {1.7482036729434452726, 10.118159443588073977, 2.0630327100779978018},
                                        0.034068873882439064746};
    QTest::newRow("rough edge") << Stay{true,
                                        false,
                                        0.25,
                                        {0.5, -3, -9},
                                        {8, 4, 2},
                                        0x1p-6,
                                        {0.019534605294918000275, 0.059368756058820717281, 0.0625},
                                        {0.14047809227721205012, -0.04622269805517827766, 0.0},
                                        {6.9667843142998281489, 3.9524627246460679882, 1.7113105378837008597},
                                        0.013001789429603561771};
    QTest::newRow("rough face in the air") << Stay{false,
                                                   true,
                                                   0.25,
                                                   {0.5, -3, -9},
                                                   {-4, 12, 3},
                                                   0x1p-5,
                                                   {0.015553189713594895407, 0.0625, 0.31573505151897873993},
                                                   {0.49480092398309679886, 0.0, -0.041745461223666146332},
                                                   {-3.5801815510533541467, 12.0, 2.1670369593238719543},
                                                   0.017474445731104146274};
    QTest::newRow("rough edge in the air")
        << Stay{true,
                true,
                0.25,
                {0.5, -3, -9},
                {8, 4, 2},
                0x1p-6,
                {0.019466725192151854507, 0.059391048233662624447, 0.31535382019240328157},
                {0.13217076694878666536, -0.043321882255811892309, 0.11555289301724289724},
                {7.7639811461823852356, 4.0731835299891227131, 1.71102430353640729},
                0.0031220962226365886344};
}

void ExactWalls::followsTheReference() {
    QFETCH(Stay, stay);
    Run run(sceneOf(stay), kR, {1, 1, kR});
    start(run, stay);
    run.step(stay.time);
    QCOMPARE(run.events.size(), size_t(0));
    QVERIFY(apart(run.state.position, stay.position) <= 4.0 * kU);
    QVERIFY(apart(run.state.velocity, stay.velocity) <= 4.0 * kU);
    // Spins are some 16 times as large as the speeds that they are made of.
    QVERIFY(apart(run.state.spin, stay.spinAfter) <= 4.0 * kU / kR);
    QVERIFY(std::abs(run.report.lost_slip - stay.heat) <= kU);
    QVERIFY(std::abs(run.report.energy_scheme) <= 16.0 * kU);
}

void ExactWalls::twoStepsAreOne() {
    QFETCH(Stay, stay);
    Run run(sceneOf(stay), kR, {1, 1, kR});
    start(run, stay);
    run.step(0.375 * stay.time);
    run.step(0.625 * stay.time);
    QVERIFY(apart(run.state.position, stay.position) <= 4.0 * kU);
    QVERIFY(apart(run.state.velocity, stay.velocity) <= 8.0 * kU);
    QVERIFY(apart(run.state.spin, stay.spinAfter) <= 8.0 * kU / kR);
}

void ExactWalls::spinsDownBetweenRoughWalls_data() {
    QTest::addColumn<double>("up");
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("spinX");
    QTest::addColumn<double>("spinY");
    QTest::addColumn<double>("spinZ");
    QTest::addColumn<double>("heat");
    QTest::newRow("on the floor") << 0.0 << kR << 0.0 << 7.2295637047375043758 << -3.6088288255298086535
                                  << 11.454452810303315878 << 0.021488495284141985638;
    QTest::newRow("in the air") << 0.25 << 0.31532332722055479676 << 0.11165732730638089755 << 7.9271468566220117325
                                << -3.9815600511227523656 << 11.632634213953491398 << 0.0074105502672248343313;
}

void ExactWalls::spinsDownBetweenRoughWalls() {
    QFETCH(double, up);
    Run run({exact::floorOver(-2, -2, 2, 2), {{-2, -2, 0}, {2, 0, 2}}, {{-2, 0, 0}, {0, 2, 2}}}, kR, {1, 1, kR});
    run.state.position = {kR, kR, kR + up};
    run.state.velocity = {0, 0, up};
    run.state.spin = {8, -4, 12};
    run.params.model = PHYS_MODEL_RIGID;
    run.params.rolling_friction = 0.0;
    run.params.sliding_friction = 0.125;
    run.params.wall_friction = 0.25;
    run.params.gravity = {-1, -1.5, -9};
    run.step(0x1p-6);
    QTEST(run.state.position.z, "height");
    QFETCH(double, speed);
    QFETCH(double, spinX);
    QFETCH(double, spinY);
    QFETCH(double, spinZ);
    QFETCH(double, heat);
    QVERIFY(std::abs(run.state.velocity.z - speed) <= 2.0 * kU);
    QVERIFY(apart(run.state.spin, {spinX, spinY, spinZ}) <= 4.0 * kU / kR);
    QVERIFY(std::abs(run.report.lost_slip - heat) <= kU);
    QVERIFY(std::abs(run.report.energy_scheme) <= 16.0 * kU);
}

void ExactWalls::fallsBetweenSmoothWalls() {
    // Two walls against which the board presses the ball leave it free to move downwards.
    Run run({exact::floorOver(-2, -2, 2, 2), {{-2, -2, 0}, {2, 0, 2}}, {{-2, 0, 0}, {0, 2, 2}}}, kR, {1, 1, kR});
    run.state.position = {kR, kR, kR + 0.5};
    run.params.gravity = {-1, -1.5, -9};
    run.params.restitution_floor = 0.0;
    run.step(0.25);
    QCOMPARE(run.state.velocity.z, -2.25);
    QCOMPARE(run.state.position.z, kR + 0.5 - 0.5 * 9.0 / 16.0);
    run.step(0.25);
    QVERIFY(run.state.flags & PHYS_AT_REST);
    QCOMPARE(run.state.position.x, kR);
    QCOMPARE(run.state.position.z, kR);
}

void ExactWalls::comingToLeanOnASmoothWallIsReported_data() {
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<uint32_t>("options");
    QTest::newRow("rolling") << uint32_t(PHYS_MODEL_ROLLING) << 0U;
    QTest::newRow("rolling, all stages") << uint32_t(PHYS_MODEL_ROLLING) << uint32_t(PHYS_OPTION_ALL_STAGES);
    QTest::newRow("rigid") << uint32_t(PHYS_MODEL_RIGID) << 0U;
    QTest::newRow("rigid, all stages") << uint32_t(PHYS_MODEL_RIGID) << uint32_t(PHYS_OPTION_ALL_STAGES);
}

void ExactWalls::comingToLeanOnASmoothWallIsReported() {
    QFETCH(uint32_t, model);
    QFETCH(uint32_t, options);
    Run run({exact::kFloor, exact::wall(0.5, -2, 1, 2)}, kR, {0.4, 0, kR}, {0.25, 0.125, 0});
    run.params.model = model;
    run.params.options = options;
    run.params.gravity = {1.0, 0.25, -9.75};
    run.params.rolling_friction = 0.002;
    run.step(2.0);
    QCOMPARE(run.eventsOf(PHYS_EVENT_CONTACT).size(), std::size_t(1));
    QCOMPARE(run.eventsOf(PHYS_EVENT_CONTACT).front().box, 1U);
}

void ExactWalls::hopsAlongARoughWallEndInContact() {
    // Each tiny bounce off the wall lifts the ball, and each tiny landing pushes it off the wall: model.md 6.4.
    const double R = 0x1p-5;
    Run run({exact::floorOver(-0.5, -0.5, 4.5, 4.5),
             exact::wall(0.1319507360458374, 0.57809734344482422, 0.28243720531463623, 0.86692357063293457)},
            R, {1, 1, R});
    run.state.position = {0.1007007360458374, 0.79680548451517164, R};
    run.state.velocity = {-2.6537464261973848e-12, 0.1340296909094551, 1.2775379427605284e-10};
    run.state.spin = {-15.808530810808666, -0.77553213463452397, 3.5448938395401175};
    run.params.model = PHYS_MODEL_RIGID;
    run.params.restitution_wall = 0.13738346099853516;
    run.params.rolling_friction = 0.01779097318649292;
    run.params.sliding_friction = 0.071364521980285645;
    run.params.wall_friction = 0.21408724784851074;
    run.params.gravity = {1.4743919372558594, -1.709259033203125, -9.9927959442138672};
    run.step(0x1p-7);
    QVERIFY(run.events.size() < 100);
    QCOMPARE(run.state.flags, uint64_t(PHYS_SLIPPING));
    QCOMPARE(run.state.velocity.x, 0.0);
    // A hop within the tolerance, 4 kU times the walls' height of 16, ends on the floor immediately.
    QVERIFY(std::abs(run.report.energy_scheme) <= 10.0 * 4.0 * kU * 16.0);
}

void ExactWalls::rubbingTurnsIntoRolling() {
    // A groove: floor and wall share the load, (5/9) of the pull remain, and until then there is friction mu_w N along
    // it: v = (5/7)(pull - mu_w N) t and R om_z = R om_0 + (5/2) mu_w N t meet at t.
    Run run({exact::floorOver(-8, -8, 8, 8), exact::wall(-8, -1, 8, 0)}, kR, {0, kR, kR});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.rolling_friction = 0.0;
    run.params.sliding_friction = 0.5;
    run.params.wall_friction = 0.25;
    run.params.gravity = {-0.5, -2.0, -9.0};
    run.state.velocity = {-1.0, 0.0, 0.0};
    run.state.spin = {0.0, -1.0 / kR, 0.0};
    // Along the wall, in the direction of motion: pull 0.5, mu_w N = 0.5, so v stays 1 until R om_z has the same speed.
    const double t = 1.0 / 1.25;
    run.step(t + 0.5);
    QVERIFY(std::abs(run.state.velocity.x + (1.0 + 0.5 * 5.0 / 18.0)) <= 4.0 * kU);
    QVERIFY(std::abs(run.state.position.x + (t + 0.5 + 0.125 * 5.0 / 18.0)) <= 4.0 * kU);
    QVERIFY(std::abs(kR * run.state.spin.z + run.state.velocity.x) <= kU);
    QVERIFY(std::abs(run.report.lost_slip - 0.5 * 0.5 * t) <= 4.0 * kU);
}

void ExactWalls::ballClimbsAWallThatItsSpinGrips() {
    // mu_w N exceeds the weight: a ball that spins up the wall leaves the floor, v_z = (mu_w N - gn) t.
    Run run({exact::floorOver(-8, -8, 8, 8), exact::wall(-8, -1, 8, 0)}, kR, {0, kR, kR});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.rolling_friction = 0.0;
    run.params.sliding_friction = 0.0;
    run.params.wall_friction = 2.0;
    run.params.gravity = {0.0, -6.0, -8.0};
    run.state.spin = {4.0 / kR, 0.0, 0.0};
    run.step(0.0625);
    QVERIFY(run.state.flags & PHYS_AIRBORNE);
    QVERIFY(std::abs(run.state.velocity.z - 4.0 * 0.0625) <= 4.0 * kU);
    QVERIFY(std::abs(run.state.position.z - (kR + 2.0 * 0.0625 * 0.0625)) <= 2.0 * kU);
}

/// A ball rolls towards the place where two walls share a face. What the stepper has learnt there from another ball
/// must not tell.
void ExactWalls::aShorterBoxInTheSameFaceChangesNothing() {
    const std::vector<phys_box> boxes = {
        exact::floorOver(-40, -40, 40, 40), {{-40, 2, 0}, {40, 3, 3}}, {{5, 2, 0}, {6, 10, 3}}};
    const auto prepare = [](Run &run, phys_vec3 position, phys_vec3 velocity) {
        run.params.gravity = {0.15878912359749753, 0.22726753108151787, -9.8};
        run.params.rolling_friction = 0.002;
        run.state.position = position;
        run.state.velocity = velocity;
        run.state.spin = {-velocity.y, velocity.x, 0.0};
    };
    const phys_vec3 place{4.9779047777555583, 0.99996087133693645, 1},
        velocity{2.5074305457087855, 0.00026129928940919972, 0};
    Run fresh(boxes, 1.0, place), used(boxes, 1.0, place);
    prepare(used, {5.705451500163675, 0.5, 1}, velocity);
    used.step(1e-3);
    used.state = fresh.state;
    for (Run *run : {&fresh, &used}) {
        prepare(*run, place, velocity);
        run->step(0.05);
    }
    QVERIFY(exact::equal(used.state.position, fresh.state.position));
    QVERIFY(exact::equal(used.state.velocity, fresh.state.velocity));
}

QTEST_GUILESS_MAIN(ExactWalls)
#include "tst_exact_walls.moc"
