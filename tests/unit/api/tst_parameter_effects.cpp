// SPDX-License-Identifier: MIT
// Each parameter has the effect that its row describes, in that direction and under every stepper.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <vector>

using namespace support;

namespace {

constexpr double kEffectDt = 1.0 / 256.0;

SceneBuilder wallAtTheLeft() { return openFloor(10.0).wall(-5, -10, 0, 10).start(0.5, 0.0); }

/// The result of a run with one parameter at a value; NaN if a step failed.
using Figure = std::function<double(Experiment &)>;

struct Effect {
    const char *row;
    const char *name;
    uint32_t model;
    double low, high; ///< two values of the parameter
    int direction;    ///< +1: the outcome grows with the parameter; -1: it shrinks; 0: it must not change at all
    Figure outcome;
};

double runFor(Experiment &ball, double duration, double phys_vec3::*component, phys_vec3 phys_state::*member) {
    return ball.stepFor(duration, kEffectDt) ? ball.state.*member.*component : NAN;
}

double speedBackFromTheWall(Experiment &ball) {
    ball.roll(-1.0, 0.0);
    return runFor(ball, 1.0, &phys_vec3::x, &phys_state::velocity);
}

double heightOfABounce(Experiment &ball) {
    ball.state.position.z += 0.125;
    double highest = 0.0;
    bool landed = false;
    for (int i = 0; i < 256; ++i) {
        if (!ball.step(kEffectDt)) return NAN;
        landed = landed || ball.state.velocity.z > 0.0 || !(ball.state.flags & PHYS_AIRBORNE);
        if (landed) highest = std::max(highest, ball.state.position.z);
    }
    return highest;
}

double wayUntilItStops(Experiment &ball) {
    ball.roll(0.25, 0.0);
    return runFor(ball, 20.0, &phys_vec3::x, &phys_state::position);
}

double timeUntilItRolls(Experiment &ball) {
    ball.state.velocity = {0.5, 0.0, 0.0};
    for (int i = 0; i < 2000; ++i) {
        if (!ball.step(kEffectDt)) return NAN;
        if (!(ball.state.flags & PHYS_SLIPPING)) return ball.state.time;
    }
    return NAN;
}

double liftAtAWall(Experiment &ball) {
    ball.setPosition(0.0625 + kEffectDt / 2.0, 0.0);
    ball.roll(-1.0, 0.5);
    return runFor(ball, kEffectDt, &phys_vec3::z, &phys_state::velocity);
}

double speedAlongX(Experiment &ball) { return runFor(ball, 0.5, &phys_vec3::x, &phys_state::velocity); }
double speedAlongY(Experiment &ball) { return runFor(ball, 0.5, &phys_vec3::y, &phys_state::velocity); }

double spinBackFromTheWall(Experiment &ball) {
    ball.params.sliding_friction = 0.0;
    ball.params.rolling_friction = 0.0;
    ball.params.restitution_wall = 0.5;
    ball.roll(-1.0, 0.0);
    return runFor(ball, 0.75, &phys_vec3::y, &phys_state::spin);
}

const std::vector<Effect> kEffects{
    {"model", "the rigid ball keeps its spin at a wall", PHYS_MODEL_ROLLING, 0, 1, -1, spinBackFromTheWall},
    {"restitution_wall", "more speed back", PHYS_MODEL_ROLLING, 0.25, 0.75, 1, speedBackFromTheWall},
    {"restitution_wall", "more speed back, rigid", PHYS_MODEL_RIGID, 0.25, 0.75, 1, speedBackFromTheWall},
    {"restitution_floor", "a higher bounce", PHYS_MODEL_ROLLING, 0.25, 0.75, 1, heightOfABounce},
    {"restitution_floor", "a higher bounce, rigid", PHYS_MODEL_RIGID, 0.25, 0.75, 1, heightOfABounce},
    {"rolling_friction", "a shorter way", PHYS_MODEL_ROLLING, 0.005, 0.01, -1, wayUntilItStops},
    {"rolling_friction", "a shorter way, rigid", PHYS_MODEL_RIGID, 0.005, 0.01, -1, wayUntilItStops},
    {"sliding_friction", "slip ends sooner", PHYS_MODEL_RIGID, 0.05, 0.2, -1, timeUntilItRolls},
    {"sliding_friction", "nothing in the rolling model", PHYS_MODEL_ROLLING, 0.05, 0.2, 0, speedBackFromTheWall},
    {"wall_friction", "lifts the ball", PHYS_MODEL_RIGID, 0.0, 0.1, 1, liftAtAWall},
    {"wall_friction", "nothing in the rolling model", PHYS_MODEL_ROLLING, 0.0, 0.1, 0, liftAtAWall},
    {"gravity_x", "pulls along x", PHYS_MODEL_ROLLING, -0.5, 0.5, 1, speedAlongX},
    {"gravity_y", "pulls along y", PHYS_MODEL_ROLLING, -0.5, 0.5, 1, speedAlongY},
    {"gravity_x", "nothing along y", PHYS_MODEL_ROLLING, -0.5, 0.5, 0, speedAlongY},
    {"gravity_z", "presses: less of it, less resistance", PHYS_MODEL_ROLLING, -16.0, -4.0, 1, wayUntilItStops},
};

const phys_param_row *rowWithId(const char *id) {
    uint32_t count = 0;
    const phys_param_row *const rows = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) {
        if (std::strcmp(rows[i].id, id) == 0) return rows + i;
    }
    return nullptr;
}

} // namespace

