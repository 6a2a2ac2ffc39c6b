// SPDX-License-Identifier: MIT
// Bounces: model.md 2.1, 5 and 6.4, and the figures of 12.2.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <cmath>

using namespace support;

namespace {

constexpr double kImpactRadius = 0.0625;

/// A wall of 1 m to the left of x = 0; the ball touches it.
SceneBuilder leftWall() {
    return SceneBuilder().ball(kImpactRadius).floor(-1, -20, 20, 20).wall(-1, -20, 0, 20).start(kImpactRadius, 0.0);
}

/// False if a step fails, or nothing is hit within a second.
bool stepToFirstImpact(Experiment &ball) {
    do {
        if (!ball.step(1.0 / 256.0)) return false;
    } while (ball.report.event_count == 0 && ball.state.time < 1.0);
    return ball.report.event_count > 0;
}

/// Spin that friction can't change: impacts of a rigid ball are then those of a rolling one.
void makeSmooth(Experiment &ball) { ball.params.sliding_friction = 0.0; }

/// Weightless, straight towards the top of the wall's end (0, 0) along -normal: the only impact is head-on, whatever
/// the step.
void bouncesOffTheWallsEnd(const QByteArray &stepper, uint32_t model, const phys_vec3 &normal, double wallFrom) {
    constexpr double kTop = 4.0 * kImpactRadius;
    constexpr double kWay = 0.25; // after half a second
    const auto scene = SceneBuilder().ball(kImpactRadius).floor(-9, -9, 9, 9).wall(0, wallFrom, 1, 2).start(-1, -1);
    Experiment ball(scene, stepper, model);
    ball.params.gravity = {0.0, 0.0, 0.0};
    ball.params.restitution_floor = 0.9;
    ball.params.restitution_wall = 0.1;
    const double from = kImpactRadius + kWay;
    ball.state.position = {from * normal.x, from * normal.y, kTop + from * normal.z};
    ball.state.velocity = {-0.5 * normal.x, -0.5 * normal.y, -0.5 * normal.z};
    // Slower than 2 dt v^2/R it would stay, model.md 13.5.
    QVERIFY2(ball.stepFor(1.0, 1.0 / 1024.0), ball.error());
    // model.md 13.1: every edge and every corner has restitution_wall. A rounding error of the position turns the
    // normal by it over R.
    const double slack = rounding(2 * 1024, 0.5) / kImpactRadius;
    COMPARE_WITHIN(ball.state.velocity.x, 0.05 * normal.x, slack);
    COMPARE_WITHIN(ball.state.velocity.y, 0.05 * normal.y, slack);
    COMPARE_WITHIN(ball.state.velocity.z, 0.05 * normal.z, slack);
}

} // namespace

