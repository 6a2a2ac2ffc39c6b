// SPDX-License-Identifier: MIT
// Energy: the report of a step balances, and a stepper's own energy error is bounded: model.md 9 and 10.
#include "drawn_scene.h"
#include "support/compare.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace invariants;
using namespace support;

namespace {

constexpr int kEnergyScenes = 16;

double speedOf(const phys_state &state) { return std::hypot(state.velocity.x, state.velocity.y, state.velocity.z); }

/// 7/10 for a ball on the floor under the rolling model, 1/2 for one that keeps its spin: model.md 9.
double lossOf(const phys_event &event, uint32_t model) {
    const bool rolling = model == PHYS_MODEL_ROLLING && event.kind == PHYS_EVENT_IMPACT;
    const double before = event.speed_before;
    const double after = event.speed_after;
    return (rolling ? 0.7 : 0.5) * (before * before - after * after);
}

struct Losses {
    double rolling = 0.0, slip = 0.0; ///< J/kg
    int steps = 0;
};

Losses lossesIn(Experiment &ball, double duration, double dt) {
    Losses lost;
    for (; lost.steps * dt < duration && ball.step(dt); ++lost.steps) {
        lost.rolling += ball.report.lost_rolling;
        lost.slip += ball.report.lost_slip;
    }
    return lost;
}

/// Rows of all steppers and models with each coefficient of friction, in steps that are short and long for the ball.
void addRowsOf(std::initializer_list<double> frictions) {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("dt");
    for (const QByteArray &stepper : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (const double friction : frictions) {
                for (const double dt : {0x1p-10, 0x1p-7, 0x1p-3})
                    QTest::addRow("%s-%s-%g-%g", stepper.constData(), modelName(model).constData(), friction, dt)
                        << stepper << model << friction << dt;
            }
        }
    }
}

/// lostIn(stepper, dt): a loss of some J/kg within a few seconds.
template<class Lost>
void compareWithExact(const QByteArray &stepper, Lost lostIn) {
    const double truth = lostIn("exact", 1.0);
    for (const double dt : {0x1p-4, 0x1p-6, 0x1p-8, 0x1p-10}) {
        // The clamp at the end is of first order there, and thus of second order in the sum; so is the chord:
        // model.md 10.5.
        const int order = std::min(2, promiseOf(stepper).smooth);
        const double bound = order == 0 ? rounding(64.0 / dt, truth) : order == 1 ? dt / 8.0 : dt * dt / 2.0;
        COMPARE_WITHIN(lostIn(stepper, dt), truth, bound);
    }
}

} // namespace

class TestEnergy : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(testSeed())); }
    void reportBalances_data() { addStepperAndModelRows(); }
    void reportBalances();
    void lossesAreNeverGains_data() { addStepperAndModelRows(); }
    void lossesAreNeverGains();
    void impactLossIsThatOfItsEvents_data() { addStepperAndModelRows(); }
    void impactLossIsThatOfItsEvents();
    void eventsLieWithinTheirStep_data() { addStepperRows(); }
    void eventsLieWithinTheirStep();
    void schemesOwnEnergyIsOfItsOrder_data() { addStepperAndModelRows(); }
    void schemesOwnEnergyIsOfItsOrder();
    void impactUnderAPullMakesNoEnergy_data();
    void impactUnderAPullMakesNoEnergy();
    void resistanceTakesAllOfABallThatItStops_data() { addRowsOf({0.3, 1.0, 100.0, 1e6}); }
    void resistanceTakesAllOfABallThatItStops();
    void slipThatEndsTakesItsOwnEnergy_data() { addRowsOf({0.3, 1.0, 100.0, 1e6}); }
    void slipThatEndsTakesItsOwnEnergy();
    void slipOnASlopeTakesWhatItTakesInExact_data() { addStepperRows(); }
    void slipOnASlopeTakesWhatItTakesInExact();
    void resistanceOnASlopeTakesWhatItTakesInExact_data() { addStepperAndModelRows(); }
    void resistanceOnASlopeTakesWhatItTakesInExact();
    void closingGapsMakesNoEnergy_data();
    void closingGapsMakesNoEnergy();
    void edgeReturnsTheEnergyOfEveryHit_data() { addStepperAndModelRows(); }
    void edgeReturnsTheEnergyOfEveryHit();
    void weightlessRoomKeepsTheEnergy_data() { addStepperAndModelRows(); }
    void weightlessRoomKeepsTheEnergy();
    void orientationStaysAUnitQuaternion_data() { addStepperAndModelRows(); }
    void orientationStaysAUnitQuaternion();
    void orientationTurnsByWayOverRadius_data() { addStepperAndModelRows(); }
    void orientationTurnsByWayOverRadius();

