// SPDX-License-Identifier: MIT
// How the error falls with the step size: ratios where the motion is smooth, envelopes across impacts (model.md 10.2).
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace support;

namespace {

/// A smooth motion of model.md 12.1: law, start, and the ball's position at the end.
struct Arc {
    const char *name;
    double ax, ay, B, vx, vy, duration, x, y;
};

constexpr Arc kFirst{"the first case", -0.6, 0.2, 0.1, 1.0, 0.3, 2.0, 0.66173608811146707468, 0.87942790288305788119};

const std::vector<Arc> kArcs{
    kFirst,
    {"k = 1", 0.5, 0.0, 0.5, 0.3, 0.4, 1.0, 0.35916183820371143944, 0.24322536933179607531},
    {"k = 1/2", 1.0, 0.0, 0.5, -0.3, 0.4, 1.0, 0.15566552048209869172, 0.20329151692109757067},
    // At its slowest it is still faster than (a+B) dt, so the clamp must not act.
    {"slow turn, B < a", 0.6, 0.0, 0.18, -0.5, 0.1, 2.0, 0.22752151996202854265, 0.081698381573312986494},
};

const std::vector<Arc> kSharpArcs{
    {"nearly collinear", 0.6, 0.0, 0.1, -1.0, 1e-3, 3.0, -0.096939019508888634701, 0.00134856854889587168},
    {"collinear but for 1e-9", 0.6, 0.0, 0.1, -1.0, 1e-9, 3.0, -0.096938775510204081878, 1.2503924096962026e-9},
    {"just before the stop", 0.3, 0.0, 0.5, 0.3, 0.4, 2.0, 0.39218754768189694192, 0.25932670873434878011},
    {"after the stop", 0.3, 0.0, 0.5, 0.3, 0.4, 2.5, 0.39375, 0.25934065934065934066},
};

double errorAt(const Experiment &ball, double x, double y) {
    return std::hypot(ball.state.position.x - x, ball.state.position.y - y);
}

/// Error of the position after an arc in n steps; NaN if a step failed.
double errorOf(const Arc &arc, const QByteArray &stepper, uint32_t model, int n) {
    Experiment ball(openFloor(4.0), stepper, model);
    ball.setLaw(arc.ax, arc.ay, arc.B);
    ball.roll(arc.vx, arc.vy);
    if (!ball.stepTimes(static_cast<uint64_t>(n), arc.duration / n)) return NAN;
    return errorAt(ball, arc.x, arc.y);
}

/// The scene of model.md 12.4.
SceneBuilder twoRooms() {
    return SceneBuilder()
        .ball(0.0625)
        .floor(-0.125, -0.125, 1.125, 1.125)
        .wall(-0.125, -0.125, 1.125, 0)
        .wall(-0.125, 1, 1.125, 1.125)
        .wall(-0.125, 0, 0, 1)
        .wall(1, 0, 1.125, 1)
        .wall(0.375, 0.3125, 0.625, 0.375)
        .wall(0.625, 0.3125, 0.6875, 0.6875)
        .start(0.25, 0.1875);
}

/// A moment of one of the two runs in that scene. `bound`: of the error divided by dt.
struct Moment {
    uint32_t model;
    double time, x, y, bound;
};

// Each impact displaces the ball by up to (1 + eps) v dt (model.md 10.2), 1.75 * 0.8 = 1.4 dt, and an edge also turns
// the velocity by v dt/R rad: as much again over a path of R. The table's growth is applied to both.
constexpr Moment kMoments[] = {
    {PHYS_MODEL_ROLLING, 1.0, 0.82070511008190482158, 0.17417049559190762784, 28 * 2.8 * 3},
    {PHYS_MODEL_ROLLING, 2.0, 0.63192707859375322016, 0.22464684569040922296, 28 * 2.8 * 5},
    {PHYS_MODEL_RIGID, 0.5, 0.56040776609906518374, 0.082903491788753747577, 28 * 2.8},
    {PHYS_MODEL_RIGID, 1.0, 0.92980422159598425993, 0.10078903386904098, 28 * 2.8 * 2},
};

} // namespace

