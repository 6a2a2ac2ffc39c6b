// SPDX-License-Identifier: MIT
// Impacts, lasting contacts, edges, accumulating bounces: model.md 5, 6 and 12.2.
#include "run.h"

#include <QtTest>

using exact::kFloor;
using exact::kU;
using exact::Run;

class ExactContacts : public QObject {
    Q_OBJECT
private slots:
    void bouncesKeepTheirTimesToTheLast();
    void elasticBouncesBelowSightDontCountUp_data();
    void elasticBouncesBelowSightDontCountUp();
    void bouncesThatHardlyDecayKeepTheirTimes();
    void bouncesEndWhenTheirSumDoes_data();
    void bouncesEndWhenTheirSumDoes();
    void bouncesOfAFastBallDontBeginAnew_data();
    void bouncesOfAFastBallDontBeginAnew();
    void edgeIsHitByAParabola();
    void grazingChangesNothing();
    void cornerReversesBothComponents();
    void bouncesAccumulateInFiniteTime();
    void bouncesAgainstResistanceAccumulate();
    void ballPivotsOnAnEdgeAndLeavesIt();
    void ballLeavesTheFloorFallsAndIsOut();
    void fallOnALowerFloorIsNone();
    void ballInAWallIsPushedOut();
    void ballBetweenTwoWallsTooCloseIsStuck();
    void startsBackAlongAKerbAgainstResistance_data();
    void startsBackAlongAKerbAgainstResistance();
    void aFloorThatOpensAtOnceTurnsNoBall();
    void aRoofWithoutPressureChangesNoSlip();
    void aWallToWhichTheBallWouldReturnIsntLeft_data();
    void aWallToWhichTheBallWouldReturnIsntLeft();
    void sticksAtTwoCornersOfWhichOneHardlyPresses();
    void aHeldBallWhoseSlipStartsTurnsOn_data();
    void aHeldBallWhoseSlipStartsTurnsOn();
    void hopsBelowTheToleranceDontDependOnTheStep();
    void whatPressesNothingBrakesNothing_data();
    void whatPressesNothingBrakesNothing();
    void aFloorWithoutPressureHoldsNoBall();
};

void ExactContacts::edgeIsHitByAParabola() {
    Run run({kFloor, exact::wall(0.5, -1, 1.5, -0.04)}, 0.02, {0, 0, 0.02}, {1, 0.2, 0});
    run.setLaw(0.0, -1.0, 0.0);
    run.params.restitution_wall = 0.8;
    run.step(0.49074979458892256); // the impact is exactly at this time or one rounding step before
    std::vector<phys_event> hits = run.eventsOf(PHYS_EVENT_IMPACT);
    run.step(1e-3);
    if (hits.empty()) hits = run.eventsOf(PHYS_EVENT_IMPACT);
    QCOMPARE(hits.size(), size_t(1));
    // The normal turns with the ball's position by 1/R.
    QVERIFY(std::abs(hits[0].normal.x + 0.46251027055387207512) <= 4.0 * kU / 0.02);
    QVERIFY(std::abs(hits[0].normal.y - 0.88661392366248346307) <= 4.0 * kU / 0.02);
    QVERIFY(std::abs(hits[0].speed_before + 0.72029308673841780786) <= 4.0 * kU / 0.02);
    const double t = 0.4907497945889225585, rest = 0.49074979458892256 + 1e-3 - t;
    const double vx = 0.4003426892341553206, vy = 0.85876958908727570425;
    const double x = t, y = 0.2 * t - 0.5 * t * t;
    QVERIFY(exact::difference(run.state, x + vx * rest, y + vy * rest - 0.5 * rest * rest, vx, vy - rest) <= 16.0 * kU);
}

void ExactContacts::grazingChangesNothing() {
    Run run({kFloor, exact::wall(0.5, -1, 0.5, -0.0625)}, 0.0625, {0, 0, 0.0625}, {1, 0, 0});
    run.step(1.0);
    QVERIFY(exact::difference(run.state, 1.0, 0.0, 1.0, 0.0) <= kU);
}

void ExactContacts::cornerReversesBothComponents() {
    Run run({kFloor, exact::wall(-1, -1, 0, 1), exact::wall(-1, -1, 1, 0)}, 0.125, {0.375, 0.375, 0.125},
            {-1.0, -1.0, 0});
    run.params.restitution_wall = 0.5;
    run.step(0.5);
    QCOMPARE(run.state.velocity.x, 0.5);
    QCOMPARE(run.state.velocity.y, 0.5);
    QCOMPARE(run.state.position.x, 0.25);
    QCOMPARE(run.state.position.y, 0.25);
}

