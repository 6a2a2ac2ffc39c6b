// SPDX-License-Identifier: MIT
// The rows of model.md 11 for the exact stepper.
#include "run.h"

#include <QtTest>

#include <limits>

using exact::kFloor;
using exact::kU;
using exact::Run;

class ExactExtremes : public QObject {
    Q_OBJECT
private slots:
    void elasticBouncesKeepTheEnergy();
    void noRestitutionSlidesOn();
    void hugeResistanceStopsAtOnce();
    void tiniestSpeeds_data();
    void tiniestSpeeds();
    void stopsARoundingBeforeItTurnsRound_data();
    void stopsARoundingBeforeItTurnsRound();
    void oneLongStepIsAThousandShortOnes();
    void ballWiderThanAGapRestsOnTwoEdges();
    void stopsUnderAShelfThatIsHardlyTooLow_data();
    void stopsUnderAShelfThatIsHardlyTooLow();
    void isWedgedUnderAShelfThatIsHardlyTooLow_data() { stopsUnderAShelfThatIsHardlyTooLow_data(); }
    void isWedgedUnderAShelfThatIsHardlyTooLow();
    void gapOfExactlyTheDiameterDoesNotHang();
    void slipsInAShaftOfExactlyTheDiameter();
    void refusesMoreBouncesThanAreWorthWaitingFor();
    void isStuckAmongManyWallsCloserThanItself();
    void fastBallBouncesInACorridor();
    void thinWallIsSeenAtAnySpeed();
    void millionMetresAway();
    void carriedByAnEdgeFarAwayItHitsAnother();
    void flushTilesAreOnePlane();
    void thousandTouchingBoxes();
    void meetsThePostAtTheEndOfALongFlight();
    void restIsForEver();
    void fallsPastTheLowerEndOfAWall();
    void hardlyAnyGravityPressesOnAWall();
    void gravityOfNoFullPrecisionPressesOnAWall();
    void restsOnAWallsTopAgainstAnother();
    void bouncesOnALevelEdgeEndHoweverFastItGoesAlong();
    void meetsALevelEdgeHoweverFastItGoesAlong();
    void restsOnACorner();
    void risesBesideAnEdgeItRestsOn();
    void inTheFloorAndPulledUpItFlies();
    void leastTimeMovesNothing();
    void restsWithoutGravity();
    void rollsWithoutGravity();
    void spinsInTheAirWithoutGravity();
    void reachesAFloorThatDoesNotPress_data();
    void reachesAFloorThatDoesNotPress();
};

void ExactExtremes::elasticBouncesKeepTheEnergy() {
    Run run({kFloor, exact::wall(-1, -1, -0.5, 1), exact::wall(0.5, -1, 1, 1)}, 0.125, {0, 0, 0.125}, {1, 0.0, 0});
    run.params.restitution_wall = 1.0;
    run.step(750.0); // 1000 bounces, 0.75 m apart
    QCOMPARE(std::abs(run.state.velocity.x), 1.0);
}

void ExactExtremes::noRestitutionSlidesOn() {
    Run run({kFloor, exact::wall(-1, -1, 1, 0)}, 0.125, {0, 0.5, 0.125}, {0.25, -1, 0});
    run.params.restitution_wall = 0.0;
    run.step(2.0);
    QVERIFY(exact::difference(run.state, 0.5, 0.125, 0.25, 0.0) <= kU);
    QCOMPARE(run.eventsOf(PHYS_EVENT_IMPACT).size(), size_t(1));
}