class TestConvergence : public QObject {
    Q_OBJECT

private slots:
    void errorOfTheFirstCaseIsAsTabled_data();
    void errorOfTheFirstCaseIsAsTabled();
    void errorFallsWithThePromisedOrder_data();
    void errorFallsWithThePromisedOrder();
    void errorStaysWithinAnEnvelopeAtSharpTurnsAndStops_data();
    void errorStaysWithinAnEnvelopeAtSharpTurnsAndStops();
    void errorStaysWithinAnEnvelopeAcrossImpacts_data();
    void errorStaysWithinAnEnvelopeAcrossImpacts();
    void errorStaysWithinAnEnvelopeAcrossALanding_data();
    void errorStaysWithinAnEnvelopeAcrossALanding();
    void firstIntegralIsKeptToThePromisedOrder_data() { addStepperRows(); }
    void firstIntegralIsKeptToThePromisedOrder();
    void sweptKeepsItsOrderWhereASlipEndsInResistance();
    void threeCoplanarContactsDoNotSqueezeTheBall_data() { addStepperRows(); }
    void threeCoplanarContactsDoNotSqueezeTheBall();
    void sweptKeepsItsOrderWhereASlipEndsInAWedge();
    void sweptTurnsTheBallToSecondOrderAcrossImpacts_data();
    void sweptTurnsTheBallToSecondOrderAcrossImpacts();
};

void TestConvergence::errorOfTheFirstCaseIsAsTabled_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("digit");
    QTest::addColumn<double>("ratio");
    QTest::newRow("explicit-euler") << QByteArray("explicit-euler") << 6.015e-3 << 5e-7 << 2.0;
    QTest::newRow("symplectic-euler") << QByteArray("symplectic-euler") << 7.112e-3 << 5e-7 << 2.0;
    QTest::newRow("velocity-verlet") << QByteArray("velocity-verlet") << 1.317e-6 << 5e-10 << 4.0;
    QTest::newRow("rk4") << QByteArray("rk4") << 1.685e-12 << 5e-16 << 16.0;
}

void TestConvergence::errorOfTheFirstCaseIsAsTabled() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, error);
    QFETCH(double, digit);
    QFETCH(double, ratio);
    // model.md 12.3: dt = 2/n, n = 200 and 400. Roundings of positions up to 1 add up as a random walk at most.
    const double noise = rounding(std::sqrt(400.0) * 4.0, 1.0);
    const double coarse = errorOf(kFirst, stepper, PHYS_MODEL_ROLLING, 200);
    const double fine = errorOf(kFirst, stepper, PHYS_MODEL_ROLLING, 400);
    COMPARE_WITHIN(coarse, error, digit + noise);
    // The next term of the error is of relative size dt.
    COMPARE_WITHIN(fine, coarse / ratio, coarse / ratio * 0.01 + noise);
}

void TestConvergence::errorFallsWithThePromisedOrder_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<int>("arc");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (size_t arc = 0; arc < kArcs.size(); ++arc) {
                QTest::addRow("%s, %s, %s", id.constData(), modelName(model).constData(), kArcs[arc].name)
                    << id << model << static_cast<int>(arc);
            }
        }
    }
}

void TestConvergence::errorFallsWithThePromisedOrder() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(int, arc);
    const Arc &motion = kArcs[static_cast<size_t>(arc)];
    const int order = promiseOf(stepper).smooth;
    if (order == 0) {
        for (const int n : {1, 7, 100}) {
            QVERIFY(errorOf(motion, stepper, model, n) <= rounding(16.0 * n + 64.0, 1.0));
        }
        return;
    }
    // From the arc in 1/100 on, the next term of the error changes the ratio by less than a tenth.
    const double coarse = errorOf(motion, stepper, model, 100);
    const double fine = errorOf(motion, stepper, model, 200);
    const double noise = rounding(100.0, 1.0);
    COMPARE_WITHIN(fine, coarse * std::pow(2.0, -order), 0.1 * fine + noise);
}

void TestConvergence::errorStaysWithinAnEnvelopeAtSharpTurnsAndStops_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<int>("arc");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (size_t arc = 0; arc < kSharpArcs.size(); ++arc) {
                QTest::addRow("%s, %s, %s", id.constData(), modelName(model).constData(), kSharpArcs[arc].name)
                    << id << model << static_cast<int>(arc);
            }
        }
    }
}