class TestParameterEffects : public QObject {
    Q_OBJECT

private slots:
    void parameterHasItsEffect_data();
    void parameterHasItsEffect();
    void everyRowIsCovered();
    void effectNeedsNoReport_data() { parameterHasItsEffect_data(); }
    void effectNeedsNoReport();
    void asReportedTakesSubstepsAway_data();
    void asReportedTakesSubstepsAway();
    void orientationTurnsOnlyWhenAskedFor_data() { addStepperAndModelRows(); }
    void orientationTurnsOnlyWhenAskedFor();
};

void TestParameterEffects::parameterHasItsEffect_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("effect");
    for (const QByteArray &id : stepperIds()) {
        for (size_t i = 0; i < kEffects.size(); ++i) {
            QTest::addRow("%s, %s: %s", id.constData(), kEffects[i].row, kEffects[i].name) << id << static_cast<int>(i);
        }
    }
}

void TestParameterEffects::parameterHasItsEffect() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, effect);
    const Effect &expected = kEffects[static_cast<size_t>(effect)];
    const phys_param_row *const row = rowWithId(expected.row);
    QVERIFY(row);
    double outcomes[2] = {};
    for (const int i : {0, 1}) {
        Experiment ball(wallAtTheLeft(), stepper, expected.model);
        ball.params.rolling_friction = 0.005;
        QCOMPARE(phys_param_set(&ball.params, row, i == 0 ? expected.low : expected.high, nullptr), PHYS_OK);
        outcomes[i] = expected.outcome(ball);
        if (std::isnan(outcomes[i]) && ball.status() == PHYS_ERROR_UNSUPPORTED) QSKIP(ball.error());
        QVERIFY2(!std::isnan(outcomes[i]), ball.error());
    }
    if (expected.direction == 0) COMPARE_EXACT(outcomes[1], outcomes[0]);
    // An effect must exceed one per mille.
    else
        QVERIFY((outcomes[1] - outcomes[0]) * expected.direction > 1e-3 * std::abs(outcomes[0]));
}

void TestParameterEffects::everyRowIsCovered() {
    uint32_t count = 0;
    const phys_param_row *const rows = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) {
        const bool covered = std::any_of(kEffects.begin(), kEffects.end(), [&](const Effect &effect) {
            return effect.direction != 0 && std::strcmp(effect.row, rows[i].id) == 0;
        });
        QVERIFY2(covered, rows[i].id);
    }
}

/// Steps without a report may take a shorter way, which has to know the parameter as well.
void TestParameterEffects::effectNeedsNoReport() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, effect);
    const Effect &expected = kEffects[static_cast<size_t>(effect)];
    Experiment reported(wallAtTheLeft(), stepper, expected.model);
    Experiment silent(wallAtTheLeft(), stepper, expected.model);
    for (Experiment *ball : {&reported, &silent}) {
        QCOMPARE(phys_param_set(&ball->params, rowWithId(expected.row), expected.high, nullptr), PHYS_OK);
        ball->roll(-1.0, 0.25);
    }
    phys_state &state = silent.state;
    for (int i = 0; i < 256; ++i) {
        reported.step(kEffectDt);
        QCOMPARE(phys_step(silent.stepper(), &silent.params, kEffectDt, &state, &state, nullptr, nullptr),
                 reported.status());
        if (reported.status()) return;
        QVERIFY(sameBits(state, reported.state));
    }
}

void TestParameterEffects::asReportedTakesSubstepsAway_data() {
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &id : discreteStepperIds()) QTest::newRow(id.constData()) << id;
}

void TestParameterEffects::asReportedTakesSubstepsAway() {
    QFETCH(QByteArray, stepper);
    for (const bool asReported : {false, true}) {
        Experiment ball(openFloor().wall(1.25, -1.0, 1.3125, 1.0), stepper);
        ball.params.stepper[0] = asReported ? 1.0 : 0.0;
        ball.roll(64.0, 0.0);
        QVERIFY2(ball.stepTimes(2, 1.0 / 64.0), ball.error());
        QCOMPARE(ball.state.position.x > 1.25, asReported);
    }
}

void TestParameterEffects::orientationTurnsOnlyWhenAskedFor() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Experiment with(wallAtTheLeft(), stepper, model);
    Experiment without(wallAtTheLeft(), stepper, model);
    with.params.options = PHYS_OPTION_ORIENTATION;
    for (Experiment *ball : {&with, &without}) {
        ball->setLaw(-0.5, 0.25);
        ball->roll(0.25, 0.5);
    }
    for (int i = 0; i < 500; ++i) {
        QVERIFY2(with.step(kEffectDt), with.error());
        QVERIFY2(without.step(kEffectDt), without.error());
        const phys_state before = without.state;
        phys_state moved = with.state;
        std::memcpy(moved.orientation, before.orientation, sizeof moved.orientation);
        QVERIFY(sameBits(moved, before));
    }
    COMPARE_EXACT(without.state.orientation[3], 1.0);
    QVERIFY(with.state.orientation[3] != 1.0);
}

QTEST_GUILESS_MAIN(TestParameterEffects)
#include "tst_parameter_effects.moc"
