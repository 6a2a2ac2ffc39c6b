// SPDX-License-Identifier: MIT
// The ghost, stepped manually: it starts at the ball, gets the same inputs, and never affects the ball.
#include "core/engine/ghost_engine.h"
#include "inspector/core/scenes.h"
#include "support/compare.h"
#include "support/stepper_rows.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace inspector;

class TestGhostEngine : public QObject {
    Q_OBJECT

private slots:
    void sameStepperStaysOnTheBall_data();
    void sameStepperStaysOnTheBall();
    void ghostIsWhatTheLibraryComputes_data();
    void ghostIsWhatTheLibraryComputes();
    void deviationIsThatOfBothStates();
    void deviationOfEulerIsThatOfTheory();
    void finerStepsEndAtTheSameTime_data();
    void finerStepsEndAtTheSameTime();
    void meetingPutsItOntoTheBall();
    void meetingGoesOnAsFromThere();
    void stepSizeOfTheBallCanChange();
    void sameStepperObeysTheBallsOwnValues();
    void otherStepperHasInitialOwnValues();
    void ownParametersAreObeyed();
    void tiltIsTheBallsWhateverItsOwnParameters();
    void ownParametersThatAreTheBallsKeepItOnTheBall();
    void refusalEndsItUntilTheNextMeeting();
    void refusalLeavesTheBallAlone();
    void missingStepperGivesOneLine();
    void sceneThatTheStepperCantDoGivesOneLine();

private:
    QString m_error;
};

namespace {

const Registry &registry() {
    static const Registry made = makeRegistry(nullptr);
    return made;
}

Engine ballOf(const Scene &scene, const QByteArray &id) { return {scene, makeStepper(registry(), id, scene, nullptr)}; }

GhostEngine ghostOf(const Engine &ball, const GhostChoice &ghostChoice, const QByteArray &ballsId) {
    QString error;
    const auto setup = makeGhostSetup(registry(), ghostChoice, ball.scene(), &error);
    if (!setup) qFatal("%s", qPrintable(error));
    return {ball, *setup, ballsId};
}

// Tilts depending on the position: both balls would get different tilts if each had its own pilot.
class PlacePilot : public Pilot {
public:
    Tilt tilt(const phys_state &state, double) const override {
        return {radians(8.0 * std::sin(200.0 * state.position.x)), radians(8.0 * std::cos(130.0 * state.position.y))};
    }
};

// A floor of 0.1 m between four walls.
Scene bareRoom() {
    const phys_box boxes[] = {{{-0.05, -0.05, -0.01}, {0.05, 0.05, 0.0}},
                              {{-0.06, -0.05, -0.01}, {-0.05, 0.05, 0.02}},
                              {{0.05, -0.05, -0.01}, {0.06, 0.05, 0.02}},
                              {{-0.06, -0.06, -0.01}, {0.06, -0.05, 0.02}},
                              {{-0.06, 0.05, -0.01}, {0.06, 0.06, 0.02}}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes;
    description.box_count = 5;
    return makeScene(description, nullptr);
}

// A long floor with a wall at its end, for which a discrete stepper must look in every step.
Scene longFloor() {
    const phys_box boxes[] = {{{-1.0, -1.0, -0.01}, {1e5, 1.0, 0.0}}, {{99999.0, -1.0, 0.0}, {1e5, 1.0, 0.02}}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes;
    description.box_count = 2;
    return makeScene(description, nullptr);
}

// In steps of 10 s and from 0 to 700 m/s: more than 3 km a step are too many substeps of half a radius for an Euler.
Engine fastBall() {
    Engine ball = ballOf(longFloor(), "exact");
    ball.setInputs(tilted(30.0, 0.0));
    ball.setDt(10.0);
    return ball;
}
constexpr int kFastSteps = 15; // the ball hasn't reached the end of the floor then

} // namespace

void TestGhostEngine::sameStepperStaysOnTheBall_data() { support::addStepperAndModelRows(); }

void TestGhostEngine::sameStepperStaysOnTheBall() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Engine ball = ballOf(bareRoom(), stepper);
    phys_state state = ball.state();
    state.velocity = {0.7, 0.4, 0.0};
    ball.setState(state);
    Inputs inputs = initialInputs();
    inputs.params.model = model;
    inputs.params.restitution_wall = 0.9;
    ball.setInputs(inputs);
    ball.setPilot(std::make_shared<PlacePilot>());
    GhostEngine ghost = ghostOf(ball, {stepper, 1}, stepper);
    std::set<uint32_t> hit; // boxes: the ball bounces off every wall on its way
    for (int i = 0; i < 400; ++i) {
        QVERIFY2(ball.step(&m_error), qPrintable(m_error));
        QVERIFY2(ghost.follow(ball, &m_error), qPrintable(m_error));
        for (const phys_event &event : ball.events()) {
            if (event.kind == PHYS_EVENT_IMPACT) hit.insert(event.box);
        }
        QVERIFY(support::sameBits(ghost.state(), ball.state()));
        COMPARE_EXACT(ghost.deviation().distance, 0.0);
        COMPARE_EXACT(ghost.deviation().energy, 0.0);
    }
    QCOMPARE(hit.size(), size_t(4));
}

void TestGhostEngine::ghostIsWhatTheLibraryComputes_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("substeps");
    for (const QByteArray &id : support::stepperIds())
        for (const int substeps : {1, 3}) QTest::addRow("%s, dt/%d", id.constData(), substeps) << id << substeps;
}