void TestConvergence::errorStaysWithinAnEnvelopeAtSharpTurnsAndStops() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    QFETCH(int, arc);
    const Arc &motion = kSharpArcs[static_cast<size_t>(arc)];
    const bool isExact = promiseOf(stepper).smooth == 0;
    for (const int n : {100, 300, 1000, 3000}) {
        const double dt = motion.duration / n;
        const double error = errorOf(motion, stepper, model, n);
        // Euler: half a step of the change of velocity, at most |v| + a t/2 < 3 m/s, and half a step of the clamp
        // (10.5).
        const double bound = isExact ? rounding(16.0 * n + 64.0, 1.0) : 3.0 * dt;
        QVERIFY2(error <= bound, digits(error) + " above " + digits(bound));
    }
}

void TestConvergence::errorStaysWithinAnEnvelopeAcrossImpacts_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("moment");
    for (const QByteArray &id : stepperIds()) {
        for (size_t i = 0; i < std::size(kMoments); ++i) {
            QTest::addRow("%s, %s, %g s", id.constData(), modelName(kMoments[i].model).constData(), kMoments[i].time)
                << id << static_cast<int>(i);
        }
    }
}

void TestConvergence::errorStaysWithinAnEnvelopeAcrossImpacts() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, moment);
    const Moment &at = kMoments[moment];
    const int order = promiseOf(stepper).impacts;
    for (const int n : {512, 1000, 2048, 4000, 8192}) {
        Experiment ball(twoRooms(), stepper, at.model);
        ball.params.gravity = {0.5, -0.3125, -9.75};
        ball.params.restitution_wall = 0.75;
        ball.params.rolling_friction = at.model == PHYS_MODEL_ROLLING ? 0.01 : 0.0;
        ball.params.sliding_friction = 0.25;
        ball.roll(0.75, 0.5);
        const double dt = at.time / n;
        QVERIFY2(ball.stepTimes(static_cast<uint64_t>(n), dt), ball.error());
        const double error = errorAt(ball, at.x, at.y);
        // Second order: one more factor dt against the shortest time of the motion, R/v = 0.08 s.
        const double bound = order == 0   ? rounding(300.0 * n, 1.0)
                             : order == 1 ? at.bound * dt
                                          : at.bound * dt * dt / 0.08;
        QVERIFY2(error <= bound, "n = " + QByteArray::number(n) + ": " + digits(error) + " above " + digits(bound));
    }
}

void TestConvergence::errorStaysWithinAnEnvelopeAcrossALanding_data() { addStepperAndModelRows(); }

/// Without a rebound, on a slope: as in the air until it lands, rolling from then on.
void TestConvergence::errorStaysWithinAnEnvelopeAcrossALanding() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    constexpr double kDrive = 3.0, kHeight = 0.04, kEnd = 0.25;
    const double landing = std::sqrt(2.0 * kHeight / kNormalGravity);
    const double rest = kEnd - landing;
    // Friction of the landing: (2/7) of the slip goes into the spin, model.md 2.2 F3.
    const double rolling = kDrive * landing * (model == PHYS_MODEL_RIGID ? 5.0 / 7.0 : 1.0);
    const double end = 0.5 * kDrive * landing * landing + rolling * rest + 0.5 * 5.0 / 7.0 * kDrive * rest * rest;
    const int order = promiseOf(stepper).impacts;
    for (const int n : {256, 1000, 4096, 16000}) {
        Experiment ball(openFloor(4.0), stepper, model);
        ball.params.restitution_floor = 0.0;
        ball.params.sliding_friction = 0.75;
        ball.params.gravity = {kDrive, 0.0, -kNormalGravity};
        ball.state.position.z += kHeight;
        const double dt = kEnd / n;
        QVERIFY2(ball.stepTimes(static_cast<uint64_t>(n), dt), ball.error());
        // Half a step of the final speed, below 3/4 m/s, and up to a step more of flight, slip or rolling.
        const double bound = order == 1 ? 0.75 * dt : rounding(16.0 * n, 1.0);
        QVERIFY2(errorAt(ball, end, 0.0) <= bound,
                 "n = " + QByteArray::number(n) + ": " + digits(errorAt(ball, end, 0.0)) + " above " + digits(bound));
    }
}