class TestImpacts : public QObject {
    Q_OBJECT

private slots:
    void headOnGivesTheRestitutionsShareBack_data();
    void headOnGivesTheRestitutionsShareBack();
    void landingWithoutReboundPutsTheBallDown_data() { addStepperAndModelRows(); }
    void landingWithoutReboundPutsTheBallDown();
    void wallWithoutReboundStopsTheBallAtItsFace_data() { addStepperAndModelRows(); }
    void wallWithoutReboundStopsTheBallAtItsFace();
    void startInsideAWallCostsNoSpeed_data() { addStepperAndModelRows(); }
    void startInsideAWallCostsNoSpeed();
    void startInsideAWallBouncesOffItsFace_data() { addStepperAndModelRows(); }
    void startInsideAWallBouncesOffItsFace();
    void cornerTurnsBothComponentsBack_data() { addStepperAndModelRows(); }
    void cornerTurnsBothComponentsBack();
    void topEdgeOfAWallHasTheWallsRestitution_data() { addStepperAndModelRows(); }
    void topEdgeOfAWallHasTheWallsRestitution();
    void topCornerOfAWallHasTheWallsRestitution_data() { addStepperAndModelRows(); }
    void topCornerOfAWallHasTheWallsRestitution();
    void hitAtARoofsEdgeLeavesTheBallOnItsFloor_data() { addStepperAndModelRows(); }
    void hitAtARoofsEdgeLeavesTheBallOnItsFloor();
    void ballThatFloorAndRoofStopTouchesBoth_data() { addStepperAndModelRows(); }
    void ballThatFloorAndRoofStopTouchesBoth();
    void hopsUnderAnEdgeTakeNoSpeedAlongTheFloor_data() { addStepperRows(); }
    void hopsUnderAnEdgeTakeNoSpeedAlongTheFloor();
    void hopsOnTheFloorEnd_data() { addStepperRows(); }
    void hopsOnTheFloorEnd();
    void bounceOnTheFloorNeedsNoGravity_data() { addStepperAndModelRows(); }
    void bounceOnTheFloorNeedsNoGravity();
    void recedingBallIsNotPulledBack_data() { addStepperAndModelRows(); }
    void recedingBallIsNotPulledBack();
    void comesOutBesideACornerFromNextToNothing_data() { addStepperAndModelRows(); }
    void comesOutBesideACornerFromNextToNothing();
    void grazingAnEdgeChangesNothing_data() { addStepperAndModelRows(); }
    void grazingAnEdgeChangesNothing();
    void seamOfFlushWallsIsNotFelt_data() { addStepperAndModelRows(); }
    void seamOfFlushWallsIsNotFelt();
    void seamOfFlushFloorsIsNotFelt_data() { addStepperAndModelRows(); }
    void seamOfFlushFloorsIsNotFelt();
    void edgeOnAParabolaDeflectsAsComputed_data() { addStepperRows(); }
    void edgeOnAParabolaDeflectsAsComputed();
    void edgeDeflectsAsWhereItIsMet_data() { addStepperAndModelRows(); }
    void edgeDeflectsAsWhereItIsMet();
    void bouncesAccumulateWhenPredicted_data();
    void bouncesAccumulateWhenPredicted();
    void impactEventTellsWhatHappened_data() { addStepperAndModelRows(); }
    void impactEventTellsWhatHappened();
    void sweptFindsAWallThatTheBallWouldTurnBackBehind();
    void eventsWithoutRoomAreCounted_data() { addStepperRows(); }
    void eventsWithoutRoomAreCounted();
    void jointOfAStraightEdgeKicksNoBall_data() { addStepperRows(); }
    void jointOfAStraightEdgeKicksNoBall();
    void floorThrowsTheBallAgainstARoofThatItTouches_data() { addStepperRows(); }
    void floorThrowsTheBallAgainstARoofThatItTouches();
};

void TestImpacts::headOnGivesTheRestitutionsShareBack_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<double>("restitution");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (const double restitution : {0.0, 0.25, 0.75, 1.0}) {
                QTest::addRow("%s, %s, restitution %g", id.constData(), modelName(model).constData(), restitution)
                    << id << model << restitution;
            }
        }
    }
}

void TestImpacts::headOnGivesTheRestitutionsShareBack() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(double, restitution);
    Experiment ball(leftWall(), stepper, model);
    makeSmooth(ball);
    ball.params.restitution_wall = restitution;
    ball.setPosition(0.5, 0.0);
    ball.roll(-0.5, 0.375);
    QVERIFY2(ball.stepFor(1.0, 1.0 / 128.0), ball.error());
    // No force and short binary numbers: only the sevenths of a slipping rigid ball's velocity are rounded.
    const double slack = model == PHYS_MODEL_RIGID ? rounding(2 * 128, 0.5) : 0.0;
    COMPARE_WITHIN(ball.state.velocity.x, 0.5 * restitution, slack);
    COMPARE_WITHIN(ball.state.velocity.y, 0.375, slack);
}

