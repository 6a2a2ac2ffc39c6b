// SPDX-License-Identifier: MIT
// The law of smooth motion, model.md 3 and 12.1; reference values by 50-digit integration.
#include "run.h"

#include <QtTest>

#include <cstring>

using exact::kU;
using exact::Run;

class ExactSmooth : public QObject {
    Q_OBJECT
private slots:
    void rollsByTheOneLaw_data();
    void rollsByTheOneLaw();
    void turnsWhereTheLawSays();
    void passesALineWhenTheLawSays();
    void slidesDownFasterThanItRolls();
    void firstIntegralIsLinearInTime();
    void restsUpToTheStictionLimit();
    void stopIsReported();
    void turnsTheBallByAFourthOrderRule();
    void undisturbedStepsHaveTheBitsOfAllStages_data();
    void undisturbedStepsHaveTheBitsOfAllStages();
};

namespace {

Run onPlane(double vx, double vy) {
    return Run({exact::floorOver(-8, -8, 8, 8)}, 0.005, {0.0, 0.0, 0.005}, {vx, vy, 0.0});
}

} // namespace

void ExactSmooth::rollsByTheOneLaw_data() {
    for (const char *column : {"Ax", "Ay", "B", "vx0", "vy0", "t", "x", "y", "vx", "vy"}) {
        QTest::addColumn<double>(column);
    }
    QTest::newRow("general") << -0.6 << 0.2 << 0.1 << 1.0 << 0.3 << 2.0 << 0.66173608811146707468
                             << 0.87942790288305788119 << -0.2858062173128988405 << 0.55324339727446848366;
    QTest::newRow("before the stop") << 0.3 << 0.0 << 0.5 << 0.3 << 0.4 << 2.0 << 0.39218754768189694192
                                     << 0.25932670873434878011 << 0.024998092767772740313 << 0.00039061009991873354237;
    QTest::newRow("after the stop") << 0.3 << 0.0 << 0.5 << 0.3 << 0.4 << 3.0 << 0.39375 << 118.0 / 455.0 << 0.0 << 0.0;
    QTest::newRow("B = a") << 0.5 << 0.0 << 0.5 << 0.3 << 0.4 << 1.0 << 0.35916183820371143944 << 0.24322536933179607531
                           << 0.38972731457307217065 << 0.12820412116263863286;
    QTest::newRow("B = a/2") << 1.0 << 0.0 << 0.5 << -0.3 << 0.4 << 1.0 << 0.15566552048209869172
                             << 0.20329151692109757067 << 0.46406458408687624136 << 0.085475983320868191356;
    QTest::newRow("turns sharply") << 0.6 << 0.0 << 0.1 << -1.0 << 1e-3 << 3.0 << -0.096939019508888634701
                                   << 0.00134856854889587168 << 0.78571435691392264752 << 5.0180506683212242e-5;
    QTest::newRow("turns in a point") << 0.6 << 0.0 << 0.1 << -1.0 << 1e-9 << 3.0 << -0.096938775510204081878
                                      << 1.2503924096962026e-9 << 0.78571428571428571436 << 1.9977220897587365e-13;
    QTest::newRow("comes straight back") << 0.6 << 0.0 << 0.1 << -1.0 << 0.0 << 3.0 << -19.0 / 196.0 << 0.0
                                         << 11.0 / 14.0 << 0.0;
}

void ExactSmooth::rollsByTheOneLaw() {
    QFETCH(double, Ax);
    QFETCH(double, Ay);
    QFETCH(double, B);
    QFETCH(double, vx0);
    QFETCH(double, vy0);
    QFETCH(double, t);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, vx);
    QFETCH(double, vy);
    Run run = onPlane(vx0, vy0);
    run.setLaw(Ax, Ay, B);
    run.step(t);
    // 4 rounding steps of a length and a speed near 1.
    QVERIFY2(exact::difference(run.state, x, y, vx, vy) <= 4.0 * kU,
             qPrintable(QString::number(exact::difference(run.state, x, y, vx, vy))));
    QVERIFY(std::abs(run.report.energy_scheme) <= 4.0 * kU);
}