void TestConvergence::firstIntegralIsKeptToThePromisedOrder() {
    QFETCH(QByteArray, stepper);
    // model.md 3.1: B|v| + A.v + (B^2 - a^2) t.
    const Arc &arc = kFirst;
    const auto integral = [](const phys_state &state) {
        const double speed = std::hypot(state.velocity.x, state.velocity.y);
        return arc.B * speed + arc.ax * state.velocity.x + arc.ay * state.velocity.y +
               (arc.B * arc.B - arc.ax * arc.ax - arc.ay * arc.ay) * state.time;
    };
    const int order = promiseOf(stepper).smooth;
    double worst[2] = {0.0, 0.0};
    for (const int level : {0, 1}) {
        Experiment ball(openFloor(4.0), stepper);
        ball.setLaw(arc.ax, arc.ay, arc.B);
        ball.roll(arc.vx, arc.vy);
        const double start = integral(ball.state);
        const int n = level == 0 ? 100 : 200;
        for (int i = 0; i < n; ++i) {
            QVERIFY2(ball.step(arc.duration / n), ball.error());
            worst[level] = std::max(worst[level], std::abs(integral(ball.state) - start));
        }
    }
    const double noise = rounding(order == 0 ? 4000.0 : 200.0, 1.0);
    if (order == 0) {
        QVERIFY(worst[1] <= noise);
        return;
    }
    COMPARE_WITHIN(worst[1], worst[0] * std::pow(2.0, -order), 0.1 * worst[1] + noise);
}

/// On the level: slips for 1/7 s, then rolls against resistance, model.md 3.6 and 3.2.
void TestConvergence::sweptKeepsItsOrderWhereASlipEndsInResistance() {
    const double slipEnd = 1.0 / 7.0, rollingSpeed = 5.0 / 7.0, drag = 5.0 / 7.0 * 0.0625 * support::kNormalGravity;
    const double rest = 1.0 - slipEnd;
    const double end = slipEnd - slipEnd * slipEnd + rollingSpeed * rest - 0.5 * drag * rest * rest;
    for (const int n : {32, 64, 128, 256}) {
        Experiment ball(openFloor(4.0), "swept", PHYS_MODEL_RIGID);
        ball.params.sliding_friction = 0.25;
        ball.params.rolling_friction = 0.0625;
        ball.state.velocity.x = 1.0;
        const double h = 1.0 / n;
        QVERIFY2(ball.stepTimes(static_cast<uint64_t>(n), h), ball.error());
        COMPARE_WITHIN(ball.state.position.x, end, 2.0 * h * h); // accelerations of 2 m/s^2
    }
}

/// A ball spins on a floor before a wall, and an edge above it touches it. Friction could keep the edge pressed, but
/// the smallest sum of reactions leaves it open.
void TestConvergence::threeCoplanarContactsDoNotSqueezeTheBall() {
    QFETCH(QByteArray, stepper);
    constexpr double kAcross = 0.96870431469610607, kUp = 0.24821754710162494; // to the edge
    const SceneBuilder notch = SceneBuilder()
                                   .ball(1.0)
                                   .box({{-2.75, -1.95, -3.5}, {0.7, 3.5, -1.0}})
                                   .box({{-2.9, -1.0, kUp}, {-kAcross, 2.4, 2.2}})
                                   .box({{1.0, -1.3, -2.7}, {4.6, 0.96, 3.2}})
                                   .start({0.0, 0.0, 0.0});
    const auto velocityAfterOne = [&](const QByteArray &id, int n) {
        Experiment ball(notch, id, PHYS_MODEL_RIGID);
        ball.params.gravity = {0.234, 0.588, -0.584};
        ball.params.sliding_friction = ball.params.wall_friction = 0.9;
        ball.state.spin = {0.28, 1.26, -0.756};
        return ball.stepTimes(static_cast<uint64_t>(n), 1.0 / n) ? ball.state.velocity.y : NAN;
    };
    constexpr int kSteps = 256;
    // The first order, of motions with sqrt(g/R) of about 1/s; a squeezed ball loses a fifth.
    COMPARE_WITHIN(velocityAfterOne(stepper, kSteps), velocityAfterOne("exact", 1), 1.0 / kSteps);
}