/// Where the ball remains above the floor it falls again, for a time of the order of the square root of the step.
void TestImpacts::landingWithoutReboundPutsTheBallDown() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(openFloor(), stepper, model);
    ball.params.restitution_floor = 0.0;
    ball.params.gravity = {3.0, 0.0, -8.0};
    ball.state.position.z = kImpactRadius + 0.05;
    QVERIFY2(stepToFirstImpact(ball), ball.error());
    COMPARE_WITHIN(ball.state.position.z, kImpactRadius, rounding(8, 100.0));
}

/// The spin, which the impact doesn't stop, may press a rigid ball on the wall from then on.
void TestImpacts::wallWithoutReboundStopsTheBallAtItsFace() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(leftWall(), stepper, model);
    ball.params.restitution_wall = 0.0;
    ball.params.sliding_friction = 0.25;
    ball.params.wall_friction = 0.25;
    ball.setPosition(0.15, 0.0);
    ball.roll(-0.5, 0.3);
    QVERIFY2(stepToFirstImpact(ball), ball.error());
    COMPARE_WITHIN(ball.state.position.x, kImpactRadius, rounding(8, 20.0));
}

/// Moving along the wall and pulled into it, the centre outside the wall and inside.
void TestImpacts::startInsideAWallCostsNoSpeed() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    for (const double depth : {0.5 * kImpactRadius, 1.25 * kImpactRadius}) {
        Experiment ball(leftWall(), stepper, model);
        makeSmooth(ball);
        ball.params.gravity = {-0.5, 0.0, -8.0};
        ball.setPosition(kImpactRadius - depth, 0.0);
        ball.roll(0.0, 0.25);
        QVERIFY2(ball.step(0x1p-10), ball.error());
        // model.md 5.7: it is put out of the wall, which is no motion.
        COMPARE_EXACT(ball.state.position.x, kImpactRadius);
        COMPARE_EXACT(ball.state.velocity.y, 0.25);
        COMPARE_EXACT(ball.report.penetration, depth);
        COMPARE_WITHIN(ball.report.energy_scheme, 0.5 * depth, rounding(16, 1.0));
    }
}

void TestImpacts::startInsideAWallBouncesOffItsFace() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    for (const double depth : {0.5 * kImpactRadius, 1.25 * kImpactRadius}) {
        Experiment ball(leftWall(), stepper, model);
        makeSmooth(ball);
        ball.params.restitution_wall = 0.5;
        ball.setPosition(kImpactRadius - depth, 0.0);
        ball.roll(-0.5, 0.25);
        QVERIFY2(ball.step(0x1p-10), ball.error());
        COMPARE_EXACT(ball.state.position.x, kImpactRadius + 0x1p-12);
        COMPARE_EXACT(ball.state.velocity.x, 0.25);
        QCOMPARE(ball.report.event_count, 1U);
    }
}

void TestImpacts::cornerTurnsBothComponentsBack() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(squareRoom(4.0), stepper, model);
    makeSmooth(ball);
    ball.params.restitution_wall = 0.75;
    // Both faces are reached after 1 s, at the same moment, in the middle of a step.
    const double vx = -0.5 - 0x1p-9;
    const double vy = -0.25 - 0x1p-9;
    ball.setPosition(kImpactRadius - vx, kImpactRadius - vy);
    ball.roll(vx, vy);
    QVERIFY2(ball.stepTimes(37, 1.0 / 32.0), ball.error());
    // model.md 12.2: v = (eps b, eps c).
    COMPARE_EXACT(ball.state.velocity.x, -0.75 * vx);
    COMPARE_EXACT(ball.state.velocity.y, -0.75 * vy);
}

void TestImpacts::topEdgeOfAWallHasTheWallsRestitution() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    bouncesOffTheWallsEnd(stepper, model, {-0.6, 0.0, 0.8}, -2.0);
}

void TestImpacts::topCornerOfAWallHasTheWallsRestitution() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    bouncesOffTheWallsEnd(stepper, model, {-2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0}, 0.0);
}