void ExactContacts::bouncesAccumulateInFiniteTime() {
    // model.md 6.4: T_z = (2 v1/a_n)/(1 - eps) = 12.
    Run run({kFloor, exact::wall(-1, -1, 1, 0)}, 0.01, {0, 0.01, 0.01}, {0, 0.6, 0});
    run.setLaw(0.0, -0.5, 0.0);
    run.params.restitution_wall = 0.8;
    run.step(13.0);
    QCOMPARE(run.state.position.y, 0.01);
    QCOMPARE(run.state.velocity.y, 0.0);
    // The last bounce that is left out is lower than rounding, so its speed is below sqrt(2 a_n 2 tolerance).
    const double cut = std::sqrt(2.0 * 0.5 * 2.0 * 4.0 * kU * 16.0);
    QVERIFY(std::abs(run.events.back().time - 12.0) <= 2.0 * cut / 0.5 / 0.2);
    QVERIFY(std::abs(run.report.energy_scheme) <= 8.0 * kU);
}

void ExactContacts::bouncesAgainstResistanceAccumulate() {
    Run run({kFloor, exact::wall(-1, -1, 1, 0)}, 0.01, {0, 0.01, 0.01}, {0, 0.6, 0});
    run.setLaw(0.0, -0.5, 0.1);
    run.params.restitution_wall = 0.8;
    run.step(7.0);
    QCOMPARE(run.state.velocity.y, 0.0);
    QVERIFY(run.state.flags & PHYS_AT_REST);
    QVERIFY(std::abs(run.events.back().time - 6.415015353721691642938229) <= 1e-6);
}

void ExactContacts::ballPivotsOnAnEdgeAndLeavesIt() {
    const double R = 0.005, angle = 0.3, speed = 0.01;
    Run run({kFloor, exact::wall(-1, -1, 0, 0)}, R, {R * std::sin(angle), R * std::cos(angle), R},
            {speed * std::cos(angle), -speed * std::sin(angle), 0});
    run.setLaw(0.0, -0.5, 0.02);
    run.step(0.5);
    const std::vector<phys_event> left = run.eventsOf(PHYS_EVENT_RELEASE);
    QCOMPARE(left.size(), size_t(1));
    QVERIFY(std::abs(left[0].time - 0.13076928319244) <= 5e-15); // digits of the figure
    // The angle from the top; a position error turns the normal by 1/R of it.
    QVERIFY(std::abs(std::atan2(left[0].normal.x, left[0].normal.y) - 0.88321232484153708829) <= 4.0 * kU / R);
    QVERIFY(run.eventsOf(PHYS_EVENT_IMPACT).empty());
    QVERIFY(std::abs(run.report.energy_scheme) <= 4.0 * kU);
}

void ExactContacts::ballLeavesTheFloorFallsAndIsOut() {
    Run run({exact::floorOver(-1, -1, 1, 1)}, 0.0625, {0, 0, 0.0625}, {1, 0, 0});
    run.params.gravity = {0, 0, -10.0};
    run.step(1.5);
    QVERIFY(exact::difference(run.state, 1.5, 0.0, 1.0, 0.0) <= 2.0 * kU);
    QVERIFY(std::abs(run.state.position.z - (0.0625 - 0.5 * 10.0 * 0.25)) <= 8.0 * kU);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AIRBORNE | PHYS_OUT));
    QCOMPARE(run.eventsOf(PHYS_EVENT_TAKEOFF).size(), size_t(1));
    QVERIFY(std::abs(run.report.energy_scheme) <= 32.0 * kU);
}

void ExactContacts::fallOnALowerFloorIsNone() {
    // model.md 2.1 R6: below the floor's plane nothing carries the ball any more.
    Run run({exact::floorOver(-1, -1, 0, 1), exact::floorOver(0.5, -1, 2, 1)}, 0.0625, {-0.25, 0, 0.0625}, {1, 0, 0});
    run.step(1.0);
    QVERIFY(run.state.position.z < 0.0);
    QVERIFY(run.state.flags & PHYS_AIRBORNE);
}

