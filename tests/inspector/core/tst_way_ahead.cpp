// SPDX-License-Identifier: MIT
// The path ahead is computed by the exact stepper; the user can put the ball only where it fits.
#include "core/setup/ball_place.h"
#include "core/simulation/way_ahead.h"
#include "inspector/core/scenes.h"
#include "inspector/core/wall_ahead.h"
#include "support/compare.h"

#include <array>
#include <cmath>
#include <random>

using namespace inspector;

class TestWayAhead : public QObject {
    Q_OBJECT

private slots:
    void wayIsTheExactSteppersWay();
    void nextImpactIsMarked();
    void nextLandingIsMarked();
    void restingBallHasNoWay();
    void latestQuestionIsAnswered();
    void otherBoardsHaveWaysOfTheirOwn();
    void ballIsPutWhereItFits();
    void ballIsPutBesideALowKerb();
    void ballBesideTheFloorStaysInTheAir();
    void ballLiesOnTheRimOfANarrowHole();
    void rollingSpinTouchesTheFloorAtRest();

private:
    static Stepper exactOn(const Scene &scene) {
        Stepper stepper = makeStepper(makeRegistry(nullptr), "exact", scene, nullptr);
        if (!stepper) qFatal("no exact stepper");
        return stepper;
    }
    static phys_state startOf(const Scene &scene) {
        phys_state start;
        if (phys_scene_start(scene.get(), &start) != PHYS_OK) qFatal("no start");
        return start;
    }
};

// Rolling down a slope: s = 5/7 (g sin a - c g cos a) t^2 / 2 (model.md 3). Compared with steps of another size, which
// for an exact stepper differ by rounding only.
void TestWayAhead::wayIsTheExactSteppersWay() {
    const Scene scene = openFloor();
    const Stepper stepper = exactOn(scene);
    const phys_params params = tilted(1.0, 0.0).params;
    const WayAhead way = wayAhead(stepper, startOf(scene), params);
    QCOMPARE(way.points.size(), size_t(121)); // 2 s
    phys_state state = startOf(scene);
    phys_step(stepper.get(), &params, WayFinder::kReach, &state, &state, nullptr, nullptr);
    QVERIFY(std::abs(way.points.back().x - state.position.x) < 1e-9);
    QVERIFY(way.points.back().x > 0.1);
}

void TestWayAhead::nextImpactIsMarked() {
    const Scene scene = levelScene(1);
    const WayAhead way = wayAhead(exactOn(scene), startOf(scene), tilted(-3.0, 5.0).params);
    QVERIFY(way.bounce.has_value());
    QVERIFY(way.bounce->time > 0.0 && way.bounce->time < WayFinder::kReach);
    QVERIFY(way.bounce->speed_before < 0.0);
}

// A ball falls by 0.2 m for sqrt(2 h/g).
void TestWayAhead::nextLandingIsMarked() {
    const Scene scene = openFloor();
    phys_state state = startOf(scene);
    state.position.z += 0.2;
    const WayAhead way = wayAhead(exactOn(scene), state, tilted(0.0, 0.0).params);
    QVERIFY(way.bounce.has_value());
    QVERIFY(std::abs(way.bounce->time - std::sqrt(2.0 * 0.2 / 9.81)) < 1e-9);
}

void TestWayAhead::restingBallHasNoWay() {
    const Scene scene = openFloor();
    const WayAhead way = wayAhead(exactOn(scene), startOf(scene), tilted(0.0, 0.0).params);
    QCOMPARE(way.points.size(), size_t(2)); // it is at rest after the first step
    QVERIFY(!way.bounce);
}

void TestWayAhead::latestQuestionIsAnswered() {
    const Scene scene = openFloor();
    WayFinder finder(makeRegistry(nullptr));
    for (int i = 0; i <= 20; ++i) finder.ask(scene, startOf(scene), tilted(0.1 * i, 0.0).params);
    const WayAhead expected = wayAhead(exactOn(scene), startOf(scene), tilted(2.0, 0.0).params);
    QTRY_VERIFY(finder.latest().points.size() == expected.points.size() &&
                finder.latest().points.back().x == expected.points.back().x);
}

