// SPDX-License-Identifier: MIT
// The rigid model at a wall under friction, model.md 6.5. Figures: Newton's and Euler's equations with plain vectors
// and a linear system for the contact forces, integrated to 30 digits.
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
};

namespace {

constexpr double kR = 0x1p-4;

/// A ball that slips on everything it touches, all through.
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

std::vector<phys_box> scene(const Stay &stay) {
    return {exact::floorOver(-8, -8, 8, 8), {{-2, -2, 0}, {stay.isEdge ? 0.0 : 2.0, 0, 2}}};
}

double apart(const phys_vec3 &a, const phys_vec3 &b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

} // namespace

Q_DECLARE_METATYPE(Stay)

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
    Run run(scene(stay), kR, {1, 1, kR});
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
    Run run(scene(stay), kR, {1, 1, kR});
    start(run, stay);
    run.step(0.375 * stay.time);
    run.step(0.625 * stay.time);
    QVERIFY(apart(run.state.position, stay.position) <= 4.0 * kU);
    QVERIFY(apart(run.state.velocity, stay.velocity) <= 8.0 * kU);
    QVERIFY(apart(run.state.spin, stay.spinAfter) <= 8.0 * kU / kR);
}

QTEST_GUILESS_MAIN(ExactWalls)
#include "tst_exact_walls.moc"