void ExactExtremes::hugeResistanceStopsAtOnce() {
    Run run({kFloor}, 0.125, {0, 0, 0.125}, {1, 0, 0});
    run.setLaw(0.0, 0.0, 4e6);
    run.step(1.0);
    QVERIFY(std::abs(run.state.position.x - 1.25e-7) <= 1e-22); // v^2/(2 B)
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

void ExactExtremes::tiniestSpeeds_data() {
    QTest::addColumn<double>("A");
    QTest::addColumn<double>("B");
    for (const double A : {0.0, 0.5}) {
        for (const double B : {0.0, 0.25, 0.5, 1.0}) {
            QTest::addRow("A %g, B %g", A, B) << A << B;
        }
    }
}

void ExactExtremes::tiniestSpeeds() {
    QFETCH(double, A);
    QFETCH(double, B);
    for (const double speed : {1e-300, 1e-200, 1e-100}) {
        Run run({kFloor}, 0.125, {0, 0, 0.125}, {0.6 * speed, 0.8 * speed, 0});
        run.setLaw(A, 0.0, B, 8.0);
        run.step(1.0);
        const double fromRest = std::max(0.0, A - B);
        QVERIFY(std::abs(run.state.velocity.x - fromRest) <= 2.0 * kU);
        QVERIFY(std::abs(run.state.position.x - 0.5 * fromRest) <= 2.0 * kU);
        QVERIFY(std::abs(run.state.velocity.y) <= speed);
    }
}

void ExactExtremes::stopsARoundingBeforeItTurnsRound_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    for (const double x : {1.0, 0.3, 0x1p-40, -0.7}) {
        for (const double y : {0.0, 1.0, -0.1, 0.7 / 3.0}) QTest::addRow("(%g, %g)", x, y) << x << y;
    }
}

/// Straight against a pull that exceeds the resistance: the law's variable is infinite at the stop, model.md 3.2.
void ExactExtremes::stopsARoundingBeforeItTurnsRound() {
    QFETCH(double, x);
    QFETCH(double, y);
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        for (int i = -16; i <= 16; ++i) {
            constexpr double kB = 0.125, kSpeed = 1.0 / 3.0;
            const phys_vec3 velocity{-kSpeed * x, -kSpeed * y, 0};
            Run run({kFloor}, 0.125, {0, 0, 0.125}, velocity);
            run.params.model = model;
            run.setLaw(3.0 * x, 3.0 * y, kB * std::hypot(x, y));
            run.state.spin = {-velocity.y / 0.125, velocity.x / 0.125, 0};
            run.step((1.0 - 0.5 * kU * i) * kSpeed / (3.0 + kB));
            QVERIFY(std::hypot(run.state.velocity.x, run.state.velocity.y) <= 32.0 * kU * kSpeed * std::hypot(x, y));
        }
    }
}

void ExactExtremes::oneLongStepIsAThousandShortOnes() {
    const auto ball = [] { return Run({kFloor, exact::wall(0.5, -1, 1, 1)}, 0.125, {0, 0, 0.125}, {1, 0.25, 0}); };
    Run once = ball(), often = ball();
    for (Run *run : {&once, &often}) run->setLaw(0.25, -0.125, 0.0625);
    once.step(1.0);
    for (int i = 0; i < 1000; ++i) often.step(1.0 / 1000.0);
    // Each phase that is begun anew in a step costs one rounding.
    const phys_state &s = once.state;
    QVERIFY(exact::difference(often.state, s.position.x, s.position.y, s.velocity.x, s.velocity.y) <= 200.0 * kU);
}

