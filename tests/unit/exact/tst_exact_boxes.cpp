// SPDX-License-Identifier: MIT
// Boxes act on all sides, in every phase of a motion: shelves and roofs beside the walls that hold the ball, cracks far
// smaller than the ball, the board's edge and its underside.
#include "run.h"

#include <QtTest>

using exact::kU;
using exact::Run;

namespace {

constexpr double kBoxesRadius = 0.0625;

/// A corner of two walls against which gravity presses the ball, in the air, and a slab across it.
std::vector<phys_box> cornerWith(const phys_box &slab) {
    return {exact::floorOver(-1, -1, 1, 1), {{-1, -1, -1}, {0, 1, 2}}, {{0, -1, -1}, {1, 0, 2}}, slab};
}

} // namespace

class ExactBoxes : public QObject {
    Q_OBJECT
private slots:
    void fallsOnAShelfInACornerOfTwoWalls();
    void isThrownUnderARoofInACornerOfTwoWalls();
    void rollsOverACrack_data();
    void rollsOverACrack();
    void rollsOutOfACrack_data();
    void rollsOutOfACrack();
    void restsOverACrackItIsTooSlowFor();
    void rollsRoundBothEdgesOfAnInnerCornerAtOnce_data();
    void rollsRoundBothEdgesOfAnInnerCornerAtOnce();
    void rollsOnAsItIsPulledBackOverAFloorWithoutPressure();
    void bouncesOffTheUndersideOfTheFloor();
    void spinsInACornerHoweverLittleItsWallsRub_data();
    void spinsInACornerHoweverLittleItsWallsRub();
    void pivotsOverTheBoardsEdgeAndLeavesIt();
    void fallsOffAnEdgeOnWhichItIsNearlyBalanced();
    void resistanceHoldsItBesideRoughWalls_data();
    void resistanceHoldsItBesideRoughWalls();
    void rollingOnRoundingItSpinsAgainstARoughWall_data();
    void rollingOnRoundingItSpinsAgainstARoughWall();
    void resistanceAloneLetsASlipStartAtAnEdge();
    void aRoofThatPressesItOnTheFloorMakesItRoll();
    void restsBesideKerbsWhateverSpinItIsGiven();
};

void ExactBoxes::fallsOnAShelfInACornerOfTwoWalls() {
    Run run(cornerWith({{-1, -1, 0.25}, {0.5, 0.5, 0.375}}), kBoxesRadius, {kBoxesRadius, kBoxesRadius, 0.75});
    run.params.gravity = {-1, -1, -8};
    run.params.restitution_floor = 0.0;
    run.step(1.0);
    QCOMPARE(run.state.position.z, 0.375 + kBoxesRadius);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AT_REST));
}

void ExactBoxes::isThrownUnderARoofInACornerOfTwoWalls() {
    Run run(cornerWith({{-1, -1, 0.5}, {1, 1, 0.625}}), kBoxesRadius, {kBoxesRadius, kBoxesRadius, 0.25}, {0, 0, 4});
    run.params.gravity = {-1, -1, -8};
    run.step(1.0 / 16.0); // reaches the roof at 0.4375 after 0.0495 s
    const std::vector<phys_event> hits = run.eventsOf(PHYS_EVENT_IMPACT);
    QCOMPARE(hits.size(), size_t(1));
    QCOMPARE(hits[0].box, 3U);
    // 0.25 + 4 t - 4 t^2 = 0.4375 at t = (1 - sqrt(0.8125))/2
    QVERIFY(std::abs(hits[0].time - 0.5 * (1.0 - std::sqrt(0.8125))) <= 4.0 * kU);
    QVERIFY(run.state.velocity.z < 0.0);
}

void ExactBoxes::rollsOverACrack_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<uint32_t>("model");
    for (const double width : {1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            QTest::addRow("%g m, model %u", width, model) << width << model;
        }
    }
}