void ExactSmooth::turnsWhereTheLawSays() {
    Run run = onPlane(1.0, 0.3);
    run.setLaw(-0.6, 0.2, 0.1);
    run.step(1.5025929949748232238);
    QVERIFY(std::abs(run.state.velocity.x) <= 4.0 * kU);
    QVERIFY(std::abs(run.state.position.x - 0.73376498961294433082) <= 4.0 * kU);
}

void ExactSmooth::passesALineWhenTheLawSays() {
    Run run = onPlane(1.0, 0.3);
    run.setLaw(-0.6, 0.2, 0.1);
    run.step(0.64329974917404627696);
    QVERIFY(exact::difference(run.state, 0.5, 0.22667762861574120012, 0.55600733251066195495, 0.40154858458623945989) <=
            4.0 * kU);
}

void ExactSmooth::turnsTheBallByAFourthOrderRule() {
    // At most a quarter of a radian per step, on a curved path; 1 - |cosine of half the angle| is its square.
    const auto turned = [](int steps) {
        Run run({exact::floorOver(-8, -8, 8, 8)}, 0.5, {0, 0, 0.5}, {0.5, 1, 0});
        run.setLaw(1.0, 0.0, 0.25);
        run.params.options = PHYS_OPTION_ORIENTATION;
        for (int step = 0; step < steps; ++step) run.step(1.0 / steps);
        return run.state;
    };
    const phys_state best = turned(1024);
    const auto error = [&](int steps) {
        const phys_state state = turned(steps);
        const double *a = best.orientation, *b = state.orientation;
        return std::hypot(a[3] * b[0] - a[0] * b[3] + a[2] * b[1] - a[1] * b[2],
                          a[3] * b[1] - a[1] * b[3] + a[0] * b[2] - a[2] * b[0],
                          a[3] * b[2] - a[2] * b[3] + a[1] * b[0] - a[0] * b[1]);
    };
    const double coarse = error(8), fine = error(16);
    QVERIFY2(coarse / fine > 15.0 && coarse / fine < 17.0, qPrintable(QString::number(coarse / fine)));
}

void ExactSmooth::undisturbedStepsHaveTheBitsOfAllStages_data() {
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<double>("pull"); // along x
    QTest::addColumn<double>("vx");
    QTest::addColumn<double>("resistance");
    QTest::addColumn<double>("friction");
    const struct {
        const char *name;
        uint32_t model;
        double resistance, friction;
    } laws[] = {{"rolling", PHYS_MODEL_ROLLING, 0.0625, 0.3},
                {"rolling without resistance", PHYS_MODEL_ROLLING, 0.0, 0.3},
                {"rigid", PHYS_MODEL_RIGID, 0.0625, 0.3},
                {"rigid without resistance", PHYS_MODEL_RIGID, 0.0, 0.3},
                {"gliding", PHYS_MODEL_RIGID, 0.0, 0.0}};
    for (const auto &[name, model, resistance, friction] : laws) {
        QTest::addRow("%s, freely", name) << model << -0.5 << -0.1 << resistance << friction;
        QTest::addRow("%s, straight against the pull", name) << model << 0.125 << -0.25 << resistance << friction;
        QTest::addRow("%s, along a wall", name) << model << 0.5 << 0.0 << resistance << friction;
        QTest::addRow("%s, off a wall", name) << model << -0.5 << 0.0 << resistance << friction;
        QTest::addRow("%s, back to a wall again and again", name) << model << 8.0 << -0.25 << resistance << friction;
    }
}

