// SPDX-License-Identifier: MIT
// Every state that a step returns with PHYS_OK is valid input for the next step, also with the largest numbers.
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <cstring>

using namespace support;

namespace {

constexpr double kLargest = 0x1p100;

struct RangeEnd {
    const char *name;
    double dt;
    void (*set)(Experiment &);
};

constexpr RangeEnd kExtremes[] = {
    {"the longest step", kLargest, [](Experiment &ball) { ball.state.velocity.x = 1.0; }},
    {"the highest speed", 10.0, [](Experiment &ball) { ball.state.velocity.x = kLargest; }},
    {"the furthest place", 1e10,
     [](Experiment &ball) {
         ball.state.position.x = kLargest;
         ball.state.velocity.x = 1e20;
     }},
    {"the strongest gravity", 1e20,
     [](Experiment &ball) {
         ball.params.gravity = {1e6, 1e6, -1e6};
     }},
    {"the fastest spin", 10.0,
     [](Experiment &ball) {
         ball.state.spin = {0.0, -kLargest, 0.0};
         ball.params.options = PHYS_OPTION_ORIENTATION;
     }},
    {"the latest time", 0.5 * kLargest, [](Experiment &ball) { ball.state.time = 0.999 * kLargest; }},
};

} // namespace

class TestStepRange : public QObject {
    Q_OBJECT

private slots:
    void resultIsAStateOrAStatus_data() {
        QTest::addColumn<QByteArray>("stepper");
        QTest::addColumn<int>("extreme");
        for (const QByteArray &stepper : stepperIds()) {
            for (int i = 0; i < static_cast<int>(std::size(kExtremes)); ++i) {
                QTest::addRow("%s, %s", stepper.constData(), kExtremes[i].name) << stepper << i;
            }
        }
    }
    void resultIsAStateOrAStatus();

    void argumentsAreCheckedThatDifferFromThoseBefore_data() { addStepperRows(); }
    void argumentsAreCheckedThatDifferFromThoseBefore();
    void argumentsOfTheFirstStepAreChecked_data() { addStepperRows(); }
    void argumentsOfTheFirstStepAreChecked();
};

void TestStepRange::resultIsAStateOrAStatus() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, extreme);
    Experiment ball(SceneBuilder().start({0, 0, 0}), stepper);
    kExtremes[extreme].set(ball);
    const phys_state before = ball.state;
    if (ball.step(kExtremes[extreme].dt)) {
        QVERIFY2(ball.step(0.0), ball.error()); // which checks the state
        return;
    }
    QVERIFY(QByteArray(ball.error()).contains("2^100"));
    QCOMPARE(std::memcmp(&ball.state, &before, sizeof before), 0);
}

void TestStepRange::argumentsAreCheckedThatDifferFromThoseBefore() {
    QFETCH(QByteArray, stepper);
    Experiment ball(SceneBuilder().start({0, 0, 0}), stepper);
    const phys_params good = ball.params;
    for (int i = 0; i < 2; ++i) QVERIFY2(ball.step(0.01), ball.error());
    for (double phys_params::*member : {&phys_params::restitution_wall, &phys_params::rolling_friction}) {
        ball.params.*member = -1.0;
        QVERIFY(!ball.step(0.01));
        ball.params = good;
        QVERIFY2(ball.step(0.01), ball.error());
    }
    QVERIFY(!ball.step(-0.01));
    QVERIFY2(ball.step(0.01), ball.error());
}

/// Zeros are what a stepper might begin with.
void TestStepRange::argumentsOfTheFirstStepAreChecked() {
    QFETCH(QByteArray, stepper);
    Experiment ball(SceneBuilder().start({0, 0, 0}), stepper);
    ball.params = {};
    QVERIFY(!ball.step(0.0));
}

QTEST_GUILESS_MAIN(TestStepRange)
#include "tst_step_range.moc"