// The same with the library's calls alone and the tilts that the ball's pilot chose.
void TestGhostEngine::ghostIsWhatTheLibraryComputes() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, substeps);
    const Scene scene = levelScene(4);
    Engine ball = ballOf(scene, "symplectic-euler");
    ball.setPilot(std::make_shared<PlacePilot>());
    GhostEngine ghost = ghostOf(ball, {stepper, substeps}, "symplectic-euler");
    const Stepper plain = makeStepper(registry(), stepper, scene, nullptr);
    phys_state state;
    QCOMPARE(phys_scene_start(scene.get(), &state), PHYS_OK);
    double largest = 0.0;
    for (int i = 0; i < 400; ++i) {
        QVERIFY(ball.step(&m_error));
        QVERIFY2(ghost.follow(ball, &m_error), qPrintable(m_error));
        const phys_params params = ball.inputs().params;
        for (int j = 0; j < substeps; ++j)
            QCOMPARE(phys_step(plain.get(), &params, 0.01 / substeps, &state, &state, nullptr, nullptr), PHYS_OK);
        QVERIFY(support::sameBits(ghost.state(), state));
        const phys_vec3 &a = ball.state().position;
        const double distance = std::sqrt(std::pow(a.x - state.position.x, 2) + std::pow(a.y - state.position.y, 2) +
                                          std::pow(a.z - state.position.z, 2));
        COMPARE_WITHIN(ghost.deviation().distance, distance, 1e-15 * distance); // 4 roundings
        largest = std::max(largest, distance);
    }
    const bool isSame = stepper == "symplectic-euler" && substeps == 1;
    QCOMPARE(largest == 0.0, isSame);
}

void TestGhostEngine::deviationIsThatOfBothStates() {
    Engine ball = ballOf(levelScene(1), "explicit-euler");
    ball.setInputs(tilted(3.0, 4.0));
    GhostEngine ghost = ghostOf(ball, {"exact", 1}, "explicit-euler");
    for (int i = 0; i < 50; ++i) QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
    const auto speed = [](const phys_state &state) { return std::hypot(state.velocity.x, state.velocity.y); };
    const auto energy = [&](const phys_state &state) {
        double result = 0.0;
        phys_energy(ball.scene().get(), &ball.inputs().params, &state, &result);
        return result;
    };
    // The differences of numbers below 1.
    COMPARE_WITHIN(ghost.deviation().speed, speed(ball.state()) - speed(ghost.state()), 1e-15);
    COMPARE_EXACT(ghost.deviation().energy, energy(ball.state()) - energy(ghost.state()));
    Sample sample = ball.sample();
    ghost.addTo(sample);
    COMPARE_EXACT(sample[Channel::GhostX], ghost.state().position.x);
    COMPARE_EXACT(sample[Channel::GhostY], ghost.state().position.y);
    COMPARE_EXACT(sample[Channel::GhostZ], ghost.state().position.z);
    COMPARE_EXACT(sample[Channel::Distance], ghost.deviation().distance);
    COMPARE_EXACT(sample[Channel::SpeedDifference], ghost.deviation().speed);
    COMPARE_EXACT(sample[Channel::EnergyDifference], ghost.deviation().energy);
}

