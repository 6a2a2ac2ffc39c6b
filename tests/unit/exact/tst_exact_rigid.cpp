// SPDX-License-Identifier: MIT
// The rigid model: slip, the return to rolling, rough walls, grooves. Figures of model.md 12.2 and 12.4.
#include "run.h"

#include <QtTest>

using exact::kU;
using exact::Run;

class ExactRigid : public QObject {
    Q_OBJECT
private slots:
    void slipsOnASmoothFloor_data();
    void slipsOnASmoothFloor();
    void slipEndsRolling();
    void impactCostsSpeedTwice();
    void slipAfterAnImpactLastsAsLongAsPredicted();
    void slipBesideAWallOnTheRoughestFloorEndsInTime();
    void slipBesideAWallDecaysByItsPowerLaw();
    void roughWallLiftsTheBall_data();
    void roughWallLiftsTheBall();
    void grooveTakesFiveNinths();
    void ballSpinsDownAtTheWall();
    void ballSpinsDownInACorner();
    void ballThatPivotsOnTheSpotIsNotAtRest();
    void wholeSceneFollowsTheReference();
};

namespace {

const phys_box kWideFloor = exact::floorOver(-8, -8, 8, 8);

/// Gives the ball the spin of rolling with its velocity.
void roll(Run &run, double radius) {
    const phys_vec3 &v = run.state.velocity;
    run.params.model = PHYS_MODEL_RIGID;
    run.params.rolling_friction = 0.0;
    run.params.wall_friction = 0.0;
    run.state.spin = {-v.y / radius, v.x / radius, 0.0};
}

bool near(double found, double wanted, double units) {
    if (std::abs(found - wanted) <= units * kU) return true;
    qWarning("found %.17g, wanted %.17g", found, wanted);
    return false;
}

} // namespace

void ExactRigid::slipEndsRolling() {
    Run run({kWideFloor}, 0.005, {0, 0, 0.005}, {0.3, 0.2, 0});
    roll(run, 0.005);
    run.state.spin = {-30, 80, 15};
    run.params.sliding_friction = 0.2;
    run.params.gravity = {0.9, -0.5, -9.7};
    run.step(0.015);
    const double after = 0.015 - 0.014300320760347717058; // it rolls with (5/7) g_t since then
    const double ax = 0.9 * 5 / 7, ay = -0.5 * 5 / 7, vx = 0.33776449191736638954, vy = 0.18060702829987581534;
    const double x = 0.0045598129871729534431, y = 0.0027207722601183883503;
    QVERIFY(exact::difference(run.state, x + after * (vx + 0.5 * after * ax), y + after * (vy + 0.5 * after * ay),
                              vx + after * ax, vy + after * ay) <= 4.0 * kU);
    const std::vector<phys_event> rolls = run.eventsOf(PHYS_EVENT_ROLL);
    QCOMPARE(rolls.size(), size_t(1));
    QVERIFY(near(rolls[0].time, 0.014300320760347717058, 1.0));
    QCOMPARE(run.state.spin.z, 15.0);
    QVERIFY(!(run.state.flags & PHYS_SLIPPING));
}

void ExactRigid::impactCostsSpeedTwice() {
    // model.md 4: (5 eps - 2)/7 of the normal speed remains; 0.0882 are lost to the wall, 0.2268 to slip.
    Run run({kWideFloor, exact::wall(0.1, -4, 1, 4)}, 0.005, {0, 0, 0.005}, {0.7, 0.4, 0});
    roll(run, 0.005);
    run.params.restitution_wall = 0.8;
    run.params.sliding_friction = 0.3;
    run.step(1.0);
    QVERIFY(near(run.state.velocity.x, -0.2, 4.0));
    QVERIFY(near(run.state.velocity.y, 0.4, 4.0));
    QVERIFY(near(run.report.lost_impact, 0.0882, 2.0));
    QVERIFY(near(run.report.lost_slip, 0.2268, 4.0));
    QVERIFY(near(run.report.energy_scheme, 0.0, 4.0));
}

void ExactRigid::slipAfterAnImpactLastsAsLongAsPredicted() {
    Run run({kWideFloor, exact::wall(0.1, -4, 1, 4)}, 0.005, {0, 0, 0.005}, {0.5, 0, 0});
    roll(run, 0.005);
    run.params.restitution_wall = 0.8;
    run.params.sliding_friction = 0.3;
    run.params.gravity = {0, 0, -9.81};
    run.step(1.0);
    QCOMPARE(run.events.size(), size_t(2));
    QVERIFY(near(run.events[1].time - run.events[0].time, 0.087374399301004805592, 2.0));
    QVERIFY(near(run.state.velocity.x, -1.0 / 7.0, 2.0));
}