private:
    /// Calls check(experiment, state before) after each step of drawn scenes, until one of them fails the test.
    template<class Check>
    void eachStep(const QByteArray &stepper, uint32_t model, Check check);
};

template<class Check>
void TestEnergy::eachStep(const QByteArray &stepper, uint32_t model, Check check) {
    Random random(testSeed());
    for (int scene = 0; scene < kEnergyScenes; ++scene) {
        const Drawn drawn = draw(random, model);
        Experiment ball = makeExperiment(drawn, stepper);
        for (int i = 0; i < kSegment * kSegments; ++i) {
            ball.params.gravity = drawn.gravities[static_cast<size_t>(i / kSegment)];
            const phys_state before = ball.state;
            const bool stepped = ball.step(drawn.dt);
            if (!stepped && ball.status() == PHYS_ERROR_UNSUPPORTED) break;
            QVERIFY2(stepped, ball.error());
            check(ball, before);
            if (QTest::currentTestFailed()) return;
        }
    }
}

void TestEnergy::reportBalances() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    eachStep(stepper, model, [](Experiment &ball, const phys_state &before) {
        const phys_report &r = ball.report;
        double energy = 0.0;
        QCOMPARE(phys_energy(ball.scene(), &ball.params, &before, &energy), PHYS_OK);
        COMPARE_EXACT(r.energy_before, energy);
        QCOMPARE(phys_energy(ball.scene(), &ball.params, &ball.state, &energy), PHYS_OK);
        COMPARE_EXACT(r.energy_after, energy);
        const double lost = r.lost_impact + r.lost_rolling + r.lost_slip;
        const double size = std::abs(r.energy_before) + std::abs(r.energy_after) + std::abs(lost);
        COMPARE_WITHIN(r.energy_before + r.energy_scheme, r.energy_after + lost, rounding(16, size));
    });
}

void TestEnergy::lossesAreNeverGains() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    eachStep(stepper, model, [model](Experiment &ball, const phys_state &) {
        const double slack = rounding(16, std::abs(ball.report.energy_before) + 1.0);
        QVERIFY(ball.report.lost_impact >= -slack);
        QVERIFY(ball.report.lost_rolling >= 0.0);
        // The rolling model's landing counts as slip, with either sign.
        if (model == PHYS_MODEL_RIGID) QVERIFY(ball.report.lost_slip >= -slack);
        QVERIFY(ball.report.penetration >= 0.0);
    });
}

void TestEnergy::impactLossIsThatOfItsEvents() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    eachStep(stepper, model, [model](Experiment &ball, const phys_state &before) {
        const phys_report &r = ball.report;
        QCOMPARE(r.events_lost, 0U);
        double lost = 0.0;
        double earliest = before.time;
        for (uint32_t i = 0; i < r.event_count; ++i) {
            const phys_event &event = r.events[i];
            QVERIFY(event.time >= earliest && event.time <= ball.state.time);
            earliest = event.time;
            if (event.kind != PHYS_EVENT_IMPACT && event.kind != PHYS_EVENT_LANDING) continue;
            QVERIFY(event.speed_before < 0.0 && event.speed_after >= 0.0);
            const double length = std::hypot(event.normal.x, event.normal.y, event.normal.z);
            COMPARE_WITHIN(length, 1.0, 4.0 * kUnit);
            lost += lossOf(event, model);
        }
        COMPARE_WITHIN(r.lost_impact, lost, rounding(64.0, std::abs(lost) + speedOf(ball.state)));
    });
}

