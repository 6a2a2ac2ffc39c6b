// SPDX-License-Identifier: MIT
// Symmetric scenes give symmetric results, to the last bit: model.md 9.
#include "drawn_scene.h"
#include "support/compare.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"

#include <QTest>

#include <algorithm>
#include <functional>

using namespace invariants;
using namespace support;

namespace {

constexpr int kScenes = 12;

QByteArray where(int scene, const phys_state &a, const phys_state &b) {
    return "scene " + QByteArray::number(scene) + ", step " + QByteArray::number(static_cast<qulonglong>(a.step)) +
           ": (" + digits(a.position.x) + ", " + digits(a.position.y) + ") against (" + digits(b.position.x) + ", " +
           digits(b.position.y) + ")";
}

} // namespace

class TestSymmetry : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(testSeed())); }
    void sameInAnotherFrame_data();
    void sameInAnotherFrame();
    void sameWithBoxesCutInTwo_data() { addStepperAndModelRows(); }
    void sameWithBoxesCutInTwo();
    void sameWithBoxesCutInMany_data() { addStepperAndModelRows(); }
    void sameWithBoxesCutInMany();
    void sameWithBoxesInAnotherOrder_data() { addStepperAndModelRows(); }
    void sameWithBoxesInAnotherOrder();
    void sameWithTilesInAnotherFrame_data();
    void sameWithTilesInAnotherFrame();
    void sameWithTilesInAnotherOrder_data() { addStepperAndModelRows(); }
    void sameWithTilesInAnotherOrder();
    void sameWithTiedBoxesInAnotherOrder_data();
    void sameWithTiedBoxesInAnotherOrder();
    void lossesAtEqualContactsAreThoseOfTheMirrorImage_data() { addStepperRows(); }
    void lossesAtEqualContactsAreThoseOfTheMirrorImage();
    void addedVelocityAddsItsWay_data() { addStepperAndModelRows(); }
    void addedVelocityAddsItsWay();
    void reversedMotionComesBack_data() { addStepperAndModelRows(); }
    void reversedMotionComesBack();

private:
    using Change1 = std::function<Drawn(const Drawn &)>;
    using Change2 = std::function<phys_state(const phys_state &)>;
    /// Runs random scenes and their images side by side; `map` takes a state of the first into the second's frame.
    void compare(const Change1 &change, const Change2 &map, decltype(&draw) drawOne = draw);
};

void TestSymmetry::compare(const Change1 &change, const Change2 &map, decltype(&draw) drawOne) {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed());
    for (int scene = 0; scene < kScenes; ++scene) {
        const Drawn drawn = drawOne(random, model);
        const Drawn other = change(drawn);
        Experiment a = makeExperiment(drawn, stepper);
        Experiment b = makeExperiment(other, stepper);
        QVERIFY2(a.isReady() && b.isReady(), a.error());
        for (int i = 0; i < kSegment * kSegments; ++i) {
            const auto segment = static_cast<size_t>(i / kSegment);
            a.params.gravity = drawn.gravities[segment];
            b.params.gravity = other.gravities[segment];
            const bool stepped = a.step(drawn.dt);
            QCOMPARE(b.step(other.dt), stepped);
            if (!stepped) QCOMPARE(a.status(), PHYS_ERROR_UNSUPPORTED);
            if (!stepped) break;
            const phys_state mapped = map(a.state);
            QVERIFY2(sameMotion(mapped, b.state), where(scene, mapped, b.state));
        }
    }
}

namespace {

void addRowsOfChanges(bool (*isTried)(const Change &)) {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    QTest::addColumn<int>("change");
    for (const QByteArray &id : stepperIds()) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            for (size_t i = 0; i < kChanges.size(); ++i) {
                if (!isTried(kChanges[i])) continue;
                QTest::addRow("%s, %s, %s", id.constData(), modelName(model).constData(), kChanges[i].name)
                    << id << model << static_cast<int>(i);
            }
        }
    }
}

} // namespace

void TestSymmetry::sameInAnotherFrame_data() {
    addRowsOfChanges([](const Change &) { return true; });
}