/// u_x' = g_x - (7/2) mu N u_x/|u| and u_y' = -(5/2) mu N u_y/|u|, by quadrature to 30 digits.
void ExactRigid::slipBesideAWallOnTheRoughestFloorEndsInTime() {
    Run run({kWideFloor, exact::wall(-1, -1, 1, -0.0078125)}, 0.0078125, {0, 0, 0.0078125});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.sliding_friction = 1e6;
    run.params.wall_friction = 0.0;
    run.params.gravity = {3.4751098306613488, -3.4751098306613506, -8.4901898288366731};
    run.state.spin = {219.63732325533238, 180.42133102093305, 182.32103503476674};
    run.step(1e-3);
    const std::vector<phys_event> rolls = run.eventsOf(PHYS_EVENT_ROLL);
    QCOMPARE(rolls.size(), size_t(1));
    QVERIFY(near(rolls[0].time, 9.45696980532896536804e-08, 2.0));
}

void ExactRigid::slipBesideAWallDecaysByItsPowerLaw() {
    // model.md 14.2 without gravity along the wall: du_y / du_x = (7/5) u_y / u_x.
    const double radius = 0.005;
    Run run({exact::kFloor, exact::wall(radius, -4, 1, 4)}, radius, {0, 0, radius}, {0, 0.1, 0});
    roll(run, radius);
    run.params.sliding_friction = 0.3;
    run.params.gravity = {2.0, 0.0, -9.8};
    run.state.spin = {0, 40, 0}; // the slip is (-0.2, 0.1)
    for (int i = 0; i < 20; ++i) {
        run.step(0.001);
        const double across = -radius * run.state.spin.y;
        const double along = run.state.velocity.y + radius * run.state.spin.x;
        QVERIFY(near(along, 0.1 * std::pow(across / -0.2, 1.4), 1.0));
        QVERIFY(run.state.flags & PHYS_SLIPPING);
        QVERIFY(near(run.report.energy_scheme, 0.0, 1.0));
    }
    run.step(0.1);
    QVERIFY(near(run.state.velocity.y, 0.1 * 5 / 7, 1.0));
    QVERIFY(!(run.state.flags & PHYS_SLIPPING));
}

void ExactRigid::roughWallLiftsTheBall_data() {
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("vy");
    QTest::addColumn<double>("vz");
    QTest::newRow("slides on the wall") << 0.1 << 0.337486493767 << 0.109398635908;
    QTest::newRow("grips the wall") << 0.3 << 2.0 / 7.0 << 0.2;
}

void ExactRigid::roughWallLiftsTheBall() {
    QFETCH(double, friction);
    QFETCH(double, vy);
    QFETCH(double, vz);
    Run run({kWideFloor, exact::wall(0.0, -4, 1, 4)}, 0.0625, {-0.0625, 0, 0.0625}, {0.7, 0.4, 0});
    roll(run, 0.0625);
    run.params.restitution_wall = 0.8;
    run.params.restitution_floor = 0.5;
    run.params.sliding_friction = 0.3;
    run.params.wall_friction = friction;
    run.params.gravity = {0, 0, -8.0};
    const double dt = 0x1p-10;
    run.step(dt);
    // 12 digits of the figure.
    QVERIFY(std::abs(run.state.velocity.y - vy) <= 1e-12);
    QVERIFY(std::abs(run.state.velocity.z - (vz - 8.0 * dt)) <= 1e-12);
    QVERIFY(run.state.flags & PHYS_AIRBORNE);
    run.step(2.0);
    QVERIFY(!(run.state.flags & PHYS_AIRBORNE));
    QCOMPARE(run.state.position.z, 0.0625);
    QVERIFY(near(run.report.energy_scheme, 0.0, 8.0));
}

void ExactRigid::grooveTakesFiveNinths() {
    Run run({kWideFloor, exact::wall(-1, -4, 0, 4)}, 0.0625, {0.0625, 0, 0.0625});
    roll(run, 0.0625);
    run.params.sliding_friction = 0.5;
    run.params.wall_friction = 0.25;
    run.params.gravity = {-0.8, 0.5, -9.81};
    run.step(1.0);
    QVERIFY(near(run.state.velocity.y, 5.0 / 18.0, 2.0));
    QVERIFY(near(run.state.position.y, 5.0 / 36.0, 2.0));
    QCOMPARE(run.state.position.x, 0.0625);
    QVERIFY(near(run.report.energy_scheme, 0.0, 2.0));
}

void ExactRigid::ballSpinsDownAtTheWall() {
    // model.md 6.5, eps = 0: on a level board the spin takes (2/5) V/(mu_s gn); along the wall u_t is 0 throughout.
    Run run({kWideFloor, exact::wall(0, -4, 1, 4)}, 0.0625, {-0.0625, 0, 0.0625}, {0.5, 0.25, 0});
    roll(run, 0.0625);
    run.params.restitution_wall = 0.0;
    run.params.sliding_friction = 0.25;
    run.params.gravity = {0, 0, -8.0};
    run.step(1.0);
    const std::vector<phys_event> rolls = run.eventsOf(PHYS_EVENT_ROLL);
    QCOMPARE(rolls.size(), size_t(1));
    QVERIFY(near(rolls[0].time, 0.4 * 0.5 / (0.25 * 8.0), 1.0));
    QVERIFY(near(run.state.position.y, 0.25, 1.0));
    QCOMPARE(run.state.position.x, -0.0625);
    QVERIFY(near(run.report.energy_scheme, 0.0, 2.0));
}