/// A ball on a floor, half a step before the edge of a roof, which it meets with its upper half: edge and floor stop it
/// in ever smaller impacts.
Experiment beforeARoofsEdge(const QByteArray &stepper, uint32_t model, double dt) {
    constexpr double kSpeed = 0.5, kNormalX = 0.8, kNormalZ = 0.6;
    const auto scene =
        SceneBuilder()
            .ball(kImpactRadius)
            .floor(-1.0, -1.0, 1.0, 1.0)
            .box({{kNormalX * kImpactRadius, -1.0, (1.0 + kNormalZ) * kImpactRadius}, {1.0, 1.0, 4.0 * kImpactRadius}})
            .start(-0.5, 0.0);
    Experiment ball(scene, stepper, model);
    ball.setPosition(-0.5 * kSpeed * dt, 0.0);
    ball.roll(kSpeed, 0.0);
    ball.params.restitution_wall = 0.25;
    ball.params.restitution_floor = 0.0;
    return ball;
}

/// Lifted off the floor it would fall, for the root of the step.
void TestImpacts::hitAtARoofsEdgeLeavesTheBallOnItsFloor() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    constexpr double dt = 0x1p-16;
    Experiment ball = beforeARoofsEdge(stepper, model, dt);
    QVERIFY2(ball.step(dt), ball.error());
    QVERIFY(ball.report.event_count > 0);
    COMPARE_WITHIN(ball.state.position.z, kImpactRadius, rounding(8, 1.0));
}

/// What the floor takes of the edge's rebound isn't left as a gap, either.
void TestImpacts::ballThatFloorAndRoofStopTouchesBoth() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    constexpr double dt = 0x1p-16;
    Experiment ball = beforeARoofsEdge(stepper, model, dt);
    QVERIFY2(ball.step(dt), ball.error());
    COMPARE_WITHIN(ball.state.position.x, 0.0, kNormalGravity * dt * dt);
}

/// The last of ever smaller bounces between the floor and a low edge, with the spin that the ball had in flight.
void TestImpacts::hopsUnderAnEdgeTakeNoSpeedAlongTheFloor() {
    QFETCH(QByteArray, stepper);
    const auto scene = SceneBuilder()
                           .ball(0.01)
                           .floor(-0.2, -0.2, 0.2, 0.2)
                           .box({{0.028416234353686756, 0.0064898354451363273, 0.015069780499342511},
                                 {0.05, 0.014329151772721156, 0.03}})
                           .start(0.12, 0.12);
    Experiment ball(scene, stepper);
    ball.params.gravity = {1.4123085035631389, -1.386725803533859, -9.6082504253675989};
    ball.params.restitution_wall = 0.0;
    ball.params.restitution_floor = 0.98;
    ball.params.rolling_friction = 0.0;
    ball.state.position = {0.042920605122102023, 0.022948741420505445, 0.010000000000530133};
    ball.state.velocity = {0.27287934849386952, -9.2007470102633077e-07, 2.6916234700637879e-07};
    ball.state.spin = {9.21009, 21.2324, 0.0};
    const double dt = 5.5e-6;
    QVERIFY2(ball.step(dt), ball.error());
    COMPARE_WITHIN(ball.state.velocity.x, 0.27287934849386952, ball.params.gravity.x * dt + 1e-5);
}

/// A sum of bounces from hardly more than the height of one step's fall, at all phases of the steps.
void TestImpacts::hopsOnTheFloorEnd() {
    QFETCH(QByteArray, stepper);
    constexpr double dt = 0x1p-10, kFirst = 6.0 * kNormalGravity * dt, kRestitution = 0.9;
    for (int i = 1; i <= 64; ++i) {
        Experiment ball(openFloor(), stepper);
        ball.params.restitution_floor = kRestitution;
        ball.state.velocity.z = kFirst / 64.0 * i;
        const double sum = 2.0 * kFirst / kNormalGravity / (1.0 - kRestitution);
        QVERIFY2(ball.stepFor(2.0 * sum, dt), ball.error());
        QCOMPARE(ball.state.velocity.z, 0.0);
        QCOMPARE(ball.state.position.z, openFloor().radius());
    }
}