void TestEnergy::eventsLieWithinTheirStep() {
    QFETCH(QByteArray, stepper);
    // Times of steps of 0.01 s are rounded; so are those of events, which need another sum.
    Experiment ball(squareRoom(1.0), stepper, PHYS_MODEL_RIGID); // slips after each impact
    ball.params.restitution_wall = 1.0;
    ball.setPosition(0.5, 0.5);
    ball.roll(3.0, 2.0);
    int events = 0;
    double earliest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        earliest = std::max(earliest, ball.state.time);
        QVERIFY2(ball.step(0.01), ball.error());
        for (uint32_t k = 0; k < ball.report.event_count; ++k, ++events) {
            const double time = ball.report.events[k].time;
            QVERIFY2(time >= earliest && time <= ball.state.time, digits(time - ball.state.time));
            earliest = time;
        }
    }
    QVERIFY(events >= 10);
}

void TestEnergy::schemesOwnEnergyIsOfItsOrder() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    // One smooth step of a freely rolling ball: the energy error is F times the position error.
    for (const double dt : {0x1p-5, 0x1p-8, 0x1p-11}) {
        Experiment ball(openFloor(), stepper, model);
        ball.setLaw(0.5, -0.25, 0.125);
        ball.roll(1.0, 0.5);
        QVERIFY2(ball.step(dt), ball.error());
        const int order = promiseOf(stepper).smooth;
        // The law's acceleration and its derivatives are below 1 here, in units of m and s; so are their powers.
        // Besides, the loss is counted along the step's chord, which is shorter than the arc by turn^2/24.
        const double turn = 0.6 / 1.1 * dt;
        const double chord = 1.4 * 0.125 * 1.2 * dt * turn * turn / 24.0;
        const double bound = order == 0 ? 0.0 : std::pow(dt, order + 1) + chord;
        QVERIFY2(std::abs(ball.report.energy_scheme) <= bound + rounding(16, 2.0), digits(ball.report.energy_scheme));
    }
}

void TestEnergy::impactUnderAPullMakesNoEnergy_data() {
    QTest::addColumn<QByteArray>("stepper");
    // The Euler steppers notice an impact late and give back what the ball has gained meanwhile; that is their own
    // energy error.
    for (const QByteArray &id : higherOrderStepperIds()) QTest::newRow(id.constData()) << id;
}

void TestEnergy::impactUnderAPullMakesNoEnergy() {
    QFETCH(QByteArray, stepper);
    const SceneBuilder scene = SceneBuilder().ball(0.0625).floor(-2, -2, 2, 2).wall(1, -2, 2, 2).start(0.875, 0);
    Experiment ball(scene, stepper, PHYS_MODEL_ROLLING);
    ball.setLaw(1.0, 0.25, 0.0);
    ball.params.restitution_wall = 0.75;
    ball.roll(0.5, 0.25);
    int impacts = 0;
    for (int i = 0; i < 16; ++i) {
        QVERIFY2(ball.step(0x1p-6), ball.error());
        const bool hits = ball.report.lost_impact > 0.0;
        if (hits) ++impacts;
        // Where the impact is found ahead, restitution takes its share of the way's energy as well: model.md 13.5.
        const bool isAhead = hits && promiseOf(stepper).impacts == 1;
        const double taken = isAhead ? (1.0 - 0.75 * 0.75) * 1.4 * 1.0 * 0x1p-6 : 0.0; // a pull of 7/5, less than 1 m/s
        const double made = ball.report.energy_scheme;
        QVERIFY2(made <= rounding(16, 2.0) && made >= -taken - rounding(16, 2.0), digits(made));
    }
    QCOMPARE(impacts, 1);
}

void TestEnergy::closingGapsMakesNoEnergy_data() {
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &id : stepperIds()) {
        if (id != "explicit-euler") QTest::newRow(id.constData()) << id; // gains energy in contact
    }
}