void ExactContacts::ballInAWallIsPushedOut() {
    Run run({kFloor, exact::wall(0, -1, 1, 1)}, 0.125, {0.0625, 0, 0.125});
    run.step(1.0);
    QCOMPARE(run.state.position.x, -0.125);
    QCOMPARE(run.report.penetration, 0.1875);
}

void ExactContacts::ballBetweenTwoWallsTooCloseIsStuck() {
    Run run({kFloor, exact::wall(0.1, -1, 1, 1), exact::wall(-1, -1, -0.1, 1)}, 0.125, {0, 0, 0.125});
    const phys_state before = run.state;
    phys_error error{};
    QCOMPARE(run.tryStep(1.0, &error), phys_status(PHYS_ERROR_STUCK));
    QCOMPARE(phys_state_hash(&run.state), phys_state_hash(&before));
}

/// model.md 6.4: each bounce takes half as long, 4.8 s in total. The face's position, 0.3 + 0.1, isn't representable as
/// a double.
void ExactContacts::bouncesKeepTheirTimesToTheLast() {
    Run run({exact::floorOver(-4, -4, 4, 4), exact::wall(-4, 0, 4, 0.3)}, 0.1, {0, 0.4, 0.1}, {0.25, 0.6, 0});
    run.params.restitution_wall = 0.5;
    run.setLaw(0.0, -0.5, 0.0);
    run.step(5.0);
    const std::vector<phys_event> impacts = run.eventsOf(PHYS_EVENT_IMPACT);
    QVERIFY(impacts.size() > 20);
    for (size_t i = 0; i < impacts.size(); ++i) {
        const double still = std::ldexp(1.0, -int(i + 1));
        QVERIFY(std::abs(impacts[i].time - 4.8 * (1.0 - still)) <= 16.0 * kU);
        QVERIFY(std::abs(impacts[i].speed_before + 1.2 * still) <= 16.0 * kU * still);
    }
}

void ExactContacts::elasticBouncesBelowSightDontCountUp_data() {
    QTest::addColumn<bool>("isRigid");
    QTest::addColumn<double>("acceleration"); // of the mean motion along the floor
    QTest::addColumn<double>("tolerance");
    QTest::newRow("friction acts in no flight") << false << 0.49 << 8.0 * kU;
    QTest::newRow("friction ends each flight's slip") << true << 0.35 << 1.1e-6; // of half a flight's pull
}

void ExactContacts::elasticBouncesBelowSightDontCountUp() {
    QFETCH(bool, isRigid);
    QFETCH(double, acceleration);
    QFETCH(double, tolerance);
    Run run({exact::floorOver(-4, -4, 4, 4)}, 0.1, {0, 0, 0.1}, {0.25, 0, 1e-5});
    run.params.model = isRigid ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
    run.params.restitution_floor = 1.0;
    run.params.sliding_friction = 0.5;
    run.params.gravity = {0.49, 0, -9.8};
    run.state.spin = {0, 2.5, 0};
    run.step(0.5); // 245,000 bounces, 5e-12 m high
    QVERIFY(std::abs(run.state.velocity.x - (0.25 + 0.5 * acceleration)) <= tolerance);
    QVERIFY(std::abs(run.state.position.x - (0.125 + 0.125 * acceleration)) <= tolerance);
    QVERIFY(std::abs(run.state.velocity.z) <= 1e-5 * (1.0 + 1e-9));
    QVERIFY(std::abs(double(run.report.event_count) + double(run.report.events_lost) - 245000.0) <= 1.0);
    QVERIFY(std::abs(run.report.energy_scheme) <= 8.0 * kU);
}

/// model.md 6.4, many bounces at once.
void ExactContacts::bouncesThatHardlyDecayKeepTheirTimes() {
    const double eps = 0.99, flight = 2.0 * 0.1 / 9.8;
    Run run({exact::floorOver(-4, -4, 4, 4)}, 0.1, {0, 0, 0.1}, {0.25, 0, 0.1});
    run.params.restitution_floor = eps;
    run.params.gravity = {0, 0, -9.8};
    run.step(2.0);
    const std::vector<phys_event> landings = run.eventsOf(PHYS_EVENT_LANDING);
    QVERIFY(landings.size() > 300);
    for (size_t i = 0; i < landings.size(); ++i) {
        const double still = std::pow(eps, double(i + 1));
        QVERIFY(std::abs(landings[i].time - flight * (1.0 - still) / (1.0 - eps)) <= 64.0 * kU);
        QVERIFY(std::abs(landings[i].speed_after - 0.1 * still) <= 8.0 * kU);
        QVERIFY(std::abs(landings[i].point.x - 0.25 * landings[i].time) <= 8.0 * kU);
    }
    QVERIFY(std::abs(run.report.lost_impact + run.report.energy_after - run.report.energy_before) <= 8.0 * kU);
}