void ExactSmooth::undisturbedStepsHaveTheBitsOfAllStages() {
    QFETCH(uint32_t, model);
    QFETCH(double, pull);
    QFETCH(double, vx);
    QFETCH(double, resistance);
    QFETCH(double, friction);
    phys_state states[2];
    for (const uint32_t options : {0U, uint32_t(PHYS_OPTION_ALL_STAGES)}) {
        Run run({exact::kFloor, exact::wall(0.25, -2, 0.5, 2)}, 0.125, {0.125, 0, 0.125}, {vx, 0.25, 0});
        run.params.model = model;
        run.params.options = options | PHYS_OPTION_ORIENTATION;
        run.setLaw(pull, -0.125, resistance);
        run.params.sliding_friction = friction;
        run.state.spin = {0.0 - 0.25 / 0.125, vx / 0.125, -0.0};
        for (int i = 0; i < 16; ++i) run.step(1.0 / 64.0);
        states[options ? 1 : 0] = run.state;
    }
    QVERIFY(std::memcmp(&states[0], &states[1], sizeof states[0]) == 0);
}

void ExactSmooth::slidesDownFasterThanItRolls() {
    // From rest through a height of 0.1 m: sqrt(2 g h) without friction, sqrt(10/7 g h) rolling.
    const double slope = 0.1, length = 0.1 / std::sin(slope);
    const auto speedBelow = [&](uint32_t model, double share) {
        Run run = onPlane(0.0, 0.0);
        run.params.model = model;
        run.params.sliding_friction = 0.0;
        phys_gravity_from_tilt(slope, 0.0, 9.81, &run.params.gravity);
        run.step(std::sqrt(2.0 * length / (share * run.params.gravity.x)));
        return run.state.velocity.x;
    };
    QVERIFY(std::abs(speedBelow(PHYS_MODEL_RIGID, 1.0) - 1.400714103591450242) <= 8.0 * kU);
    QVERIFY(std::abs(speedBelow(PHYS_MODEL_ROLLING, 5.0 / 7.0) - 1.183819484308554295) <= 8.0 * kU);
}

void ExactSmooth::firstIntegralIsLinearInTime() {
    // model.md 3.1: B|v| + A.v falls by (B^2 - a^2) t, whatever the path.
    const double Ax = -0.6, Ay = 0.2, B = 0.1;
    Run run = onPlane(1.0, 0.3);
    run.setLaw(Ax, Ay, B);
    const auto integral = [&] {
        const phys_vec3 &v = run.state.velocity;
        return B * std::hypot(v.x, v.y) + Ax * v.x + Ay * v.y;
    };
    const double start = integral();
    for (const double t : {0.125, 0.25, 0.5, 1.0, 2.0}) {
        run.state = phys_state{.time = 0.0,
                               .step = 0,
                               .position = {0.0, 0.0, 0.005},
                               .velocity = {1.0, 0.3, 0.0},
                               .spin = {},
                               .orientation = {0.0, 0.0, 0.0, 1.0},
                               .flags = 0};
        run.step(t);
        QVERIFY(std::abs(integral() - (start - (B * B - Ax * Ax - Ay * Ay) * t)) <= 4.0 * kU);
    }
}

void ExactSmooth::restsUpToTheStictionLimit() {
    // model.md 2.1 R4: at rest while |g_t| <= mu_r gn, including the limit.
    Run run = onPlane(0.0, 0.0);
    run.params.rolling_friction = 0.003;
    run.params.gravity = {0.003 * 9.81, 0.0, -9.81};
    run.step(100.0);
    QCOMPARE(run.state.position.x, 0.0);
    QVERIFY(run.state.flags & PHYS_AT_REST);
    run.params.gravity.x *= 1.0 + 4.0 * kU;
    run.step(100.0);
    QVERIFY(run.state.position.x > 0.0);
}

void ExactSmooth::stopIsReported() {
    Run run = onPlane(0.3, 0.4);
    run.setLaw(0.3, 0.0, 0.5);
    run.step(3.0);
    QCOMPARE(run.events.size(), size_t(1));
    QCOMPARE(run.events[0].kind, uint32_t(PHYS_EVENT_STOP));
    QVERIFY(std::abs(run.events[0].time - 2.125) <= 8.0 * kU);
    QVERIFY(run.state.flags & PHYS_AT_REST);
}

QTEST_GUILESS_MAIN(ExactSmooth)
#include "tst_exact_smooth.moc"