/// A ball that spins a little above a floor, and beside a kerb and a corner, all rough, comes to them in one step.
void TestEnergy::closingGapsMakesNoEnergy() {
    QFETCH(QByteArray, stepper);
    Experiment ball(SceneBuilder()
                        .ball(0.006)
                        .box({{-0.24, -0.24, -0.054}, {0.24, 0.24, 0.0}})
                        .box({{2.595248038838832e-05, -0.021462892589079977, -0.006},
                              {0.0064243335675056535, -0.005730499616895302, 0.004222164065633588}})
                        .box({{0.0037363652135251964, 0.004380160664764792, -0.006},
                              {0.01024269864386379, 0.006902269884082305, 0.004310690217276276}})
                        .start({0.0, 0.0, 0.006}),
                    stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {4.0, 1.0, -9.0};
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = ball.params.wall_friction = 1.0;
    ball.state.position = {1.6555213269395016e-05, -6.328962310995264e-06, 0.006021439966815037};
    ball.state.spin.y = -5.1476569778389605;
    QVERIFY2(ball.step(0.0035329954773535566), ball.error());
    const double made = ball.report.energy_scheme;
    QVERIFY2(made <= rounding(16, 2.0), digits(made));
}

void TestEnergy::edgeReturnsTheEnergyOfEveryHit() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    // From far below a ball's radius per step to eight of them, from nearly head-on to nearly past the edge.
    for (double speed = 0.25; speed <= 32.0; speed *= 2.0) {
        for (int sixteenth = 1; sixteenth < 16; ++sixteenth) {
            const double offset = -0.0625 * sixteenth / 16.0;
            const SceneBuilder scene = SceneBuilder().ball(0.0625).floor(-8, -8, 8, 8).wall(0, 0, 4, 4);
            Experiment ball(scene, stepper, model);
            ball.params.restitution_wall = 1.0;
            ball.params.sliding_friction = ball.params.wall_friction = 0.0;
            ball.setPosition(-0.25, offset);
            ball.roll(speed, 0.0);
            const double before = 0.5 * speed * speed;
            uint32_t impacts = 0;
            for (double left = 0.5; left > 0.0; left -= speed / 64.0) {
                QVERIFY2(ball.step(1.0 / 64.0), ball.error());
                impacts += ball.report.event_count;
            }
            QCOMPARE(impacts, 1U);
            const double after = speedOf(ball.state);
            COMPARE_WITHIN(0.5 * after * after, before, rounding(64.0, before));
        }
    }
}

void TestEnergy::weightlessRoomKeepsTheEnergy() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed());
    for (int room = 0; room < 32; ++room) {
        const double x = random.between(1.0, 3.0), y = random.between(1.0, 3.0), z = random.between(2.5, 5.0);
        SceneBuilder scene = SceneBuilder().ball(1.0).floor(-9, -9, 9, 9).box({{-9, -9, z}, {9, 9, 9}});
        scene.box({{-9, -9, 0}, {-1 - x, 9, z}}).box({{1 + x, -9, 0}, {9, 9, z}});
        scene.box({{-9, -9, 0}, {9, -1 - y, z}}).box({{-9, 1 + y, 0}, {9, 9, z}});
        scene.box({{0.5 + x, -9, 0}, {1 + x, 9, random.between(0.1, 0.9)}}); // a ledge, for its edge
        scene.start({0.0, 0.0, random.between(1.0, z - 1.0)});
        Experiment ball(scene, stepper, model);
        ball.params.gravity = {0.0, 0.0, 0.0};
        ball.params.restitution_wall = ball.params.restitution_floor = 1.0;
        ball.params.sliding_friction = ball.params.wall_friction = 0.0;
        ball.state.velocity = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
        const double dt = std::ldexp(1.0, -static_cast<int>(random.below(4)));
        for (int i = 0; i < 128; ++i) {
            QVERIFY2(ball.step(dt), ball.error());
            const phys_report &r = ball.report;
            COMPARE_WITHIN(r.energy_after, r.energy_before, rounding(64.0, r.energy_before));
            COMPARE_WITHIN(r.lost_impact, 0.0, rounding(64.0, r.energy_before));
        }
    }
}