void ExactContacts::bouncesEndWhenTheirSumDoes_data() {
    QTest::addColumn<double>("before"); // s: a step ends this long before the last bounce
    QTest::newRow("in one step") << 0.0;
    QTest::newRow("in two, amid bounces too low to be seen") << 4e-5;
}

/// model.md 6.4: until then the floor doesn't act along itself; from then on the ball rolls.
void ExactContacts::bouncesEndWhenTheirSumDoes() {
    QFETCH(double, before);
    const double eps = 0.999, slope = 0.0098, end = 2.0 * 0.05 / 9.8 / (1.0 - eps);
    Run run({exact::floorOver(-4, -4, 4, 4)}, 0.1, {0, 0, 0.1}, {0, 0, 0.05});
    run.params.restitution_floor = eps;
    run.params.gravity = {slope, 0, -9.8};
    if (before > 0.0) run.step(end - before);
    run.step(end + 1.0 - run.state.time);
    QVERIFY(std::abs(run.state.velocity.x - slope * (end + 5.0 / 7.0)) <= 256.0 * kU);
    QVERIFY(std::abs(run.state.position.x - slope * (0.5 * end * end + end + 5.0 / 14.0)) <= 4096.0 * kU);
    QCOMPARE(run.state.velocity.z, 0.0);
}

void ExactContacts::bouncesOfAFastBallDontBeginAnew_data() {
    QTest::addColumn<double>("restitution");
    for (const double restitution : {0.89, 0.9, 0.93, 0.95, 0.951, 0.99}) {
        QTest::addRow("restitution %g", restitution) << restitution;
    }
}

/// model.md 6.4: a ball so fast along the floor that the speed of its last bounces is rounding relative to it.
void ExactContacts::bouncesOfAFastBallDontBeginAnew() {
    QFETCH(double, restitution);
    const double slope = 0.3, fast = 4.0, rest = 0.05, end = 2.0 * 0.1 / 9.8 / (1.0 - restitution);
    Run run({exact::floorOver(-1, -1, 20, 1)}, 0.006, {0, 0, 0.006}, {fast, 0, 0.1});
    run.params.restitution_floor = restitution;
    run.params.gravity = {slope, 0, -9.8};
    run.step(end + rest);
    const double speed = fast + slope * end, way = end * (fast + 0.5 * slope * end);
    QVERIFY(std::abs(run.state.velocity.x - (speed + 5.0 / 7.0 * slope * rest)) <= 256.0 * kU);
    QVERIFY(std::abs(run.state.position.x - (way + rest * (speed + 5.0 / 14.0 * slope * rest))) <= 1024.0 * kU);
    QCOMPARE(run.state.velocity.z, 0.0);
}

void ExactContacts::startsBackAlongAKerbAgainstResistance_data() {
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("speed");
    const double slips = 0.00496938, rolls = 0.00923421;
    QTest::newRow("the floor slips on the way back") << 0.0433 << slips;
    for (const double friction : {0.0434, 0.0446, 0.0455, 0.046, 0.3}) {
        QTest::addRow("both stick, friction %g", friction) << friction << rolls;
    }
}

/// A ball rolls along floor and kerb, stops after 0.0404 s and starts back: model.md 14.1. Both stick as long as the
/// floor has the friction that they need without resistance, 0.043363 of its pressure. The speeds have all digits of an
/// integration of the law of contact that shares nothing with this library: it tries all modes, extrapolates Gragg's
/// steps to their limit and bisects events.
void ExactContacts::startsBackAlongAKerbAgainstResistance() {
    QFETCH(double, friction);
    QFETCH(double, speed);
    const double R = 0.006, height = 0.005, v = -0.05, up = (R - height) / R, away = -std::sqrt(1.0 - up * up);
    for (const int steps : {1, 50}) {
        Run run({exact::floorOver(-1, -1, 1, 1), {{-away * R, -1, -0.02}, {1, 1, height}}}, R, {0, 0, R}, {0, v, 0});
        run.state.spin = {-v / R, 0, v / R * (1.0 - up) / away};
        run.params.model = PHYS_MODEL_RIGID;
        run.params.gravity = {2.9136, 1.8527, -9.1823};
        run.params.rolling_friction = 0.027;
        run.params.sliding_friction = friction;
        run.params.wall_friction = 0.15;
        for (int i = 0; i < steps; ++i) run.step(0.05 / steps);
        QVERIFY(std::abs(run.state.velocity.y - speed) <= 6e-9);
    }
}