void TestSymmetry::sameInAnotherFrame() {
    QFETCH(int, change);
    const Change &c = kChanges[static_cast<size_t>(change)];
    compare([&](const Drawn &drawn) { return changed(drawn, c); },
            [&](const phys_state &state) { return changed(state, c); });
}

void TestSymmetry::sameWithBoxesCutInTwo() {
    Random random(testSeed() + 1);
    compare([&](const Drawn &drawn) { return cutIntoPieces(drawn, random, 2); },
            [](const phys_state &state) { return state; });
}

void TestSymmetry::sameWithBoxesCutInMany() {
    Random random(testSeed() + 2);
    compare([&](const Drawn &drawn) { return cutIntoPieces(drawn, random, 16); },
            [](const phys_state &state) { return state; });
}

void TestSymmetry::sameWithBoxesInAnotherOrder() {
    Random random(testSeed() + 3);
    compare([&](const Drawn &drawn) { return shuffled(drawn, random); }, [](const phys_state &state) { return state; });
}

/// Flush boxes are merged along x first, so that tiles may make other boxes where the axes are exchanged.
void TestSymmetry::sameWithTilesInAnotherFrame_data() {
    addRowsOfChanges([](const Change &change) { return change.xy == 0.0; });
}

void TestSymmetry::sameWithTilesInAnotherFrame() {
    QFETCH(int, change);
    const Change &c = kChanges[static_cast<size_t>(change)];
    compare([&](const Drawn &drawn) { return changed(drawn, c); },
            [&](const phys_state &state) { return changed(state, c); }, drawTiles);
}

void TestSymmetry::sameWithTilesInAnotherOrder() {
    Random random(testSeed() + 4);
    compare([&](const Drawn &drawn) { return shuffled(drawn, random); }, [](const phys_state &state) { return state; },
            drawTiles);
}

void TestSymmetry::sameWithTiedBoxesInAnotherOrder_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    for (const QByteArray &id : stepperIds()) {
        if (id == "exact") continue; // it has an order of its own
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            QTest::addRow("%s, %s", id.constData(), modelName(model).constData()) << id << model;
        }
    }
}

/// A ball falls straight into a square hole narrower than itself: four symmetric edges at the same time.
void TestSymmetry::sameWithTiedBoxesInAnotherOrder() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const std::vector<phys_box> rim{{{-1, -1, -1}, {-0.03, 1, 0}},
                                    {{0.03, -1, -1}, {1, 1, 0}},
                                    {{-0.03, -1, -1}, {0.03, -0.03, 0}},
                                    {{-0.03, 0.03, -1}, {0.03, 1, 0}}};
    const auto dropped = [&](const std::array<size_t, 4> &order) {
        SceneBuilder builder;
        for (const size_t i : order) builder.box(rim[i]);
        Experiment ball(builder.ball(0.0625).start({0.0, 0.0, 0.125}), stepper, model);
        ball.params.restitution_wall = 0.5;
        ball.params.wall_friction = 0.25;
        ball.state.spin = {0.0, 0.0, 3.0};
        return ball;
    };
    std::array<size_t, 4> order{0, 1, 2, 3};
    Experiment first = dropped(order);
    std::vector<phys_state> path;
    for (int i = 0; i < 100; ++i) {
        QVERIFY2(first.step(0x1p-8), first.error());
        path.push_back(first.state);
    }
    while (std::next_permutation(order.begin(), order.end())) {
        Experiment other = dropped(order);
        for (const phys_state &state : path) {
            QVERIFY2(other.step(0x1p-8), other.error());
            QVERIFY(support::sameBits(other.state, state));
        }
    }
}