void ExactBoxes::rollsOverACrack() {
    QFETCH(double, width);
    QFETCH(uint32_t, model);
    const double R = 0.006, speed = 0.125;
    Run run({exact::floorOver(-1, -1, 0, 1), exact::floorOver(width, -1, 1, 1)}, R, {-0.0625, 0, R}, {speed, 0, 0});
    run.params.model = model;
    run.state.spin = {0, speed / R, 0};
    run.step(1.0);
    // The dip costs the energy that the second edge takes, less than (v c/R)^2/2, and no time: model.md 14 and 5.6.
    QVERIFY(std::abs(run.state.position.z - R) <= kU);
    QVERIFY(run.state.velocity.x <= speed + 4.0 * kU);
    QVERIFY(speed - run.state.velocity.x <= 4.0 * speed * std::pow(width / R, 2) + 4.0 * kU);
}

void ExactBoxes::rollsOutOfACrack_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<double>("resistance");
    QTest::addColumn<double>("friction");
    for (const double width : {1e-15, 6e-15, 1e-12, 1e-9}) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (const double resistance : {0.0, 0.001}) {
                for (const double friction : {0.0, 0.125}) {
                    QTest::addRow("%g m, model %u, resistance %g, edges' friction %g", width, model, resistance,
                                  friction)
                        << width << model << resistance << friction;
                }
            }
        }
    }
}

/// The two edges' normals are so nearly parallel that the ball leaves either of them with no acceleration but rounding.
void ExactBoxes::rollsOutOfACrack() {
    QFETCH(double, width);
    QFETCH(uint32_t, model);
    QFETCH(double, resistance);
    QFETCH(double, friction);
    const double R = 0.006;
    Run run(
        {{{-0.125, 0.5 * width, -0.02}, {0.125, 0.125, 0.0}}, {{-0.125, -0.125, -0.02}, {0.125, -0.5 * width, 0.0}}}, R,
        {0, 0, R});
    run.params.model = model;
    run.params.rolling_friction = resistance;
    run.params.sliding_friction = 0.25;
    run.params.wall_friction = friction;
    run.params.gravity = {0.0, 0.125, -9.75};
    run.step(0.125);
    const double way = 0.5 * 5.0 / 7.0 * (0.125 - resistance * 9.75) * 0.125 * 0.125;
    const double crossing = std::sqrt(width / 0.125); // during which it may slide instead
    QVERIFY2(std::abs(run.state.position.y - way) <= crossing * 0.125 * 0.125 + width,
             qPrintable(QStringLiteral("%1 m instead of %2 m").arg(run.state.position.y).arg(way)));
}