// Under a constant acceleration symplectic Euler is ahead of the parabola by a dt t / 2: the sum of i a dt^2 for i up
// to n is a t^2 / 2 + a dt t / 2. For free rolling a = 5/7 g sin(tilt).
void TestGhostEngine::deviationOfEulerIsThatOfTheory() {
    Engine ball = ballOf(openFloor(), "symplectic-euler");
    Inputs inputs = tilted(5.0, 0.0);
    inputs.params.rolling_friction = 0.0;
    ball.setInputs(inputs);
    GhostEngine ghost = ghostOf(ball, {"exact", 1}, "symplectic-euler");
    const double acceleration = 5.0 / 7.0 * 9.81 * std::sin(radians(5.0));
    for (int i = 1; i <= 100; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
        // Rounding of positions up to 0.3 m, added up over the steps.
        COMPARE_WITHIN(ghost.deviation().distance, acceleration * 0.01 * (0.01 * i) / 2.0, 1e-15 * i);
    }
}

void TestGhostEngine::finerStepsEndAtTheSameTime_data() {
    QTest::addColumn<int>("substeps");
    for (const int substeps : {1, 3, 7, 10, 1000}) QTest::addRow("dt/%d", substeps) << substeps;
}

// Time is counted, not summed: a ball at 1 m/s would be off by the difference of the times.
void TestGhostEngine::finerStepsEndAtTheSameTime() {
    QFETCH(int, substeps);
    Engine ball = ballOf(openFloor(), "symplectic-euler");
    for (int i = 0; i < 30; ++i) QVERIFY(ball.step(&m_error));
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", substeps}, "symplectic-euler");
    for (int i = 0; i < 300; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
        COMPARE_WITHIN(ghost.state().time, ball.state().time, 1e-15 * ball.state().time); // of both products
    }
}

void TestGhostEngine::meetingPutsItOntoTheBall() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setInputs(tilted(3.0, 4.0));
    GhostEngine ghost = ghostOf(ball, {"exact", 1}, "symplectic-euler");
    for (int i = 0; i < 40; ++i) QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
    QVERIFY(ghost.deviation().distance > 0.0);
    ghost.meet(ball);
    QVERIFY(support::sameBits(ghost.state(), ball.state()));
    QVERIFY(support::sameBits(ghost.previous(), ball.previous())); // drawn between both, as the ball is
    COMPARE_EXACT(ghost.deviation().distance, 0.0);
    COMPARE_EXACT(ghost.deviation().speed, 0.0);
    COMPARE_EXACT(ghost.deviation().energy, 0.0);
    COMPARE_EXACT(ghost.met().time, 0.4);
}

void TestGhostEngine::meetingGoesOnAsFromThere() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setInputs(tilted(3.0, 4.0));
    GhostEngine ghost = ghostOf(ball, {"rk4", 1}, "symplectic-euler");
    for (int i = 0; i < 40; ++i) QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
    ghost.meet(ball);
    Engine other = ballOf(ball.scene(), "rk4");
    other.setInputs(tilted(3.0, 4.0));
    other.setState(ball.state());
    for (int i = 0; i < 40; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error) && other.step(&m_error));
        QVERIFY(support::sameBits(ghost.state(), other.state()));
        QVERIFY(support::sameBits(ghost.previous(), other.previous()));
    }
}

void TestGhostEngine::stepSizeOfTheBallCanChange() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setInputs(tilted(3.0, 4.0));
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "symplectic-euler");
    for (const double dt : {0.01, 0.004, 0.0125}) {
        ball.setDt(dt);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
            QVERIFY(support::sameBits(ghost.state(), ball.state()));
        }
    }
}

// At a wall, where as_reported makes a difference.
void TestGhostEngine::sameStepperObeysTheBallsOwnValues() {
    Engine ball = ballOf(levelScene(1), "symplectic-euler");
    Inputs inputs = tilted(-8.0, 0.0);
    inputs.params.stepper[0] = 1.0;
    ball.setInputs(inputs);
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "symplectic-euler");
    for (int i = 0; i < 100; ++i) QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
    QVERIFY(support::sameBits(ghost.state(), ball.state()));
}

void TestGhostEngine::otherStepperHasInitialOwnValues() {
    Engine ball = ballOf(levelScene(1), "symplectic-euler");
    Inputs inputs = tilted(-8.0, 0.0);
    inputs.params.stepper[0] = 1.0;
    ball.setInputs(inputs);
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "symplectic-euler");
    ghost.setLeaderStepper("exact"); // the ball's values now have another meaning
    Engine plain = ballOf(ball.scene(), "symplectic-euler");
    plain.setInputs(tilted(-8.0, 0.0));
    for (int i = 0; i < 100; ++i) QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error) && plain.step(&m_error));
    QVERIFY(support::sameBits(ghost.state(), plain.state()));
    QVERIFY(!support::sameBits(ghost.state(), ball.state()));
}