/// Gravity lifts the ball over a kerb from the first moment: the floor doesn't carry it, and its spin stays.
void ExactContacts::aFloorThatOpensAtOnceTurnsNoBall() {
    const double R = 0.01;
    Run run({exact::floorOver(-1, -1, 1, 1), {{0.6 * R, -1, -0.02}, {1, 1, 0.2 * R}}}, R, {0, 0, R}, {0, 0, 0});
    run.state.spin = {0, 0, 10};
    run.params.gravity = {9, 0, -4};
    run.params.restitution_wall = run.params.restitution_floor = 0;
    run.step(1e-3);
    QVERIFY(run.state.velocity.z > 2.8e-3);
    QCOMPARE(run.state.spin.x, 0.0);
    QCOMPARE(run.state.spin.y, 0.0);
    QCOMPARE(run.state.spin.z, 10.0);
}

/// A ball slips along floor and kerb under a roof as high as it, to which nothing presses it but rounding.
void ExactContacts::aRoofWithoutPressureChangesNoSlip() {
    const phys_box kerb{{-0.05, 0.006, 0}, {0.05, 0.024, 0.003163435666872539}};
    const phys_box roof{{-0.05, -0.05, 0.012}, {0.05, 0.05, 0.018}};
    const auto speedUnder = [&](const std::vector<phys_box> &boxes) {
        Run run(boxes, 0.006, {0, 0.0007128549495943316, 0.006}, {0.014, 0, 0});
        run.params.model = PHYS_MODEL_RIGID;
        run.params.sliding_friction = 0.2;
        run.params.wall_friction = 0.0;
        run.params.gravity = {2.16, -1.5, -9.45};
        run.state.spin = {-36.7, 0.34, 9.06};
        run.step(0.04);
        return run.state.velocity.x;
    };
    QVERIFY(std::abs(speedUnder({kFloor, kerb, roof}) - speedUnder({kFloor, kerb})) <= 64.0 * kU);
}

void ExactContacts::aWallToWhichTheBallWouldReturnIsntLeft_data() {
    QTest::addColumn<int>("steps");
    QTest::newRow("in one step") << 1;
    QTest::newRow("in 3 steps") << 3;
    QTest::newRow("in 100 steps") << 100;
}

void ExactContacts::aWallToWhichTheBallWouldReturnIsntLeft() {
    // model.md 14.1: both kerbs alone would have a smaller sum of N than floor and wall, and let the ball leave the
    // wall; but without the wall the floor alone has the smallest, and its friction drives the ball back.
    QFETCH(const int, steps);
    const double R = 0.01, time = 0.1, pressure = 9.8, friction = 0.9, drive = 2.0, spin = 40.0;
    Run run({{{-1, -1, -1}, {1, 1, 0}},
             {{-1, -1, -1}, {-0.6 * R, 1, 0.2 * R}},
             {{0.6 * R, -1, -1}, {1, 1, 0.2 * R}},
             {{-1, -1, -1}, {1, -R, 1}}},
            R, {0, 0, R});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.gravity = {0, drive, -pressure};
    run.params.restitution_wall = 0.0;
    run.params.sliding_friction = friction;
    run.params.wall_friction = 0.0;
    run.state.spin = {spin, 0, 0};
    for (int i = 0; i < steps; ++i) run.step(time / steps);
    const double rolls = time - R * spin / (2.5 * friction * pressure); // for so long, once the slip has ended
    QVERIFY(std::abs(run.state.position.y - 5.0 / 14.0 * drive * rolls * rolls) <= 1e-12 * R);
    QVERIFY(std::abs(R * run.state.spin.x + 5.0 / 7.0 * drive * rolls) <= 1e-12);
}