void ExactExtremes::ballWiderThanAGapRestsOnTwoEdges() {
    // A gap of 0.15 between two walls: the ball of radius 0.125 lies on both edges, 0.1 above them.
    Run run({kFloor, exact::wall(-1, -1, -0.075, 0), exact::wall(0.075, -1, 1, 0)}, 0.125, {0, 0.5, 0.125});
    run.setLaw(0.0, -1.0, 0.0);
    run.params.restitution_wall = 0.0;
    run.step(60.0);
    // At rest when both edges are touched: within the tolerance of 4 rounding steps of the walls' height, 16.
    QVERIFY(exact::difference(run.state, 0.0, 0.1, 0.0, 0.0) <= 2.0 * 4.0 * kU * 16.0);
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

void ExactExtremes::stopsUnderAShelfThatIsHardlyTooLow_data() {
    QTest::addColumn<double>("lack");
    QTest::addColumn<double>("pull");
    for (int digits = 4; digits <= 13; ++digits) {
        for (const double pull : {0.0998, 1.0, 9.0}) {
            QTest::addRow("1e-%d radii, %g m/s^2", digits, pull) << std::pow(10.0, -digits) << pull;
        }
    }
}

void ExactExtremes::stopsUnderAShelfThatIsHardlyTooLow() {
    QFETCH(double, lack);
    QFETCH(double, pull);
    const phys_box shelf{{2, -12, 2 - lack}, {5, 12, 4}};
    Run run({exact::floorOver(-12, -12, 12, 12), shelf}, 1.0, {0.3, 0, 1}, {0.3, 0.13, 0});
    run.state.spin = {-0.13, 0.3, 0.0};
    run.params.gravity = {pull, 0.0, -1.0};
    run.params.restitution_wall = 0.25;
    for (int i = 0; i < 60; ++i) {
        run.step(0.5);
        QVERIFY(std::abs(run.report.energy_scheme) <= 64.0 * exact::kU * (1.0 + pull));
    }
    // The mouth is where the edge touches; rolling on along it, the spin follows the velocity: model.md 2.1 R7.
    const double low = 2.0 - shelf.min.z;
    const double mouth = 2.0 - std::sqrt(low * (2.0 - low));
    QVERIFY(std::abs(run.state.position.x - mouth) <= 4.0 * exact::kU / std::sqrt(low));
    QCOMPARE(run.state.velocity.x, 0.0);
    QCOMPARE(run.state.spin.y, 0.0);
    QCOMPARE(run.state.spin.x, -run.state.velocity.y);
}

/// With friction that exceeds the tangent of half the wedge's angle: the ball jams where the edge touches.
void ExactExtremes::isWedgedUnderAShelfThatIsHardlyTooLow() {
    QFETCH(double, lack);
    QFETCH(double, pull);
    const phys_box shelf{{2, -12, 2 - lack}, {5, 12, 4}};
    Run run({exact::floorOver(-12, -12, 12, 12), shelf}, 1.0, {0.3, 0, 1}, {0.3, 0.13, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.state.spin = {-0.13, 0.3, 0.0};
    run.params.gravity = {pull, 0.0, -1.0};
    run.params.sliding_friction = 0.3;
    run.params.wall_friction = 0.2;
    for (int i = 0; i < 60; ++i) run.step(0.5);
    const double low = 2.0 - shelf.min.z;
    const double mouth = 2.0 - std::sqrt(low * (2.0 - low));
    QVERIFY(std::abs(run.state.position.x - mouth) <= 4.0 * exact::kU / std::sqrt(low));
    QVERIFY(std::abs(run.state.velocity.x) <= 64.0 * exact::kU * (1.0 + pull));
}

void ExactExtremes::gapOfExactlyTheDiameterDoesNotHang() {
    Run run({kFloor, exact::wall(-1, -1, -0.125, 0), exact::wall(0.125, -1, 1, 0)}, 0.125, {0, 0.5, 0.125});
    run.setLaw(0.0, -1.0, 0.0);
    const phys_status status = run.tryStep(5.0);
    QVERIFY(status == PHYS_OK || status == PHYS_ERROR_EVENT_CAP || status == PHYS_ERROR_STUCK);
    QVERIFY(std::isfinite(run.state.position.x) && std::isfinite(run.state.position.y));
}

void ExactExtremes::slipsInAShaftOfExactlyTheDiameter() {
    // Pressed against one of two walls and against the floor under a roof: the opposite faces aren't hit again and
    // again.
    Run run({kFloor, exact::wall(-1, -1, -0.125, 1), exact::wall(0.125, -1, 1, 1), {{-1, -1, 0.25}, {1, 1, 0.5}}},
            0.125, {0, 0, 0.125});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.wall_friction = 0.125;
    run.params.sliding_friction = 0.5;
    run.params.gravity = {0.0625, -0.25, -9.75};
    run.state.spin = {8, -8, -1};
    run.step(0.125);
    QCOMPARE(run.state.position.x, 0.0);
    QCOMPARE(run.state.position.z, 0.125);
    QVERIFY(run.state.velocity.y < 0.0);
    QCOMPARE(run.eventsOf(PHYS_EVENT_IMPACT).size(), size_t(0));
}

void ExactExtremes::refusesMoreBouncesThanAreWorthWaitingFor() {
    Run run({kFloor, exact::wall(-1, -1, -0.05, 1), exact::wall(0.05, -1, 1, 1)}, 0.005, {0, 0, 0.005}, {1e6, 0, 0});
    run.params.restitution_wall = 1.0;
    QCOMPARE(run.tryStep(1.0), PHYS_ERROR_EVENT_CAP); // after 11 million bounces
    QCOMPARE(run.state.position.x, 0.0);
}

void ExactExtremes::isStuckAmongManyWallsCloserThanItself() {
    std::vector<phys_box> spiral{kFloor};
    const double thick = 1e-4;
    for (int i = 0; i < 50; ++i) {
        const double s = 4e-4 * (i + 1);
        spiral.push_back(exact::wall(-s, -s, s, -s + thick));
        spiral.push_back(exact::wall(s, -s, s + thick, s));
        spiral.push_back(exact::wall(-s, s, s, s + thick));
        spiral.push_back(exact::wall(-s - thick, -s, -s, s));
    }
    Run run(spiral, 0.006, {0, 0, 0.006}, {0.1, 0.05, 0});
    QCOMPARE(run.tryStep(0.1), PHYS_ERROR_STUCK);
}

void ExactExtremes::fastBallBouncesInACorridor() {
    Run run({kFloor, exact::wall(-1, -1, -0.05, 1), exact::wall(0.05, -1, 1, 1)}, 0.005, {0, 0, 0.005}, {1e6, 0, 0});
    run.params.restitution_wall = 1.0;
    run.step(0.001);
    QVERIFY(std::abs(run.state.position.x) <= 0.045 + kU);
    QCOMPARE(run.report.event_count + run.report.events_lost, uint32_t(11111)); // 1000 m in stretches of 0.09 m
    QCOMPARE(std::abs(run.state.velocity.x), 1e6);
}

void ExactExtremes::thinWallIsSeenAtAnySpeed() {
    Run run({kFloor, exact::wall(1, -1, 1 + 1e-9, 1)}, 0.005, {0, 0, 0.005}, {1e6, 0, 0});
    run.params.restitution_wall = 1.0;
    run.step(1.5e-6);
    QVERIFY(run.state.velocity.x == -1e6 && run.state.position.x < 1.0);
}

void ExactExtremes::millionMetresAway() {
    const double far = 1e6;
    Run run({exact::floorOver(far - 2, far - 2, far + 2, far + 2), exact::wall(far + 1, far - 1, far + 2, far + 1)},
            0.125, {far, far, 0.125}, {1, 0, 0});
    run.params.restitution_wall = 0.5;
    run.step(2.0);
    // 0.875 m there in 0.875 s, then 1.125 s back at half the speed; a rounding step is 1.2e-10 m here.
    QVERIFY(std::abs(run.state.position.x - (far + 0.875 - 0.5625)) <= 2.0 * 1.2e-10);
    QCOMPARE(run.state.velocity.x, -0.5);
}

void ExactExtremes::carriedByAnEdgeFarAwayItHitsAnother() {
    // The edge that carries the ball has no part in the first round of its impact on another one's, whatever rounding
    // of its place does to the normal.
    const auto speedAfter = [](double far) {
        Run run({{{far - 0.16, -0.16, -0.008}, {far + 0.16, 0.16, 0}},
                 {{far + 0.006088379363063723, -0.16, 0.012708089139778167}, {far + 0.16, 0.16, 0.036}},
                 {{far - 0.16, -0.16, 0}, {far - 0.007525316483224742, 0.16, 0.0057137460680678487}}},
                0.0078125, {far - 0.0062764677131781355, 0, 0.013671875},
                {0.023861540382553635, 0.016629343722621013, 0});
        run.state.spin = {-2.6538188786087278, 0, -2.4001981771637246};
        run.params.model = PHYS_MODEL_RIGID;
        run.params.restitution_floor = run.params.restitution_wall = 0.0;
        run.params.sliding_friction = 0.7;
        run.params.wall_friction = 0.40349674882495817;
        run.params.gravity = {0, 6.6948956294370099, -7.1703885885595655};
        run.step(0.082);
        return run.state.velocity.y;
    };
    QVERIFY(std::abs(speedAfter(256.0) - speedAfter(0.0)) <= 1e-6);
}

void ExactExtremes::flushTilesAreOnePlane() {
    // A wall of tiles of uneven depth that are flush in front: the ball slides and bounces without a kick at any joint.
    std::vector<phys_box> boxes{kFloor};
    for (int i = -16; i < 16; ++i) boxes.push_back(exact::wall(i / 16.0, -0.5 - (i & 1) * 0.125, (i + 1) / 16.0, 0.0));
    Run slide(boxes, 0.0625, {-0.9375, 0.0625, 0.0625}, {0.5, 0, 0});
    slide.setLaw(0.0, -1.0, 0.0);
    slide.step(3.0);
    QVERIFY(exact::difference(slide.state, 0.5625, 0.0625, 0.5, 0.0) <= kU);
    QVERIFY(slide.events.empty());
    Run bounce(boxes, 0.0625, {-0.9375, 0.5625, 0.0625}, {0.5, 0, 0});
    bounce.setLaw(0.0, -1.0, 0.0);
    bounce.params.restitution_wall = 1.0;
    bounce.step(3.0);
    QVERIFY(std::abs(bounce.state.position.x - 0.5625) <= kU);
    QCOMPARE(bounce.state.velocity.x, 0.5);
}

void ExactExtremes::thousandTouchingBoxes() {
    std::vector<phys_box> boxes{kFloor};
    for (int i = 0; i < 1000; ++i) boxes.push_back(exact::wall(-1.0 + i * 1e-3, -1, 1, -i * 0x1p-20));
    Run run(boxes, 0.125, {0, 0.5, 0.125}, {0.125, -1, 0});
    run.params.restitution_wall = 0.5;
    run.step(4.0);
    QVERIFY(run.state.velocity.y > 0.0);
}

void ExactExtremes::meetsThePostAtTheEndOfALongFlight() {
    // Over 40,000 posts, of which it comes near only some hundreds: in one step, and in steps shorter than the ball.
    std::vector<phys_box> posts;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 200; ++j) posts.push_back({{1.0 * i, 1.0 * j, -1.0}, {i + 0.5, j + 0.5, 0.0}});
    }
    Run once(posts, 0.125, {0.25, 0.25, 8.0}, {128, 128, 0}), often(posts, 0.125, {0.25, 0.25, 8.0}, {128, 128, 0});
    for (Run *run : {&once, &often}) run->params.gravity = {0, 0, -6.5625}; // a fall of 1.55 s
    once.step(2.0);
    QCOMPARE(once.eventsOf(PHYS_EVENT_IMPACT).size(), size_t(1));
    while (often.events.empty()) often.step(1.0 / 2048.0);
    QVERIFY(std::abs(once.events[0].time - often.events[0].time) <= 1e-12);
}

void ExactExtremes::restIsForEver() {
    Run run({kFloor, exact::wall(-1, -1, 0, 1), exact::wall(-1, -1, 1, 0)}, 0.125, {0.125, 0.125, 0.125});
    run.setLaw(-1.0, -0.5, 0.0);
    run.step(1.0);
    const phys_state first = run.state;
    for (int i = 0; i < 10000; ++i) run.step(0.01);
    QVERIFY(run.state.position.x == first.position.x && run.state.position.y == first.position.y);
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

/// Pulled against the wall it falls along it, and freely as soon as its centre is below it: x = 1/2 a t^2 from there.
void ExactExtremes::fallsPastTheLowerEndOfAWall() {
    Run run({exact::floorOver(-2, -2, -1, 2), exact::wall(0.5, -1, 1, 1)}, 0.125, {0.375, 0, 1});
    run.params.gravity = {0.5, 0, -8}; // down to the wall's end in half a second
    run.step(0.75);
    QVERIFY(std::abs(run.state.position.x - (0.375 + 0.25 * 0.0625)) <= 2.0 * kU);
    QVERIFY(std::abs(run.state.velocity.x - 0.125) <= 2.0 * kU);
    QVERIFY(std::abs(run.state.position.z - (1.0 - 4.0 * 0.5625)) <= 2.0 * kU);
    QCOMPARE(run.eventsOf(PHYS_EVENT_RELEASE).size(), size_t(1));
}

/// So little that its units would overflow: the ball flies on beside the rough wall as if the wall weren't there.
void ExactExtremes::hardlyAnyGravityPressesOnAWall() {
    Run run({exact::floorOver(-2, -2, -1, 2), exact::wall(-1, -1, 8, 0)}, 0.125, {0, 0.125, 2}, {4, 0, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.gravity = {0, -std::numeric_limits<double>::min(), 0};
    run.params.wall_friction = 4.0;
    run.step(0.5);
    QCOMPARE(run.state.position.x, 2.0);
    QCOMPARE(run.state.velocity.x, 4.0);
}

/// A subnormal number whose products with lengths are zero: the search for walls still terminates.
void ExactExtremes::gravityOfNoFullPrecisionPressesOnAWall() {
    Run run({exact::floorOver(-2, -2, -1, 2), exact::wall(-1, -1, 8, 0)}, 0.125, {8, 0.125, 2}, {4, 0, 0});
    run.params.gravity = {0, -8e-317, 0};
    run.step(0.5); // off the end of the face
    QCOMPARE(run.state.position.x, 10.0);
    QCOMPARE(run.state.position.y, 0.125);
}

/// Two walls of different heights: the lower one's top carries the ball and hence is floor.
void ExactExtremes::restsOnAWallsTopAgainstAnother() {
    const std::vector<phys_box> boxes{
        exact::floorOver(-2, -2, -1, 2), {{-0.5, -1, 0}, {0.5, 1, 0.5}}, exact::wall(0.125, -1, 1, 1)};
    Run run(boxes, 0.125, {0, 0, 0.625});
    run.params.gravity = {2, 0, -8};
    run.step(1.0);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AT_REST));
    QCOMPARE(run.state.position.x, 0.0);
    QCOMPARE(run.state.position.z, 0.625);
}

/// Pulled from below straight into the edge at x = 0.5, z = 1. An edge is curved only across itself.
void ExactExtremes::bouncesOnALevelEdgeEndHoweverFastItGoesAlong() {
    Run run({exact::floorOver(-2, -2, -1, 2), {{0.5, -128, 1}, {1, 128, 2}}}, 0.125, {0.25, 0, 0.75}, {0, 64, 0});
    run.params.gravity = {8, 0, 8};
    run.params.restitution_wall = 0.5;
    run.step(1.5);
    QCOMPARE(run.state.velocity.y, 64.0);
    // It balances there: in the last second, rounding errors grow by exp(t sqrt(a/R)), some 1e5.
    QVERIFY(std::hypot(run.state.velocity.x, run.state.velocity.z) <= 1e-9);
    QVERIFY(std::abs(std::hypot(run.state.position.x - 0.5, run.state.position.z - 1.0) - 0.125) <= 2.0 * kU);
}

/// 1e-8 m/s towards the edge isn't a graze at 8 m/s along it.
void ExactExtremes::meetsALevelEdgeHoweverFastItGoesAlong() {
    const double gap = 1e-9, speed = 1e-8;
    Run run({{{-1, -8, -1}, {0, 8, 0}}}, 0.125, {0.6 * (0.125 + gap), -4, 0.8 * (0.125 + gap)},
            {-0.6 * speed, 8, -0.8 * speed});
    run.params.gravity = {0, 0, 0};
    run.params.restitution_wall = 1.0;
    run.step(0.5); // meets it after 0.1 s
    QCOMPARE(run.eventsOf(PHYS_EVENT_IMPACT).size(), size_t(1));
    QVERIFY(std::abs(0.6 * run.state.velocity.x + 0.8 * run.state.velocity.z - speed) <= 1e-12 * speed);
}

/// Straight onto a corner, bounce after bounce: the last one consists of rounding only.
void ExactExtremes::restsOnACorner() {
    Run run({{{1, 1, 1}, {2, 2, 2}}}, 0.125, {0, 0, 0}, {1, 1, 1});
    run.params.gravity = {1, 1, 1};
    run.params.restitution_wall = 0.25;
    run.step(10.0);
    QCOMPARE(run.state.velocity.x, 0.0);
    QCOMPARE(run.state.velocity.y, 0.0);
    QCOMPARE(run.state.velocity.z, 0.0);
    QVERIFY(std::abs(std::sqrt(3.0) * (1.0 - run.state.position.x) - 0.125) <= 4.0 * kU);
}

/// At an edge, with no horizontal component of gravity that could turn the ball round the edge.
void ExactExtremes::risesBesideAnEdgeItRestsOn() {
    Run run({exact::wall(0, 0, 1, 1)}, 0.125, {-0.075, -0.1, 1});
    run.params.gravity = {0, 0, 2};
    run.step(0.5);
    QCOMPARE(run.state.position.z, 1.25);
    QCOMPARE(run.state.position.x, -0.075);
}

void ExactExtremes::inTheFloorAndPulledUpItFlies() {
    Run run({kFloor}, 0.125, {0, 0, 0.0625}, {1, 0, 0});
    run.params.gravity = {0, 0, 2};
    run.params.rolling_friction = 0.5;
    run.step(0.5);
    QCOMPARE(run.state.position.z, 0.375); // pushed out of the floor first
    QCOMPARE(run.state.velocity.x, 1.0);
}

void ExactExtremes::leastTimeMovesNothing() {
    Run run({kFloor, exact::wall(0.125, -1, 1, 1)}, 0.125, {0, 0, 0.125}, {1, 0.5, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.wall_friction = 0.5;
    run.step(std::numeric_limits<double>::denorm_min());
    QCOMPARE(run.state.position.y, 0.0);
}

/// In the air, and on top of a box, which carries it with pressure 0.
void ExactExtremes::restsWithoutGravity() {
    const phys_box deck{{-1, -1, 0.5}, {1, 1, 0.75}};
    for (const bool isCarried : {false, true}) {
        Run run({kFloor, deck}, 0.125, {0, 0, isCarried ? 0.875 : 1.5});
        run.params.gravity = {0, 0, 0};
        run.step(0.5);
        QCOMPARE(run.state.flags, uint64_t(isCarried ? PHYS_AT_REST : PHYS_AT_REST | PHYS_AIRBORNE));
    }
}

/// Even in no time: what a top face carries rolls.
void ExactExtremes::rollsWithoutGravity() {
    Run run({kFloor, {{-1, -1, 0.5}, {1, 1, 0.75}}}, 0.125, {0, 0, 0.875}, {0.5, 0, 0});
    run.params.gravity = {0, 0, 0};
    run.step(std::numeric_limits<double>::denorm_min());
    QCOMPARE(run.state.flags, uint64_t(0));
    QCOMPARE(run.state.spin.y, 4.0);
}

/// model.md 2.1 R7: in flight the spin stays as it was, also without a velocity.
void ExactExtremes::spinsInTheAirWithoutGravity() {
    Run run({kFloor}, 0.125, {0, 0, 1.5});
    run.params.gravity = {0, 0, 0};
    run.state.spin = {2, -6, -3};
    run.step(0.5);
    QVERIFY(exact::equal(run.state.spin, {2, -6, -3}));
    QCOMPARE(run.report.lost_slip, 0.0);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AIRBORNE));
}

void ExactExtremes::reachesAFloorThatDoesNotPress_data() {
    QTest::addColumn<double>("start");  // m: before the trench
    QTest::addColumn<double>("drive");  // m/s^2: across the trench
    QTest::addColumn<double>("before"); // s: on the floor, over the trench, on the floor
    QTest::addColumn<double>("above");
    QTest::addColumn<double>("after");
    QTest::newRow("the one beyond") << 0.01 << 0.0 << 0.1 << 0.3 << 0.6;
    QTest::newRow("the one that it left") << 0.0096 << -0.7 << 0.16 << 2.0 / 35.0 << 0.2;
}

/// model.md 8.2: without pressure it gets there without any speed towards it, and goes on with 5/7 of the drive.
void ExactExtremes::reachesAFloorThatDoesNotPress() {
    QFETCH(double, start);
    QFETCH(double, drive);
    QFETCH(double, before);
    QFETCH(double, above);
    QFETCH(double, after);
    const double rolled = before + after, speed = 5.0 / 7.0 * rolled + above, time = rolled + above;
    const double early = 0.5 * (5.0 / 7.0) * before * before, over = (5.0 / 7.0 * before + 0.5 * above) * above;
    const double late = (speed - 0.5 * (5.0 / 7.0) * after) * after;
    for (const int steps : {1, 3, 1000}) {
        Run run({{{-1, -1, 0.25}, {0, 1, 0.5}}, {{0.03, -1, 0.25}, {1, 1, 0.5}}}, 0.01, {-start, 0, 0.51}, {0.1, 0, 0});
        run.params.gravity = {drive, 1, 0};
        for (int i = 0; i < steps; ++i) run.step(time / steps);
        QVERIFY(std::abs(run.state.position.y - (early + over + late)) <= 1e-13);
        QVERIFY(std::abs(run.state.velocity.y - speed) <= 1e-13);
        QCOMPARE(run.state.flags, uint64_t(0));
    }
}

QTEST_GUILESS_MAIN(ExactExtremes)
#include "tst_exact_extremes.moc"