void TestImpacts::bounceOnTheFloorNeedsNoGravity() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(leftWall(), stepper, model);
    makeSmooth(ball);
    ball.params.gravity = {0.0, 0.0, 0.0};
    ball.params.restitution_floor = 0.5;
    ball.state.velocity = {0.0, 0.0, -1.0};
    QVERIFY2(ball.step(1.0 / 64.0), ball.error());
    COMPARE_EXACT(ball.state.velocity.z, 0.5);
}

void TestImpacts::recedingBallIsNotPulledBack() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(leftWall(), stepper, model);
    ball.roll(0.5, -0.25);
    QVERIFY2(ball.step(1.0 / 64.0), ball.error());
    COMPARE_EXACT(ball.state.velocity.x, 0.5);
    COMPARE_EXACT(ball.state.velocity.y, -0.25);
    QCOMPARE(ball.report.event_count, 0U);
}

/// The centre is off a wall's corner by a length whose square underflows to zero.
void TestImpacts::comesOutBesideACornerFromNextToNothing() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(SceneBuilder().ball(0.0625).floor(-1, -1, 1, 1).wall(0, 0, 1, 1).start(-0.5, -0.5), stepper, model);
    ball.setPosition(-1e-200, -1e-200);
    QVERIFY2(ball.step(0.0078125), ball.error());
    const phys_vec3 &p = ball.state.position;
    COMPARE_EXACT(std::min(p.x, p.y), -0.0625);
}

void TestImpacts::grazingAnEdgeChangesNothing() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    // model.md 12.2: the edge (0.5, -R) of a box below the path from (0, 0) along x.
    const auto scene =
        SceneBuilder().ball(kImpactRadius).floor(-9, -9, 9, 9).wall(0.5, -2.0, 0.75, -kImpactRadius).start(0, 0);
    Experiment ball(scene, stepper, model);
    ball.roll(1.0, 0.0);
    // Finding the impact inside the step may find a contact within the tolerance of 4 roundings of the board's size,
    // with a normal speed of |v| sqrt(2 tol/R): model.md 5.4. Detecting overlaps at the step's end can't.
    const double grazing = promiseOf(stepper).inSteps ? 0.0 : 2.0 * std::sqrt(2.0 * rounding(8, 9.0) / kImpactRadius);
    for (int i = 0; i < 64; ++i) {
        QVERIFY2(ball.step(1.0 / 64.0), ball.error());
        COMPARE_WITHIN(ball.state.velocity.x, 1.0, grazing);
        COMPARE_WITHIN(ball.state.velocity.y, 0.0, grazing);
        COMPARE_WITHIN(ball.state.position.y, 0.0, grazing);
    }
}

void TestImpacts::seamOfFlushWallsIsNotFelt() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    auto whole = SceneBuilder().ball(kImpactRadius).floor(-9, -9, 9, 9).wall(-1, -4, 0, 4).start(kImpactRadius, -2.0);
    auto cut = SceneBuilder().ball(kImpactRadius).floor(-9, -9, 9, 9).start(kImpactRadius, -2.0);
    for (int i = -4; i < 4; ++i) cut.wall(-1, i, 0, i + 1);
    Experiment a(whole, stepper, model);
    Experiment b(cut, stepper, model);
    for (Experiment *ball : {&a, &b}) {
        ball->setLaw(-0.625, 0.0);
        ball->roll(-0.125, 1.0);
    }
    for (int i = 0; i < 256; ++i) {
        QVERIFY2(a.step(1.0 / 128.0), a.error());
        QVERIFY2(b.step(1.0 / 128.0), b.error());
        QVERIFY(sameBits(a.state, b.state));
    }
}