void TestEnergy::resistanceTakesAllOfABallThatItStops() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(double, friction);
    QFETCH(double, dt);
    Experiment ball(openFloor(), stepper, model);
    ball.params.rolling_friction = friction;
    ball.params.sliding_friction = 1e6;
    ball.roll(0.6, 0.8);
    const double kinetic = 0.7 * 1.0;
    const Losses lost = lossesIn(ball, 4.0, dt);
    COMPARE_WITHIN(lost.rolling, kinetic, rounding(64.0 * lost.steps, kinetic));
    COMPARE_WITHIN(lost.slip, 0.0, rounding(64.0 * lost.steps, kinetic));
}

void TestEnergy::slipThatEndsTakesItsOwnEnergy() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, friction);
    QFETCH(double, dt);
    Experiment ball(openFloor(), stepper, PHYS_MODEL_RIGID);
    ball.params.sliding_friction = friction;
    ball.state.velocity = {0.75, 1.0, 0.0};
    ball.state.spin = {0.0, 0.25 / 0.0625, 8.0};
    // model.md 3.6: of the kinetic energy only u^2/7 is lost.
    const double slip = (0.5 * 0.5 + 1.0) / 7.0;
    const Losses lost = lossesIn(ball, 1.0, dt);
    COMPARE_WITHIN(lost.slip, slip, rounding(64.0 * lost.steps, 1.0));
    COMPARE_EXACT(lost.rolling, 0.0);
}

void TestEnergy::slipOnASlopeTakesWhatItTakesInExact() {
    QFETCH(QByteArray, stepper);
    const auto lostIn = [](const QByteArray &id, double dt) {
        Experiment ball(openFloor(), id, PHYS_MODEL_RIGID);
        ball.params.gravity.x = 1.0;
        ball.params.gravity.y = 0.5;
        ball.params.sliding_friction = 0.5;
        ball.state.velocity = {-3.0, 4.0, 0.0};
        return lossesIn(ball, 1.0, dt).slip;
    };
    compareWithExact(stepper, lostIn);
}

void TestEnergy::resistanceOnASlopeTakesWhatItTakesInExact() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const auto lostIn = [model](const QByteArray &id, double dt) {
        Experiment ball(openFloor(), id, model);
        ball.params.gravity.x = 0.5;
        ball.params.gravity.y = 0.25;
        ball.params.sliding_friction = 1e6;
        ball.params.rolling_friction = 0.125;
        ball.roll(-1.0, 0.5);
        return lossesIn(ball, 4.0, dt).rolling;
    };
    compareWithExact(stepper, lostIn);
}

void TestEnergy::orientationStaysAUnitQuaternion() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed());
    for (int scene = 0; scene < 4; ++scene) {
        const Drawn drawn = draw(random, model);
        Experiment ball = makeExperiment(drawn, stepper);
        ball.params.options = PHYS_OPTION_ORIENTATION;
        for (int i = 0; i < kSegment * kSegments; ++i) {
            ball.params.gravity = drawn.gravities[static_cast<size_t>(i / kSegment)];
            if (!ball.step(drawn.dt)) break;
            const double *q = ball.state.orientation;
            COMPARE_WITHIN(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 8.0 * kUnit);
        }
    }
}

void TestEnergy::orientationTurnsByWayOverRadius() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment ball(openFloor(), stepper, model);
    ball.params.options = PHYS_OPTION_ORIENTATION;
    ball.roll(0.375, 0.5);
    QVERIFY2(ball.stepTimes(1000, 1.0 / 256.0), ball.error());
    // Rolling by s turns the ball by s/R about z x v: model.md 2.1 R7.
    const double half = 0.5 * std::hypot(ball.state.position.x, ball.state.position.y) / 0.0625;
    const double slack = rounding(16.0 * 1000.0, 1.0);
    const double *q = ball.state.orientation;
    const double sign = q[3] * std::cos(half) < 0.0 ? -1.0 : 1.0; // q and -q are one orientation
    COMPARE_WITHIN(sign * q[0], -0.8 * std::sin(half), slack);
    COMPARE_WITHIN(sign * q[1], 0.6 * std::sin(half), slack);
    COMPARE_WITHIN(q[2], 0.0, slack);
    COMPARE_WITHIN(sign * q[3], std::cos(half), slack);
}

QTEST_GUILESS_MAIN(TestEnergy)
#include "tst_energy.moc"