/// model.md 14.1: with the least friction the roof would have to pull; with more of it, which maintains its own
/// pressure, both press.
void ExactContacts::sticksAtTwoCornersOfWhichOneHardlyPresses() {
    Run run({{{0.00044865372904866126, -0.0025893347784924315, -0.01705808868396189},
              {0.014945741444426367, -0.0013880045394608553, 0.00018002120022359621}},
             {{-0.032533831675933766, 0.0057303550356284727, 0.0077784912610545515},
              {0.022074220065037443, 0.01054012913891734, 0.018550457400615374}}},
            0.006, {0, 0, 0.006}, {0.18898115204952545, -0.0048828818866880428, 0.015732799716525366});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.wall_friction = 1e6;
    run.params.gravity = {0, 0, -9.81};
    run.state.spin = {-2.7455191901211546, 43.560526861174729, 46.498544460576113};
    const phys_vec3 before = run.state.velocity;
    const double time = 1e-9;
    run.step(time);
    // It turns about the line through both points: four equations of sticking contacts, solved for v' and om'.
    QVERIFY(std::abs((run.state.velocity.x - before.x) / time - 0.579122) <= 1e-5);
    QVERIFY(std::abs((run.state.velocity.y - before.y) / time - 2.108564) <= 1e-5);
    QVERIFY(std::abs((run.state.velocity.z - before.z) / time + 6.641280) <= 1e-5);
    QCOMPARE(run.report.lost_slip, 0.0);
}

void ExactContacts::aHeldBallWhoseSlipStartsTurnsOn_data() {
    QTest::addColumn<int>("steps");
    QTest::newRow("in one step") << 1;
    QTest::newRow("in 100 steps") << 100;
}

/// model.md 14.1: two edges and a wall hold the ball, and one combination of modes fits, in which the slip at the kerb
/// starts. No jam ends the spin at once.
void ExactContacts::aHeldBallWhoseSlipStartsTurnsOn() {
    QFETCH(const int, steps);
    Run run({{{-0.026720169713161518, 0.0019519229574501381, -0.0030010349016491317},
              {-0.0056736228961906787, 0.024406534120433612, 0.010334917952161361}},
             {{0.0025667641069520688, -0.039617414122320033, -0.0086417236548697492},
              {0.0075202507518533921, 0.012355868167180364, 0.00057674249004691439}},
             {{0.006, -0.018711614492391754, -0.015351645263014317},
              {0.025687554074921203, 0.01299438866266563, 0.032076988572600877}}},
            0.006, {0, 0, 0.006});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.wall_friction = 0.93372959072130401;
    run.params.gravity = {8.3439554458339966, 9.3356196720347491, -7.3359273029462821};
    run.state.spin = {-18.423738044856105, 0, 38.927097134695934};
    double lost = 0.0;
    for (int i = 0; i < steps; ++i) {
        run.step(0.0024730968341474899 / steps);
        lost += run.report.lost_slip;
    }
    QVERIFY(exact::equal(run.state.velocity, {}));
    // What swept converges to.
    QVERIFY(std::abs(run.state.spin.x + 13.64) <= 0.01);
    QVERIFY(std::abs(run.state.spin.y - 0.995) <= 0.01);
    QVERIFY(std::abs(run.state.spin.z - 9.274) <= 0.01);
    QVERIFY(std::abs(lost - 0.0114) <= 1e-4);
}

/// Between a floor, whose law is another one than that in the air, and a kerb's edge, with 6e-9 R of play.
void ExactContacts::hopsBelowTheToleranceDontDependOnTheStep() {
    const double R = 0.006, time = 0.18610626572903211;
    const auto after = [&](int steps) {
        Run run({{{-0.36, -0.36, -0.09}, {0.36, 0.36, 0}},
                 {{-0.36, -0.0086958141191551645, -0.006}, {0.36, -0.0032460401183481216, 0.00095389023361003278}}},
                R, {0, 0, R});
        run.params.restitution_wall = run.params.restitution_floor = 0.0;
        run.params.rolling_friction = 0.0019898986721456464;
        run.params.gravity = {-2.3640708986119128, -2.8317741122628108, -7.0913149550784027};
        for (int i = 0; i < steps; ++i) run.step(time / steps);
        return run.state.position.x;
    };
    QVERIFY(std::abs(after(1) - after(100)) <= 1e-9 * R);
}

