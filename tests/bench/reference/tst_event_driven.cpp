// SPDX-License-Identifier: MIT
// The event-driven reference against closed forms, against itself in another precision, and stepper `exact` against it.
#include "peers/engine.h"
#include "reference/event_driven.h"
#include "reference/polynomial.h"
#include "support/maze_scenes.h"
#include "support/scenes.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace bench;

namespace {

// A few roundings of coordinates of about a metre.
constexpr double kReferenceRounding = 1e-15;

Scene sceneOf(std::vector<Wall> walls, double radius, const Ball &start, double restitution, const Vec2 &acceleration,
              double duration) {
    Scene scene;
    scene.walls = std::move(walls);
    scene.radius = radius;
    scene.start = start;
    scene.restitution = restitution;
    scene.duration = scene.tiltPeriod = duration;
    scene.gravity = {{acceleration.x, acceleration.y, -kStrength}};
    return scene;
}

Ball lastBall(const Scene &scene) { return eventDriven<long double>(scene).balls.back(); }

void addMazeRows() {
    QTest::addColumn<int>("size");
    QTest::addColumn<unsigned>("seed");
    for (std::size_t size = 0; size < 2; ++size) // the largest take seconds without optimisation
        for (const unsigned seed : kMazeSizes[size].seeds)
            QTest::addRow("%d cells, seed %u", kMazeSizes[size].cells, seed) << static_cast<int>(size) << seed;
}

Scene fetchedMaze() {
    QFETCH(int, size);
    QFETCH(unsigned, seed);
    return mazeScene(kMazeSizes[static_cast<std::size_t>(size)], seed);
}

QString text(double error, std::size_t period, double growth) {
    return QString("%1 m after period %2; a change of the start has grown by %3").arg(error).arg(period).arg(growth);
}

} // namespace

class TestEventDriven : public QObject {
    Q_OBJECT

private slots:
    // model.md 5.3: a parabola and an edge may meet four times.
    void polynomialFindsAllFourRoots() {
        const Polynomial<long double> distance{9 + 6.25L - 3.61L, 2 * (-3 - 7.5L), 10 + 2.5L, -3, 0.25L};
        const auto roots = signChanges(distance, 10.0L);
        QCOMPARE(roots.size(), std::size_t{4});
        const long double expected[] = {1.1126606200311161634L, 2.338222042661838788L, 3.661777957338161212L,
                                        4.8873393799688838366L};
        for (std::size_t root = 0; root < 4; ++root) QVERIFY(std::abs(roots[root] - expected[root]) < 1e-17L);
    }

    // A parabola hits a vertical edge at t = 0.4907..., restitution 0.8; the expected state is that of 50 digits.
    void edgeIsHitWhereTheQuarticSays() {
        const double hit = 0.4907497945889225585;
        const Vec2 hitVelocity{0.4003426892341553206, 0.85876958908727570425};
        const double later = 0.01;
        const Scene scene = sceneOf({{0.5, -0.2, 0.9, -0.04}}, 0.02, {{0, 0}, {1, 0.2}}, 0.8, {0, -1}, hit + later);
        const Ball ball = lastBall(scene);
        const Vec2 at{hit + later * hitVelocity.x,
                      0.2 * hit - hit * hit / 2 + later * hitVelocity.y - later * later / 2};
        QVERIFY(distance(ball.position, at) < kReferenceRounding);
        QVERIFY(distance(ball.velocity, {hitVelocity.x, hitVelocity.y - later}) < 10 * kReferenceRounding);
    }

    // model.md 6.4: 0.6 m/s, 0.5 m/s^2 into the wall and restitution 0.8 end bouncing after 12 s.
    void bouncesAccumulateAtTheirClosedForm() {
        const Wall floor{-100, -1, 100, 0};
        const double afterFirst = 0.6;
        const auto heightAt = [&](double time) {
            return lastBall(sceneOf({floor}, 0.25, {{0, 0.25}, {0.3, afterFirst}}, 0.8, {0, -0.5}, time)).position.y -
                   0.25;
        };
        QVERIFY(heightAt(11.99) > 0);
        QVERIFY(std::abs(heightAt(12.01)) < kReferenceRounding);
    }

    // model.md 6.2: from rest near the top of an edge a ball leaves at cos(theta) = 2/3 cos(theta0).
    void edgeIsLeftAtItsClosedForm() {
        const double radius = 0.25;
        const double begin = 0.3;
        const double leave = std::acos(2.0 / 3.0 * std::cos(begin));
        Scene scene = sceneOf({{-1, -1, 0, 0}}, radius, {{radius * std::sin(begin), radius * std::cos(begin)}, {}}, 0.5,
                              {0, -1}, 0.01);
        scene.tiltPeriod = 1.0 / 256;
        scene.gravity.assign(512, scene.gravity.front());
        const double energy = scene.start.position.y;
        double lastTouching = 0;
        for (const Ball &ball : eventDriven<long double>(scene).balls) {
            const double speed2 = ball.velocity.x * ball.velocity.x + ball.velocity.y * ball.velocity.y;
            QVERIFY(std::abs(speed2 / 2 + ball.position.y - energy) < kReferenceRounding);
            const double gap = std::hypot(ball.position.x, ball.position.y) - radius;
            if (gap < kReferenceRounding)
                lastTouching = std::atan2(ball.position.x, ball.position.y);
            else
                QVERIFY(std::atan2(ball.position.x, ball.position.y) > leave);
        }
        QVERIFY(lastTouching <= leave);
        QVERIFY(lastTouching > leave - 0.02); // one sample earlier at the speed there
    }

    // The same run in double differs by its rounding times the trajectory's own sensitivity.
    void precisionsAgree_data() { addMazeRows(); }
    void precisionsAgree() {
        const Scene scene = fetchedMaze();
        const Passage coarse = eventDriven<double>(scene);
        const Passage fine = eventDriven<long double>(scene);
        const std::vector<double> growth = sensitivity(scene);
        double largest = 1;
        for (std::size_t period = 0; period < fine.balls.size(); ++period) {
            largest = std::max(largest, growth[period]);
            const double error = distance(coarse.balls[period].position, fine.balls[period].position);
            // Coordinates reach 32 m: 4e-15 of rounding for each impact.
            QVERIFY2(error <= 4e-15 * (1 + fine.impacts) * largest, qPrintable(text(error, period, largest)));
        }
    }

    void exactStepperAgrees_data() { addMazeRows(); }
    void exactStepperAgrees() {
        const auto engines = ourEngines();
        const auto exact =
            std::find_if(engines.begin(), engines.end(), [](const EngineKind &kind) { return kind.exactInDt; });
        if (exact == engines.end()) QSKIP("the registry has no stepper that is exact in dt");
        const Scene scene = fetchedMaze();
        const Passage reference = eventDriven<long double>(scene);
        const std::vector<double> growth = sensitivity(scene);
        const auto engine = exact->make(scene, scene.tiltPeriod);
        engine->place(scene.start);
        double largest = 1;
        for (std::size_t period = 0; period < reference.balls.size(); ++period) {
            engine->setGravity(scene.gravity[period]);
            engine->advance(scene.tiltPeriod, 1);
            largest = std::max(largest, growth[period]);
            const double error = distance(engine->ball().position, reference.balls[period].position);
            QVERIFY2(error <= 4e-15 * (1 + reference.impacts) * largest, qPrintable(text(error, period, largest)));
        }
    }
};

QTEST_GUILESS_MAIN(TestEventDriven)
#include "tst_event_driven.moc"