void TestWayAhead::otherBoardsHaveWaysOfTheirOwn() {
    const Scene scene = openFloor();
    const Stepper stepper = exactOn(scene);
    const phys_params steep = tilted(2.0, 0.0).params;
    const phys_params params = tilted(1.0, 0.0).params;
    const WayAhead way = wayAhead(stepper, startOf(scene), params, {{steep, {}}, {params, {0.001, 0.0, 0.0}}});
    QCOMPARE(way.others.size(), size_t(2));
    QCOMPARE(way.others[0].size(), way.points.size());
    QCOMPARE(way.others[0].back().x, wayAhead(stepper, startOf(scene), steep).points.back().x);
    QCOMPARE(way.others[1].front().x, startOf(scene).position.x + 0.001);
}

// Wherever it is wanted inside the board, the ball overlaps no wall and stands on the floor.
void TestWayAhead::ballIsPutWhereItFits() {
    const Scene scene = levelScene(3);
    const double radius = phys_scene_radius(scene.get());
    phys_box bounds;
    QCOMPARE(phys_scene_bounds(scene.get(), &bounds), PHYS_OK);
    constexpr unsigned kSeed = 4;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> share(0.02, 0.98);
    for (int i = 0; i < 500; ++i) {
        const phys_vec3 wanted{bounds.min.x + share(random) * (bounds.max.x - bounds.min.x),
                               bounds.min.y + share(random) * (bounds.max.y - bounds.min.y), 0.0};
        const phys_vec3 place = freePlace(scene.get(), wanted);
        std::array<phys_contact, 64> contacts{};
        uint32_t count = 0;
        QCOMPARE(phys_scene_contacts(scene.get(), &place, 0.1 * radius, contacts.data(), 64, &count), PHYS_OK);
        for (uint32_t c = 0; c < count; ++c)
            QVERIFY2(contacts[c].gap > -1e-6 * radius,
                     qPrintable(QStringLiteral("seed %1, place %2: %3 m").arg(kSeed).arg(i).arg(contacts[c].gap)));
    }
}

// The edge of a kerb of 0.6 mm pushes a ball of 6 mm almost straight up, but a little aside.
void TestWayAhead::ballIsPutBesideALowKerb() {
    constexpr double kHeight = 6e-4;
    const Scene scene = wallAhead(0.1, kHeight);
    const double radius = phys_scene_radius(scene.get());
    const phys_vec3 place = freePlace(scene.get(), {0.1 - 0.1 * radius, 0.0, radius});
    // It touches the edge: (R - h)^2 + d^2 = R^2.
    COMPARE_WITHIN(place.x, 0.1 - std::sqrt(radius * radius - std::pow(radius - kHeight, 2)), 1e-6 * radius);
}

void TestWayAhead::ballBesideTheFloorStaysInTheAir() {
    const phys_vec3 place = freePlace(openFloor().get(), {5.0, 0.0, 0.3});
    QCOMPARE(place.z, 0.3);
}

// Between two floors, half a radius on each side of its centre.
void TestWayAhead::ballLiesOnTheRimOfANarrowHole() {
    const double radius = phys_scene_radius(openFloor().get());
    const double half = 0.5 * radius;
    const Scene scene = sceneOf({{{-1.0, -1.0, -0.01}, {-half, 1.0, 0.0}}, {{half, -1.0, -0.01}, {1.0, 1.0, 0.0}}});
    const phys_vec3 place = freePlace(scene.get(), {0.0, 0.0, radius});
    QCOMPARE(place.x, 0.0);
    COMPARE_WITHIN(place.z, std::sqrt(radius * radius - half * half), 1e-9 * radius);
}

// v + spin x (-R up) = 0.
void TestWayAhead::rollingSpinTouchesTheFloorAtRest() {
    constexpr double kRadius = 0.006;
    const phys_vec3 velocity{0.3, -0.2, 0.0};
    const phys_vec3 spin = rollingSpin(velocity, kRadius);
    QVERIFY(std::abs(velocity.x - spin.y * kRadius) < 1e-15);
    QVERIFY(std::abs(velocity.y + spin.x * kRadius) < 1e-15);
    QCOMPARE(spin.z, 0.0);
}

QTEST_GUILESS_MAIN(TestWayAhead)
#include "tst_way_ahead.moc"