void TestImpacts::seamOfFlushFloorsIsNotFelt() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    auto tiles = SceneBuilder().ball(kImpactRadius).start(0.125, 0.125);
    for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) tiles.floor(0.5 * x, 0.5 * y, 0.5 * x + 0.5, 0.5 * y + 0.5);
    }
    Experiment a(SceneBuilder().ball(kImpactRadius).floor(0, 0, 4, 4).start(0.125, 0.125), stepper, model);
    Experiment b(tiles, stepper, model);
    for (Experiment *ball : {&a, &b}) ball->roll(1.0, 0.875);
    for (int i = 0; i < 256; ++i) {
        QVERIFY2(a.step(1.0 / 128.0), a.error());
        QVERIFY2(b.step(1.0 / 128.0), b.error());
        QVERIFY(sameBits(a.state, b.state));
        QVERIFY(!(b.state.flags & PHYS_AIRBORNE));
    }
}

void TestImpacts::edgeOnAParabolaDeflectsAsComputed() {
    QFETCH(QByteArray, stepper);
    // model.md 12.2, first row: R = 0.02, the edge (0.5, -0.04).
    const auto scene = SceneBuilder().ball(0.02).floor(-9, -9, 9, 9).wall(0.5, -1.0, 2.0, -0.04).start(0, 0);
    const double time = 0.4907497945889225585;
    const double vx = 0.4003426892341553206;
    const double vy = 0.85876958908727570425;
    const double after = 0.75 - time;
    for (const double dt : {0x1p-10, 0x1p-12, 0x1p-14}) {
        Experiment ball(scene, stepper);
        ball.setLaw(0.0, -1.0);
        ball.params.restitution_wall = 0.8;
        ball.roll(1.0, 0.2);
        QVERIFY2(ball.stepFor(0.75, dt), ball.error());
        // An impact noticed dt late has a normal turned by up to |v| dt/R; the bounce turns by twice that angle during
        // `after`.
        const double crude = 2.0 * 1.2 * (1.02 / 0.02) * after;
        const double slack = promiseOf(stepper).impacts == 0   ? rounding(1e6, 1.0)
                             : promiseOf(stepper).impacts == 1 ? crude * dt
                                                               : crude / 0.02 * dt * dt;
        COMPARE_WITHIN(ball.state.position.x, time + vx * after, slack);
        COMPARE_WITHIN(ball.state.position.y, 0.2 * time - time * time / 2.0 + vy * after - after * after / 2.0, slack);
    }
}

/// Not with the normal of the place, up to a step before, from which it is looked for.
void TestImpacts::edgeDeflectsAsWhereItIsMet() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    constexpr double kOffset = 0.03;
    Experiment ball(SceneBuilder().ball(kImpactRadius).floor(-1, -1, 2, 1).wall(0.5, -1, 1, 0).start(0.0, kOffset),
                    stepper, model);
    makeSmooth(ball);
    ball.params.restitution_wall = 0.5;
    ball.roll(0.5, 0.0);
    QVERIFY2(ball.stepFor(1.0, 1.0 / 40.0), ball.error());
    const double nx = -std::sqrt(1.0 - kOffset * kOffset / (kImpactRadius * kImpactRadius)),
                 ny = kOffset / kImpactRadius;
    const double impulse = -1.5 * 0.5 * nx;
    COMPARE_WITHIN(ball.state.velocity.x, 0.5 + impulse * nx, rounding(256, 1.0));
    COMPARE_WITHIN(ball.state.velocity.y, impulse * ny, rounding(256, 1.0));
}

void TestImpacts::bouncesAccumulateWhenPredicted_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("resistance");
    QTest::addColumn<double>("end");
    for (const QByteArray &id : stepperIds()) {
        if (promiseOf(id).heats) continue;
        QTest::addRow("%s, without resistance: 12 s", id.constData()) << id << 0.0 << 12.0;
        QTest::addRow("%s, with resistance: 6.415 s", id.constData()) << id << 0.1 << 6.415015353721691642938229;
    }
}