/// Slipping along a wall that it is pressed on as on the floor: nothing but their friction distinguishes both.
void TestSymmetry::lossesAtEqualContactsAreThoseOfTheMirrorImage() {
    QFETCH(QByteArray, stepper);
    Random random(testSeed() + 6);
    for (int i = 0; i < 20; ++i) {
        const double speed = random.between(0.5, 2.0), floorFriction = random.between(0.01, 0.2),
                     wallFriction = random.between(0.01, 0.2);
        const auto besideAWall = [&](double side) {
            const double near = std::min(0.0, side), far = std::max(0.0, side);
            Experiment ball(
                SceneBuilder().ball(0.0625).floor(-1, -20, 1, 20).wall(near, -20, far, 20).start(-0.0625 * side, 0.0),
                stepper, PHYS_MODEL_RIGID);
            ball.params.gravity = {8.0 * side, 0.0, -8.0};
            ball.params.sliding_friction = floorFriction;
            ball.params.wall_friction = wallFriction;
            ball.state.velocity.y = speed;
            return ball;
        };
        Experiment left = besideAWall(-1.0), right = besideAWall(1.0);
        for (int step = 0; step < 20; ++step) {
            QVERIFY2(left.step(0.01), left.error());
            QVERIFY2(right.step(0.01), right.error());
            COMPARE_EXACT(left.report.lost_slip, right.report.lost_slip);
        }
    }
}

void TestSymmetry::addedVelocityAddsItsWay() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    Random random(testSeed());
    for (int i = 0; i < 20; ++i) {
        Experiment a(openFloor(), stepper, model);
        Experiment b(openFloor(), stepper, model);
        const double ax = random.between(-1.0, 1.0);
        const double ay = random.between(-1.0, 1.0);
        const double vx = random.between(-1.0, 1.0);
        const double cx = random.between(-1.0, 1.0);
        const double cy = random.between(-1.0, 1.0);
        a.setLaw(ax, ay);
        b.setLaw(ax, ay);
        a.roll(vx, 0.25);
        b.roll(vx + cx, 0.25 + cy);
        QVERIFY2(a.stepTimes(256, 0x1p-6) && b.stepTimes(256, 0x1p-6), a.error());
        // B = 0: x(t; v0 + c) = x(t; v0) + c t; 256 additions of numbers below 20.
        COMPARE_WITHIN(b.state.position.x, a.state.position.x + 4.0 * cx, rounding(4 * 256, 20.0));
        COMPARE_WITHIN(b.state.position.y, a.state.position.y + 4.0 * cy, rounding(4 * 256, 20.0));
    }
}

void TestSymmetry::reversedMotionComesBack() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    // B = 0, eps = 1, a smooth wall; for the rigid ball also a smooth floor, so that no slip is lost.
    Experiment ball(openFloor().wall(1.0, -50.0, 2.0, 50.0), stepper, model);
    ball.params.restitution_wall = 1.0;
    ball.params.sliding_friction = 0.0;
    ball.params.gravity.y = model == PHYS_MODEL_ROLLING ? 0.4375 : 0.0;
    ball.roll(1.0, 0.5);
    const double dt = 0x1p-8;
    QVERIFY2(ball.stepFor(2.0, dt), ball.error());
    ball.state.velocity = {-ball.state.velocity.x, -ball.state.velocity.y, 0.0};
    ball.state.spin = {-ball.state.spin.x, -ball.state.spin.y, 0.0};
    QVERIFY2(ball.stepFor(2.0, dt), ball.error());
    // Euler is off by a t dt/2 each way (model.md 10.1); a bounce noticed late is off by at most 2 v dt, in both
    // directions.
    const Promise promise = promiseOf(stepper);
    const double smooth = promise.smooth == 1 ? 2.0 * 0.3125 * 2.0 * dt : rounding(4096, 2.0);
    const double bounce = promise.impacts == 1 ? 4.0 * dt : rounding(4096, 2.0);
    COMPARE_WITHIN(ball.state.position.x, 0.0, bounce);
    COMPARE_WITHIN(ball.state.position.y, 0.0, smooth);
    COMPARE_WITHIN(ball.state.velocity.x, -1.0, rounding(4096, 1.0));
    COMPARE_WITHIN(ball.state.velocity.y, -0.5, rounding(4096, 1.0));
}

QTEST_GUILESS_MAIN(TestSymmetry)
#include "tst_symmetry.moc"