// Like an engine that has them from the start.
void TestGhostEngine::ownParametersAreObeyed() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setInputs(tilted(3.0, 4.0));
    Inputs own = tilted(3.0, 4.0);
    own.params.restitution_wall = 0.8;
    own.params.rolling_friction = 0.004;
    own.params.model = PHYS_MODEL_RIGID;
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "symplectic-euler");
    ghost.setOwnInputs(own);
    Engine alone = ballOf(ball.scene(), "symplectic-euler");
    alone.setInputs(own);
    double largest = 0.0; // both end in the same corner
    for (int i = 0; i < 200; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error) && alone.step(&m_error));
        QVERIFY(support::sameBits(ghost.state(), alone.state()));
        largest = std::max(largest, ghost.deviation().distance);
    }
    QVERIFY(largest > 0.0);
}

// On the Moon, tilted as the ball's pilot does.
void TestGhostEngine::tiltIsTheBallsWhateverItsOwnParameters() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setPilot(std::make_shared<PlacePilot>());
    Inputs moon = initialInputs();
    moon.gravity = 1.62;
    tiltBoard(moon, {});
    GhostEngine ghost = ghostOf(ball, {"exact", 1}, "symplectic-euler");
    ghost.setOwnInputs(moon);
    Engine alone = ballOf(ball.scene(), "exact");
    for (int i = 0; i < 200; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
        tiltBoard(moon, ball.inputs().tilt);
        alone.setInputs(moon);
        QVERIFY(alone.step(&m_error));
        QVERIFY(support::sameBits(ghost.state(), alone.state()));
    }
}

void TestGhostEngine::ownParametersThatAreTheBallsKeepItOnTheBall() {
    Engine ball = ballOf(levelScene(3), "symplectic-euler");
    ball.setPilot(std::make_shared<PlacePilot>());
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "symplectic-euler");
    ghost.setOwnInputs(initialInputs());
    for (int i = 0; i < 200; ++i) {
        QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error));
        QVERIFY(support::sameBits(ghost.state(), ball.state()));
    }
}

void TestGhostEngine::refusalEndsItUntilTheNextMeeting() {
    Engine ball = fastBall();
    const phys_state start = ball.state();
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "exact");
    for (int i = 0; ghost.isThere() && i < kFastSteps; ++i) {
        QVERIFY(ball.step(&m_error));
        ghost.follow(ball, &m_error);
    }
    QVERIFY(!ghost.isThere());
    QVERIFY2(m_error.contains("substeps of half a radius; at most 1000000 are allowed"), qPrintable(m_error));
    Sample sample = ball.sample();
    ghost.addTo(sample);
    QVERIFY(std::isnan(sample[Channel::GhostX]) && std::isnan(sample[Channel::Distance]));
    QVERIFY(ball.step(&m_error));
    QVERIFY(ghost.follow(ball, &m_error)); // said once

    ball.setState(start);
    ghost.meet(ball);
    QVERIFY(ghost.isThere());
    QVERIFY(ball.step(&m_error) && ghost.follow(ball, &m_error) && ghost.isThere());
}

void TestGhostEngine::refusalLeavesTheBallAlone() {
    Engine ball = fastBall();
    Engine alone = fastBall();
    GhostEngine ghost = ghostOf(ball, {"symplectic-euler", 1}, "exact");
    for (int i = 0; i < kFastSteps; ++i) {
        QVERIFY(ball.step(&m_error) && alone.step(&m_error));
        ghost.follow(ball, &m_error);
        QVERIFY(support::sameBits(ball.state(), alone.state()));
    }
    QVERIFY(!ghost.isThere());
}

void TestGhostEngine::missingStepperGivesOneLine() {
    QVERIFY(!makeGhostSetup(registry(), {"none", 1}, openFloor(), &m_error));
    QVERIFY2(m_error.startsWith("no stepper has the id 'none'"), qPrintable(m_error));
}

void TestGhostEngine::sceneThatTheStepperCantDoGivesOneLine() {
    const Registry withPlugin = makeRegistry(nullptr);
    QVERIFY2(loadPlugin(withPlugin, MISBEHAVING, &m_error), qPrintable(m_error));
    const GhostChoice ghostChoice{"wants-walls", 1};
    QVERIFY2(makeGhostSetup(withPlugin, ghostChoice, longFloor(), &m_error), qPrintable(m_error));
    QVERIFY(!makeGhostSetup(withPlugin, ghostChoice, openFloor(), &m_error));
    QCOMPARE(m_error, QStringLiteral("a floor without walls is too simple"));
}

QTEST_GUILESS_MAIN(TestGhostEngine)
#include "tst_ghost_engine.moc"