void TestImpacts::bouncesAccumulateWhenPredicted() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, resistance);
    QFETCH(double, end);
    // model.md 12.2: a_n = 0.5, v1 = 0.6, eps = 0.8.
    Experiment ball(leftWall(), stepper);
    ball.setLaw(-0.5, 0.0, resistance);
    ball.params.restitution_wall = 0.8;
    ball.roll(0.6, 0.0);
    const double dt = 0x1p-12;
    double bounces = 0.0;
    bool rests = false;
    for (int i = 0; i < 65536 && !rests; ++i) {
        QVERIFY2(ball.step(dt), ball.error());
        bounces += ball.report.event_count;
        // In contact: within the tolerance of 4 roundings of the board's size.
        const double gap = ball.state.position.x - kImpactRadius;
        rests = ball.state.velocity.x == 0.0 && std::abs(gap) <= rounding(8, 20.0);
    }
    QVERIFY(rests);
    // Each bounce happens up to dt early, and gives back the way of eps dt at most. Symplectic Euler, half a step
    // behind before and after it, loses (1 + eps) a dt/2 of its speed, which shifts the end by (1 + eps) dt/(1 - eps) =
    // 9 dt. The rest rule cuts off at most 2 * 2 eps a dt / a/(1 - eps) = 16 dt.
    const double lost = stepper == "symplectic-euler" ? 9.0 : 0.0;
    const double slack = promiseOf(stepper).impacts == 0 ? 2.0 * dt : (16.0 + (2.0 + lost) * bounces) * dt;
    COMPARE_WITHIN(ball.state.time, end, slack);
}

void TestImpacts::impactEventTellsWhatHappened() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(leftWall(), stepper, model);
    makeSmooth(ball);
    ball.params.restitution_wall = 0.75;
    ball.setPosition(kImpactRadius + 0.5, 0.25);
    ball.roll(-0.5, 0.0);
    const double dt = 1.0 / 64.0;
    phys_event event{};
    int events = 0;
    for (int i = 0; i < 128; ++i) {
        QVERIFY2(ball.step(dt), ball.error());
        for (uint32_t k = 0; k < ball.report.event_count; ++k, ++events) event = ball.report.events[k];
    }
    QCOMPARE(events, 1);
    QCOMPARE(event.kind, static_cast<uint32_t>(PHYS_EVENT_IMPACT));
    QCOMPARE(event.box, 1U);
    COMPARE_EXACT(event.normal.x, 1.0);
    COMPARE_EXACT(event.normal.y, 0.0);
    COMPARE_EXACT(event.normal.z, 0.0);
    COMPARE_EXACT(event.point.x, 0.0);
    COMPARE_EXACT(event.point.y, 0.25);
    COMPARE_EXACT(event.speed_before, -0.5);
    COMPARE_EXACT(event.speed_after, 0.375);
    // Noticed at most one step late.
    QVERIFY(event.time >= 1.0 && event.time <= 1.0 + dt);
}

void TestImpacts::sweptFindsAWallThatTheBallWouldTurnBackBehind() {
    // Uphill towards the wall, back where it was after one step: v dt + a dt^2/2 = 0. It would turn 1/512 m ahead.
    constexpr double kStep = 1.0 / 16.0;
    constexpr double kDrive = 4.0;
    constexpr double kGap = 1.0 / 1024.0;
    Experiment ball(leftWall(), "swept", PHYS_MODEL_RIGID);
    makeSmooth(ball);
    ball.params.rolling_friction = 0.0;
    ball.params.restitution_wall = 0.0;
    ball.params.gravity.x = kDrive;
    ball.setPosition(kImpactRadius + kGap, 0.0);
    ball.state.velocity.x = -0.5 * kDrive * kStep;
    phys_error error;
    QVERIFY2(!phys_step(ball.stepper(), &ball.params, kStep, &ball.state, &ball.state, nullptr, &error), error.text);
    // It stops at the wall after gap = v t - a t^2/2 and has the rest of the step to gain speed again.
    const double before = (0.125 - std::sqrt(0.125 * 0.125 - 2.0 * kDrive * kGap)) / kDrive;
    COMPARE_WITHIN(ball.state.velocity.x, kDrive * (kStep - before), rounding(8, 1.0));
}

