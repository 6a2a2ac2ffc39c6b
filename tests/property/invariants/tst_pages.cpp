// SPDX-License-Identifier: MIT
// Statements of docs/accuracy.md on all inputs that no other suite tests with random ones, and tables of steppers.
#include "support/effort.h"
#include "support/experiment.h"
#include "support/files.h"
#include "support/random.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <cmath>

using namespace support;

namespace {

uint64_t draws() { return effort(20, 200, 10'000); }

/// Gravity on a board tilted by this angle (rad) in this direction.
phys_vec3 tilted(double tilt, double direction) {
    return {9.81 * std::sin(tilt) * std::cos(direction), 9.81 * std::sin(tilt) * std::sin(direction),
            -9.81 * std::cos(tilt)};
}

} // namespace

class TestPages : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(testSeed())); }
    void modelsAgreeWhileFrictionHolds_data() { addStepperRows(); }
    void modelsAgreeWhileFrictionHolds();
    void smoothWallLeavesLessOfTheSpeedToABallThatRollsAgain_data() { addStepperRows(); }
    void smoothWallLeavesLessOfTheSpeedToABallThatRollsAgain();
    void wayBelowHalfARoundingIsNone_data() { addStepperAndModelRows(); }
    void wayBelowHalfARoundingIsNone();
    void tableHasEachStepper_data();
    void tableHasEachStepper();
};

/// Between impacts both models are the same while tan(tilt) <= 7/2 of the sliding friction.
void TestPages::modelsAgreeWhileFrictionHolds() {
    QFETCH(QByteArray, stepper);
    Random draw(testSeed());
    for (uint64_t i = 0; i < draws(); ++i) {
        Experiment rolling(openFloor(), stepper, PHYS_MODEL_ROLLING);
        Experiment rigid(openFloor(), stepper, PHYS_MODEL_RIGID);
        const double friction = draw.between(0.02, 0.6);
        const double resistance = draw.between(0.0, 0.02);
        const phys_vec3 gravity = tilted(std::atan(3.5 * friction) * draw.between(0.0, 1.0), draw.between(0.0, 6.28));
        const phys_vec3 velocity{draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), 0.0};
        for (Experiment *ball : {&rolling, &rigid}) {
            ball->params.sliding_friction = friction;
            ball->params.rolling_friction = resistance;
            ball->params.gravity = gravity;
            ball->roll(velocity.x, velocity.y);
            QVERIFY2(ball->stepTimes(20, 0.01), ball->error());
        }
        const double apart = std::hypot(rolling.state.position.x - rigid.state.position.x,
                                        rolling.state.position.y - rigid.state.position.y);
        QVERIFY2(apart <= 1e-12, qPrintable(QString("draw %1: %2 m apart").arg(i).arg(apart)));
    }
}

/// A ball that rolls into a smooth wall rolls off it with (5 eps - 2)/7 of its normal speed, at 2/5 or more.
void TestPages::smoothWallLeavesLessOfTheSpeedToABallThatRollsAgain() {
    QFETCH(QByteArray, stepper);
    Random draw(testSeed());
    for (uint64_t i = 0; i < draws(); ++i) {
        Experiment ball(openFloor().wall(1, -100, 2, 100), stepper, PHYS_MODEL_RIGID);
        const double restitution = draw.between(0.45, 1.0);
        const double speed = draw.between(0.2, 2.0);
        ball.params.restitution_wall = restitution;
        ball.params.rolling_friction = 0.0;
        ball.params.sliding_friction = draw.between(0.05, 1.0);
        ball.setPosition(0.5, 0.0);
        ball.roll(speed, draw.between(-2.0, 2.0));
        for (int step = 0; step < 1000 && (ball.state.velocity.x > 0 || ball.state.flags & PHYS_SLIPPING); ++step)
            QVERIFY2(ball.step(0.02), ball.error());
        const double off = ball.state.velocity.x + (5.0 * restitution - 2.0) / 7.0 * speed;
        QVERIFY2(std::abs(off) <= 1e-9 * speed, qPrintable(QString("draw %1: %2 m/s off").arg(i).arg(off)));
    }
}

/// Between 1 and 2 m, a step that would move the ball by less than 2^-53 m doesn't move it.
void TestPages::wayBelowHalfARoundingIsNone() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random draw(testSeed());
    for (uint64_t i = 0; i < draws(); ++i) {
        Experiment ball(openFloor(), stepper, model);
        const double dt = draw.between(1e-4, 1e-2);
        const double start = draw.between(1.0, 2.0);
        const bool isSmall = draw.below(2) == 0;
        const double way = kUnit * (isSmall ? draw.between(0.1, 0.99) : draw.between(1.01, 2.0));
        ball.setPosition(start, 0.0);
        ball.roll(way / dt, 0.0);
        QVERIFY2(ball.step(dt), ball.error());
        QCOMPARE(ball.state.position.x == start, isSmall);
    }
}

void TestPages::tableHasEachStepper_data() {
    QTest::addColumn<QByteArray>("page");
    QTest::addColumn<QByteArray>("cells");
    const auto row = [](const char *page, const QByteArray &cells) {
        QTest::addRow("%s: %s", page, cells.trimmed().constData()) << QByteArray(page) << cells;
    };
    for (const QByteArray &id : stepperIds()) {
        row("README.md", "| `" + id + "` |");
        row("libphysics/docs/accuracy.md", "\n| `" + id + "` |");
        row("libphysics/docs/model.md", "\n| `" + id + "` |");
    }
    row("libphysics/README.md", "\n| case | " + stepperIds().join(" | ") + " |\n"); // by extremes_table
}

void TestPages::tableHasEachStepper() {
    QFETCH(QByteArray, page);
    QFETCH(QByteArray, cells);
    QVERIFY(contentOf(PROJECT_FOLDER "/" + page).contains(cells));
}

QTEST_GUILESS_MAIN(TestPages)
#include "tst_pages.moc"