/// A dip of c^2/(8 R) holds a ball slower than sqrt(gn c^2/(4 R)), here 0.065 m/s.
void ExactBoxes::restsOverACrackItIsTooSlowFor() {
    const double R = 0.006, c = 0.0032;
    Run run({exact::floorOver(-1, -1, 0, 1), exact::floorOver(c, -1, 1, 1)}, R, {-0.01, 0, R}, {0.02, 0, 0});
    run.params.restitution_wall = 0.0;
    run.step(4.0);
    QVERIFY(std::abs(run.state.position.x - 0.5 * c) <= 4.0 * kU);
    QVERIFY(std::abs(run.state.position.z - std::sqrt(R * R - 0.25 * c * c)) <= 4.0 * kU);
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

void ExactBoxes::rollsRoundBothEdgesOfAnInnerCornerAtOnce_data() {
    QTest::addColumn<double>("off");
    for (const double off : {0.0, 1e-15, 1e-14, 1e-13, 1e-12}) QTest::addRow("%g beside it", off) << off;
}

/// Into a pit along the diagonal over the corner of an L-shaped floor: the normals of its edges, at first the same,
/// turn apart.
void ExactBoxes::rollsRoundBothEdgesOfAnInnerCornerAtOnce() {
    QFETCH(double, off);
    for (int i = 0; i < 100; ++i) {
        Run run({{{-30, -30, -9}, {0, 30, 0}}, {{-30, 2.5, -9}, {30, 30, 0}}}, 1.0, {-0.25 + off, 2.75, 1.0});
        run.params.gravity = {0.25, -0.25, -1.0};
        run.params.wall_friction = 0.0;
        run.step(1.8 + 0.004 * i); // after 1.67 s it is at the corner
        QVERIFY(std::abs(run.report.energy_after - run.report.energy_before) <= 1e-11);
        QVERIFY(std::abs(run.state.velocity.x + run.state.velocity.y) <= 1e-8);
    }
}

/// Horizontal gravity: beyond the floor's edge the ball falls along it, over the floor it rolls.
void ExactBoxes::rollsOnAsItIsPulledBackOverAFloorWithoutPressure() {
    for (int i = 0; i < 200; ++i) {
        const double x = 2.001 + 0.005 * i, speed = 0.25, g = 0.75, time = 4.0;
        Run run({{{-30, -30, -1}, {2, 30, 0}}}, 1.0, {x, 0, 1}, {speed, 0, 0});
        run.params.gravity = {-g, 0, 0};
        run.params.restitution_wall = 1.0;
        run.step(time);
        const double back = std::sqrt(speed * speed + 2.0 * g * (x - 2.0)), rolls = time - (speed + back) / g;
        QVERIFY(std::abs(run.state.position.x - (2.0 - rolls * (back + 5.0 / 14.0 * g * rolls))) <= 1e-11);
        QCOMPARE(run.state.velocity.z, 0.0);
    }
}

void ExactBoxes::bouncesOffTheUndersideOfTheFloor() {
    Run run({exact::floorOver(-1, -1, 1, 1)}, kBoxesRadius, {0, 0, -1.5}, {0, 0, 8});
    run.params.gravity = {0, 0, -8};
    run.params.restitution_wall = 0.5;
    run.step(0.25); // it is 0.4375 m below; reached after (1 - sqrt(0.890625)) s
    const std::vector<phys_event> hits = run.eventsOf(PHYS_EVENT_IMPACT);
    QCOMPARE(hits.size(), size_t(1));
    QVERIFY(std::abs(hits[0].time - (1.0 - std::sqrt(0.890625))) <= 4.0 * kU);
    QVERIFY(run.state.position.z < -1.0 - kBoxesRadius);
}

void ExactBoxes::spinsInACornerHoweverLittleItsWallsRub_data() {
    QTest::addColumn<double>("friction");
    for (const double friction : {1e-300, 1e-213, 1e-100, 1e-50, 1e-20, 1e-16, 1e-10, 1e-3}) {
        QTest::addRow("%g", friction) << friction;
    }
}

void ExactBoxes::spinsInACornerHoweverLittleItsWallsRub() {
    QFETCH(double, friction);
    Run run({exact::floorOver(-1, -1, 2, 2), exact::wall(-1, -1, 2, 0), exact::wall(1, 0, 2, 2)}, kBoxesRadius,
            {1 - kBoxesRadius, kBoxesRadius, kBoxesRadius});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.sliding_friction = 0.0;
    run.params.wall_friction = friction;
    run.params.gravity = {0.5, -0.75, -10};
    run.state.spin = {0, 0, 256};
    run.step(0.25);
    // Both walls rub: om_z' = -(5/(2R)) mu (N_1 + N_2) with N of 0.5 and 0.75, as the friction at one wall hardly
    // presses the ball against the other.
    const double expected = 256.0 - 0.25 * 2.5 / kBoxesRadius * friction * 1.25;
    QVERIFY(std::abs(run.state.spin.z - expected) <= 16.0 * friction * friction + 256.0 * 4.0 * kU);
    QCOMPARE(run.state.velocity.x, 0.0);
    QCOMPARE(run.state.velocity.y, 0.0);
}

/// model.md 7: cos alpha = (2 + v0^2/(gn R))/3 without friction, (10 + 7 v0^2/(gn R))/17 if it rolls; from rest at the
/// edge, slightly beyond it.
void ExactBoxes::pivotsOverTheBoardsEdgeAndLeavesIt() {
    const double R = 0.005, v0 = 0.0625, gn = 9.75;
    for (const bool isRough : {false, true}) {
        Run run({exact::floorOver(-1, -1, 0, 1)}, R, {0, 0, R}, {v0, 0, 0});
        run.params.model = isRough ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
        run.params.gravity = {0, 0, -gn};
        run.params.wall_friction = 1e4;
        run.params.sliding_friction = 1.0;
        run.state.spin = {0, v0 / R, 0};
        run.step(0.0625);
        const std::vector<phys_event> left = run.eventsOf(PHYS_EVENT_RELEASE);
        QCOMPARE(left.size(), size_t(1));
        const double share = v0 * v0 / (gn * R);
        const double expected = isRough ? (10.0 + 7.0 * share) / 17.0 : (2.0 + share) / 3.0;
        // However rough the edge, it holds the ball only while the ball presses on it: the ball slips shortly before.
        QVERIFY(std::abs(left[0].normal.z - expected) <= (isRough ? 2e-5 : 4.0 * kU / R));
    }
}

void ExactBoxes::fallsOffAnEdgeOnWhichItIsNearlyBalanced() {
    const double R = 0.0078125, gn = 9.75, time = 0.125, times = std::cosh(time * std::sqrt(gn / R));
    for (const double off : {1e-14, 1e-12, 1e-10, 1e-9, 5e-9, 1e-8, 1e-6}) {
        Run run({exact::floorOver(-1, -1, 0, 1)}, R, {off, 0, R});
        run.params.gravity = {0, 0, -gn};
        run.step(time);
        const double angle = off * times / R; // the law of small ones errs by its square
        QVERIFY(std::abs(run.state.position.x - off * times) <= (1e-9 + angle * angle) * off * times);
    }
}

void ExactBoxes::resistanceHoldsItBesideRoughWalls_data() {
    QTest::addColumn<double>("drive");
    QTest::addColumn<double>("speed");
    QTest::addColumn<bool>("isCorner");
    for (const double drive : {0.125, 0.5, 0.999, 1.001}) {
        QTest::addRow("%g of the limit, at rest", drive) << drive << 0.0 << false;
        QTest::addRow("%g of the limit, away from a second wall", drive) << drive << 0.0 << true;
    }
    QTest::addRow("rolls until it stops") << 0.5 << 0.0625 << false;
    QTest::addRow("rolls by rounding") << 0.5 << 1e-19 << false;
}

/// Along the wall resistance holds forces below mu_r gn. The wall's friction doesn't contribute, as it would only turn
/// the ball about the vertical.
void ExactBoxes::resistanceHoldsItBesideRoughWalls() {
    QFETCH(double, drive);
    QFETCH(double, speed);
    QFETCH(bool, isCorner);
    const double resistance = 0.015625, gn = 9.75;
    std::vector<phys_box> boxes{exact::floorOver(-1, -1, 1, 1), exact::wall(-1, -1, 0, 1)};
    if (isCorner) boxes.push_back(exact::wall(0, -1, 1, -kBoxesRadius));
    Run run(boxes, kBoxesRadius, {kBoxesRadius, 0, kBoxesRadius}, {0, speed, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.sliding_friction = 0.3125;
    run.params.wall_friction = 0.375;
    run.params.rolling_friction = resistance;
    run.params.gravity = {-0.25, drive * resistance * gn, -gn};
    run.state.spin = {-speed / kBoxesRadius, 0, speed / kBoxesRadius};
    run.step(2.0);
    QCOMPARE(bool(run.state.flags & PHYS_AT_REST), drive < 1.0);
    QCOMPARE(run.state.position.y > 0.0, drive > 1.0 || speed > kU);
    QCOMPARE(run.state.position.x, kBoxesRadius);
    QCOMPARE(run.state.position.z, kBoxesRadius);
}

void ExactBoxes::rollingOnRoundingItSpinsAgainstARoughWall_data() {
    QTest::addColumn<double>("rounding");
    for (const double rounding : {0.0, 1e-300, 1e-30, 1e-19, 1e-17, 1e-15, 1e-13, 1e-11}) {
        QTest::addRow("%g m/s", rounding) << rounding;
    }
}

/// A spin about the vertical that rubs at a wall drives the ball along it, whatever rounding error its velocity has.
void ExactBoxes::rollingOnRoundingItSpinsAgainstARoughWall() {
    QFETCH(double, rounding);
    const double R = 0.006;
    Run run({exact::floorOver(-1, -1, 1, 1), exact::wall(-1, -1, 1, 0)}, R, {0, R, R}, {-rounding, 0, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.sliding_friction = 0.115;
    run.params.wall_friction = 0.205;
    run.params.rolling_friction = 0.01;
    run.params.gravity = {-1.4123, -1.4127, -9.6006};
    run.state.spin = {-0.75 * rounding / R, -0.0625 * rounding / R, 0.33};
    const phys_state start = run.state;
    run.step(0.002);
    const phys_state moved = run.state;
    QVERIFY(moved.velocity.x < 0.0);
    run.state = start;
    run.state.velocity.x = 0.0;
    run.state.spin = {0, 0, 0.33};
    run.step(0.002);
    QVERIFY(std::abs(moved.position.x - run.state.position.x) <= 1e-15 + 4.0 * rounding);
}

/// Rolling round an upright edge, the required friction exceeds the cone because of the resistance; without resistance
/// both contacts stick, so that no slip has a direction.
void ExactBoxes::resistanceAloneLetsASlipStartAtAnEdge() {
    const double c = 0.1973234, s = std::sqrt(1.0 - c * c), speed = 0.011831;
    Run run({exact::floorOver(-1, -1, 1, 1), exact::wall(-1, 0, 0, 1)}, kBoxesRadius,
            {kBoxesRadius * c, -kBoxesRadius * s, kBoxesRadius}, {-speed * s, -speed * c, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.sliding_friction = 0.145917;
    run.params.wall_friction = 0.240514;
    run.params.rolling_friction = 0.00156939;
    run.params.gravity = {0.947895, 1.28372, -9.67934};
    run.state.spin = {speed * c / kBoxesRadius, -speed * s / kBoxesRadius, -speed / kBoxesRadius};
    run.step(0.001);
    const phys_vec3 &p = run.state.position;
    QVERIFY(std::abs(std::hypot(p.x, p.y) - kBoxesRadius) <= 4.0 * kU);
    QVERIFY(run.state.velocity.x * s + run.state.velocity.y * c < 0.0);
}

/// Gravity pulls upwards, into the edge of a smooth roof with the normal (0.6, 0, -0.8), which presses the ball on the
/// floor: model.md 2.1 R7.
void ExactBoxes::aRoofThatPressesItOnTheFloorMakesItRoll() {
    Run run({exact::kFloor, {{-1, -1, 1.8 * kBoxesRadius}, {-0.6 * kBoxesRadius, 1, 1}}}, kBoxesRadius,
            {4, 0, kBoxesRadius}); // no floor there
    run.state.position = {0, 0, kBoxesRadius};
    run.params.rolling_friction = 0.01;
    run.params.gravity = {-7.0, 3.0, 1.5};
    run.state.spin = {20, 0, 30};
    run.step(0.01);
    const double pressure = 7.0 / 0.6 * 0.8 - 1.5, speed = 0.01 * 5.0 / 7.0 * (3.0 - 0.01 * pressure);
    QVERIFY(std::abs(run.state.velocity.y - speed) <= 1e-15);
    QVERIFY(std::abs(run.state.spin.x + speed / kBoxesRadius) <= 1e-13);
    QCOMPARE(run.state.spin.z, 0.0);
    QVERIFY(std::abs(run.report.lost_slip - 0.2 * kBoxesRadius * kBoxesRadius * 1300.0) <= 1e-14);
}

/// Resistance holds a ball on the floor that isn't turning, as in the rolling model at rest; with another spin, kerbs
/// would carry it.
void ExactBoxes::restsBesideKerbsWhateverSpinItIsGiven() {
    const double R = 0.006;
    Run run({{{-0.0107, -0.029, -0.009}, {0.045, 0.028, 0}},
             {{-0.017, -0.054, -0.0125}, {-0.0059095555239792614, 0.032, 0.004962139937657201}},
             {{-0.022, -0.021, -0.0055}, {-6.8180868060286066e-06, -0.00036422958207613635, 1.1069350440519321e-05}}},
            R, {0, 0, R});
    run.params.rolling_friction = 1.77;
    run.params.gravity = {-2.6, -4.6, -6.4};
    run.state.spin = {-22.9, 24.6, -56};
    run.step(0.01);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AT_REST));
}

QTEST_GUILESS_MAIN(ExactBoxes)
#include "tst_exact_boxes.moc"