void ExactContacts::whatPressesNothingBrakesNothing_data() {
    QTest::addColumn<std::vector<phys_box>>("boxes"); // the last one presses nothing
    QTest::addColumn<phys_vec3>("gravity");
    QTest::addColumn<double>("friction");
    const double side = std::sqrt(0.5), third = 1.0 / 3.0;
    const phys_box left{{-9, -9, -9}, {-1, 9, 9}}, right{{1, -9, -9}, {9, 9, 9}};
    const phys_box kerb{{-1.5, side, -2}, {1.5, 2, 1 - side}}, floor{{-20, -20, -5}, {20, 20, 0}};
    const phys_box near{{third * 2, -2, third * 4}, {2, third * -2, 3}},
        far{{-2, third * 2, third * 4}, {third * -2, 2, 3}};
    using Boxes = std::vector<phys_box>;
    QTest::newRow("a post at a mouth") << Boxes{exact::wall(1, 0, 3, 0.5), exact::wall(-3, -0.5, -1, 0)}
                                       << phys_vec3{0, 1, 0} << 0.0;
    QTest::newRow("a facing post") << Boxes{exact::wall(1, -0.5, 3, 0), exact::wall(-3, -0.5, -1, 0)}
                                   << phys_vec3{0, 1, 0} << 0.0;
    QTest::newRow("a facing post, pressed to the other one")
        << Boxes{exact::wall(1, -0.5, 3, 0), exact::wall(-3, -0.5, -1, 0)} << phys_vec3{0.5, 1, 0} << 0.0;
    QTest::newRow("a wall behind") << Boxes{right, kerb, left} << phys_vec3{0.875, 0, -0.625} << 1.0;
    const double root = std::sqrt(third);
    const phys_box below{{-2, -2, -2}, {third * -2, -third, third}}, above{{-2, third, third * 5}, {third * -2, 2, 3}};
    const phys_box post{{-2, -2, 0.2}, {-side, -side, 2}}, corner{{root, root, -0.3}, {2, 2, 1 - root}};
    QTest::newRow("a wall behind two corners") << Boxes{below, above, right} << phys_vec3{-9, 0, 6} << 0.0;
    QTest::newRow("a kerb's corner behind a post") << Boxes{floor, post, corner} << phys_vec3{-9, 4, -3} << 1.0;
    QTest::newRow("a roof's corner over a floor") << Boxes{floor, near, far} << phys_vec3{7.35, -8.6, -2.45} << 1.13;
}

/// Boxes lock the ball across, and it leaves the narrowest place between them: model.md 14.1.
void ExactContacts::whatPressesNothingBrakesNothing() {
    QFETCH(const std::vector<phys_box>, boxes);
    QFETCH(const phys_vec3, gravity);
    QFETCH(const double, friction);
    const auto after = [&](size_t count) {
        Run run({boxes.begin(), boxes.begin() + static_cast<ptrdiff_t>(count)}, 1.0, {0, 0, 1});
        run.params.model = PHYS_MODEL_RIGID;
        run.params.gravity = gravity;
        run.params.sliding_friction = 0.0;
        run.params.wall_friction = friction;
        run.step(0.5);
        return run.state;
    };
    const phys_state with = after(boxes.size()), without = after(boxes.size() - 1);
    QVERIFY(exact::difference(with, without.position.x, without.position.y, without.velocity.x, without.velocity.y) <=
            1e-11);
    QVERIFY(std::abs(with.position.z - without.position.z) <= 1e-11);
}

/// model.md 2.1: resistance is in proportion to N, which is 0. The scene starts below the floor, so that gravity
/// needn't pull down; it pulls along the floor and away from the edge of a roof.
void ExactContacts::aFloorWithoutPressureHoldsNoBall() {
    const double time = 0.0625, share = 5.0 / 7.0 * time;
    Run run({{{-9, -9, 10}, {9, 9, 16}}, {{-2, -3, 17.6}, {-0.8, 3, 20}}}, 1.0, {0, 0, 17});
    run.params.gravity = {1, 4, 0};
    run.params.rolling_friction = 0.125;
    run.step(time);
    QVERIFY(exact::difference(run.state, 0.5 * share * time, 2.0 * share * time, share, 4.0 * share) <= 4.0 * kU);
    QVERIFY(!(run.state.flags & PHYS_AT_REST));
}

QTEST_GUILESS_MAIN(ExactContacts)
#include "tst_exact_contacts.moc"