void ExactRigid::ballSpinsDownInACorner() {
    // Touching a second wall without being pressed against it needs no search: w' = -(5/2) mu_s gn = -5.
    Run run({kWideFloor, exact::wall(-1, 0, 1, 1), exact::wall(0, -1, 1, 1)}, 0.0625, {-0.0625, -0.0625, 0.0625});
    roll(run, 0.0625);
    run.state.spin = {-16.0, 0.0, 0.0};
    run.params.restitution_wall = 0.0;
    run.params.sliding_friction = 0.25;
    run.params.gravity = {0, 0.5, -8.0};
    run.step(1.0);
    const std::vector<phys_event> rolls = run.eventsOf(PHYS_EVENT_ROLL);
    QCOMPARE(rolls.size(), size_t(1));
    QVERIFY(near(rolls[0].time, 16.0 * 0.0625 / 5.0, 1.0));
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

void ExactRigid::ballThatPivotsOnTheSpotIsNotAtRest() {
    Run run({kWideFloor}, 0.0625, {0, 0, 0.0625}); // model.md 14.1: nothing acts about the normal
    run.params.model = PHYS_MODEL_RIGID;
    run.state.spin = {0.0, 0.0, 3.0};
    run.step(1.0);
    QCOMPARE(run.state.spin.z, 3.0);
    QCOMPARE(run.state.flags, uint64_t(0));
    run.state.spin = {0.0, 0.0, 0.0};
    run.step(1.0);
    QCOMPARE(run.state.flags, uint64_t(PHYS_AT_REST));
}

void ExactRigid::wholeSceneFollowsTheReference() {
    struct Half {
        double x, y, vx, vy;
    };
    struct Event {
        double time;
        uint32_t box; // PHYS_NO_BOX: rolls again
    };
    const Event expected[] = {{0.13565972485208561882, 4}, {0.28228781302375180924, PHYS_NO_BOX},
                              {0.54573829544082438859, 0}, {0.63532920613638538918, PHYS_NO_BOX},
                              {1.0092814777323701913, 3},  {1.1704862826279984328, PHYS_NO_BOX},
                              {1.6344660531453794765, 0}};
    const Half halves[] = {
        {0.56040776609906518374, 0.082903491788753747577, 0.6489255974137750676, -0.44098736914449592062},
        {0.92980422159598425993, 0.10078903386904098, 0.82749702598520363903, 0.011401500612246856436},
        {0.84512921363606685557, 0.077992239296874427548, -0.032446344769680459438, -0.10020564224489600071},
        {0.87357517023508365062, 0.062765469598179168658, 0.14612508380174811199, -0.0016915177359239416363}};
    Run run({exact::wall(-0.125, -0.125, 1.125, 0), exact::wall(-0.125, 1, 1.125, 1.125), exact::wall(-0.125, 0, 0, 1),
             exact::wall(1, 0, 1.125, 1), exact::wall(0.375, 0.3125, 0.625, 0.375),
             exact::wall(0.625, 0.3125, 0.6875, 0.6875), kWideFloor},
            0.0625, {0.25, 0.1875, 0.0625}, {0.75, 0.5, 0});
    roll(run, 0.0625);
    run.params.restitution_wall = 0.75;
    run.params.sliding_friction = 0.25;
    run.params.gravity = {0.5, -0.3125, -9.75};
    std::vector<phys_event> events;
    for (const Half &half : halves) {
        run.step(0.5);
        events.insert(events.end(), run.events.begin(), run.events.end());
        QVERIFY(exact::difference(run.state, half.x, half.y, half.vx, half.vy) <= 8.0 * kU);
        QVERIFY(near(run.report.energy_scheme, 0.0, 4.0));
    }
    QVERIFY(events.size() >= std::size(expected));
    for (size_t i = 0; i < std::size(expected); ++i) {
        QVERIFY(near(events[i].time, expected[i].time, 8.0));
        QCOMPARE(events[i].box, expected[i].box);
    }
}

void ExactRigid::slipsOnASmoothFloor_data() {
    QTest::addColumn<uint32_t>("options");
    QTest::newRow("at once") << uint32_t(0);
    QTest::newRow("in all stages") << uint32_t(PHYS_OPTION_ALL_STAGES);
}

void ExactRigid::slipsOnASmoothFloor() {
    QFETCH(uint32_t, options);
    Run run({kWideFloor}, 0.005, {0, 0, 0.005}, {0.5, 0, 0});
    run.params.model = PHYS_MODEL_RIGID;
    run.params.options = options;
    run.params.sliding_friction = 0.0;
    run.step(0.001);
    QCOMPARE(run.state.flags, uint64_t(PHYS_SLIPPING));
}

QTEST_GUILESS_MAIN(ExactRigid)
#include "tst_exact_rigid.moc"