/// The ball rolls round an edge until it touches another above it. The slip there ends after 1.11 s; friction holds
/// both contacts until 1.45 s.
void TestConvergence::sweptKeepsItsOrderWhereASlipEndsInAWedge() {
    const SceneBuilder wedge = SceneBuilder()
                                   .ball(1.0)
                                   .box({{-2.55, -0.85, 2.55}, {0.0, 0.0, 3.4}})
                                   .box({{-1.7, -0.85, -1.7}, {-0.85, 5.1, 0.85}})
                                   .start({-1.95175484257472, 0.77400968329832598, 1.916826240151706});
    const auto positionAfter = [&](const QByteArray &stepper, int n, double duration) {
        Experiment ball(wedge, stepper, PHYS_MODEL_RIGID);
        ball.params.gravity = {0.024284201706799145, -0.2665238181515967, -1.0};
        ball.params.sliding_friction = ball.params.wall_friction = 0.7;
        ball.params.restitution_floor = ball.params.restitution_wall = 0.0;
        ball.state.spin.y = 0.18306576211797065;
        const bool isDone = ball.stepTimes(static_cast<uint64_t>(n), duration / n);
        return isDone ? ball.state.position : phys_vec3{NAN, NAN, NAN};
    };
    for (const double duration : {1.4, 2.4}) {
        const phys_vec3 truth = positionAfter("exact", 1, duration);
        for (const int n : {64, 128, 256, 512}) {
            const phys_vec3 end = positionAfter("swept", n, duration);
            const double off = std::hypot(end.x - truth.x, end.y - truth.y, end.z - truth.z);
            const double h = duration / n;
            // Of motions with sqrt(g/R) = 1/s for about 1 s.
            QVERIFY2(off <= 0.25 * h * h, "n = " + QByteArray::number(n) + ": " + digits(off));
        }
    }
}

void TestConvergence::sweptTurnsTheBallToSecondOrderAcrossImpacts_data() {
    QTest::addColumn<uint32_t>("model");
    QTest::newRow("rolling") << uint32_t{PHYS_MODEL_ROLLING};
    QTest::newRow("rigid") << uint32_t{PHYS_MODEL_RIGID};
}

/// A landing and hits on walls change the spin within the step.
void TestConvergence::sweptTurnsTheBallToSecondOrderAcrossImpacts() {
    QFETCH(uint32_t, model);
    const auto orientationAfter = [model](const QByteArray &stepper, int n, std::array<double, 4> &turned) {
        Experiment ball(twoRooms(), stepper, model);
        ball.params.options = PHYS_OPTION_ORIENTATION;
        ball.params.gravity = {0.5, -0.3125, -9.75};
        ball.params.sliding_friction = 0.25;
        ball.params.wall_friction = 0.25;
        ball.state.position.z += 0.01;
        ball.state.velocity = {0.75, 0.5, 0.0};
        ball.state.spin = {-4.0, 8.0, 2.0};
        const bool isDone = ball.stepTimes(static_cast<uint64_t>(n), 0.5 / n);
        std::copy(std::begin(ball.state.orientation), std::end(ball.state.orientation), turned.begin());
        return isDone;
    };
    std::array<double, 4> truth{}, turned{};
    QVERIFY(orientationAfter("exact", 8192, truth)); // between events, it takes the mean of the spin
    for (const int n : {50, 100, 200, 400, 800}) {
        QVERIFY(orientationAfter("swept", n, turned));
        double squared = 0.0;
        for (size_t i = 0; i < 4; ++i) squared += (turned[i] - truth[i]) * (turned[i] - truth[i]);
        const double h = 0.5 / n;
        // The spin of 12/s changes within 0.06 s.
        const double bound = 12.0 / 0.06 * h * h;
        QVERIFY2(std::sqrt(squared) <= bound, "n = " + QByteArray::number(n) + ": " + digits(std::sqrt(squared)));
    }
}

QTEST_GUILESS_MAIN(TestConvergence)
#include "tst_convergence.moc"