void TestImpacts::eventsWithoutRoomAreCounted() {
    QFETCH(QByteArray, stepper);
    Experiment ball(squareRoom(4.0), stepper);
    ball.params.restitution_wall = 1.0;
    ball.setPosition(kImpactRadius + 0x1p-8, kImpactRadius + 0x1p-8);
    ball.roll(-1.0, -1.0);
    phys_event one[1];
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = one;
    report.event_capacity = 1;
    phys_error error;
    const phys_status status =
        phys_step(ball.stepper(), &ball.params, 1.0 / 64.0, &ball.state, &ball.state, &report, &error);
    QVERIFY2(status == PHYS_OK, error.text);
    QCOMPARE(report.event_count, 1U);
    QCOMPARE(report.events_lost, 1U);
}

/// The wall is an L of two flush boxes, which can't be merged. The ball falls on its straight edge 1 mm before the
/// joint: what friction leaves of the speed along the edge is 5/7, as on an edge without a joint.
void TestImpacts::jointOfAStraightEdgeKicksNoBall() {
    QFETCH(QByteArray, stepper);
    const double fall = std::sqrt(2.0 * (0.05 - std::sqrt(0.006 * 0.006 - 0.004 * 0.004)) / 9.81);
    const SceneBuilder angle = SceneBuilder()
                                   .ball(0.006)
                                   .box({{0.0, 0.0, 0.0}, {0.1, 0.01, 0.02}})
                                   .box({{0.1, -0.3, 0.0}, {0.15, 0.01, 0.02}})
                                   .start({0.099 - 0.5 * fall, 0.014, 0.07});
    Experiment ball(angle, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {0.0, 0.0, -9.81};
    ball.params.wall_friction = 0.3;
    ball.state.velocity.x = 0.5;
    QVERIFY2(ball.stepTimes(150, 0.001), ball.error());
    COMPARE_WITHIN(ball.state.velocity.x, 5.0 / 7.0 * 0.5, 1e-9);
}

/// It moves along the roof's edge, which takes part in the landing only from the second round on, 13.2.
void TestImpacts::floorThrowsTheBallAgainstARoofThatItTouches() {
    QFETCH(QByteArray, stepper);
    const SceneBuilder scene = SceneBuilder()
                                   .ball(0.01)
                                   .box({{-0.05, -0.06, -0.07}, {0.06, 0.04, -0.01}})
                                   .box({{-0.04, -0.06, 0.0071257166925936038}, {0.05, -0.007015993273720612, 0.04}})
                                   .start({0.0, 0.0, 0.0});
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {-4.4249556546483291, -1.637155496214179, -8.6009063089660192};
    ball.params.sliding_friction = 0.89412145340126925;
    ball.params.wall_friction = ball.params.rolling_friction = 0.0;
    ball.params.restitution_floor = 0.53987902731035398;
    ball.params.restitution_wall = 0.39634735786429343;
    ball.state.position = {0.0, 0.0, 0.0};
    ball.state.velocity = {-1.1240410841161788, -0.16860819357586873, -0.16601192596557032};
    QVERIFY2(ball.step(1e-9), ball.error());
    COMPARE_WITHIN(ball.state.velocity.x, -0.80879, 1e-5);
    COMPARE_WITHIN(ball.state.velocity.y, 0.02319, 1e-5);
    COMPARE_WITHIN(ball.state.velocity.z, 0.00527, 1e-5);
}

QTEST_GUILESS_MAIN(TestImpacts)
#include "tst_impacts.moc"
