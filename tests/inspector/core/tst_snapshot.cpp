// SPDX-License-Identifier: MIT
// What is drawn between two steps.
#include "core/simulation/snapshot.h"

#include <QTest>

#include <cmath>

using namespace inspector;
using namespace std::chrono_literals;

class TestSnapshot : public QObject {
    Q_OBJECT

private slots:
    void drawnBallIsBetweenTheTwoStates_data();
    void drawnBallIsBetweenTheTwoStates();
    void drawnGhostIsOfTheSameMoment_data();
    void drawnGhostIsOfTheSameMoment();
    void pausedBallIsTheCurrentState();
    void withoutAComparisonThereIsNoGhost();
    void orientationTakesTheShorterWayAndStaysUnit();
};

namespace {

const Clock::time_point kDue{1000s};

Snapshot snapshotOf(double from, double to) {
    Snapshot snapshot;
    snapshot.previous.orientation[3] = snapshot.current.orientation[3] = 1.0;
    snapshot.previous.position.x = from;
    snapshot.current.position.x = to;
    snapshot.due = kDue;
    snapshot.interval = 10ms;
    return snapshot;
}

} // namespace

void TestSnapshot::drawnBallIsBetweenTheTwoStates_data() {
    QTest::addColumn<int>("milliseconds");
    QTest::addColumn<double>("x");
    QTest::newRow("before it was due") << -3 << 1.0;
    QTest::newRow("just then") << 0 << 1.0;
    QTest::newRow("half way") << 5 << 2.0;
    QTest::newRow("next step due") << 10 << 3.0;
    QTest::newRow("next step late") << 1000 << 3.0;
}

void TestSnapshot::drawnBallIsBetweenTheTwoStates() {
    QFETCH(int, milliseconds);
    QFETCH(double, x);
    const Snapshot snapshot = snapshotOf(1.0, 3.0);
    QCOMPARE(interpolated(snapshot, kDue + std::chrono::milliseconds(milliseconds)).position.x, x);
}

void TestSnapshot::drawnGhostIsOfTheSameMoment_data() { drawnBallIsBetweenTheTwoStates_data(); }

void TestSnapshot::drawnGhostIsOfTheSameMoment() {
    QFETCH(int, milliseconds);
    QFETCH(double, x);
    Snapshot snapshot = snapshotOf(0.0, 0.0);
    const Snapshot other = snapshotOf(1.0, 3.0);
    snapshot.ghost.emplace();
    snapshot.ghost->previous = other.previous;
    snapshot.ghost->current = other.current;
    const auto ghost = interpolatedGhost(snapshot, kDue + std::chrono::milliseconds(milliseconds));
    QVERIFY(ghost);
    QCOMPARE(ghost->position.x, x);
    snapshot.interval = Clock::duration::zero();
    QCOMPARE(interpolatedGhost(snapshot, kDue)->position.x, 3.0);
}

void TestSnapshot::withoutAComparisonThereIsNoGhost() { QVERIFY(!interpolatedGhost(snapshotOf(1.0, 3.0), kDue)); }

void TestSnapshot::pausedBallIsTheCurrentState() {
    Snapshot snapshot = snapshotOf(1.0, 3.0);
    snapshot.interval = Clock::duration::zero();
    QCOMPARE(interpolated(snapshot, kDue).position.x, 3.0);
}

// q and -q are the same orientation; halfway between the ends of a quarter turn is an eighth of a turn.
void TestSnapshot::orientationTakesTheShorterWayAndStaysUnit() {
    Snapshot snapshot = snapshotOf(0.0, 0.0);
    const double half = std::sqrt(0.5);
    snapshot.current.orientation[2] = -half;
    snapshot.current.orientation[3] = -half;
    const phys_state drawn = interpolated(snapshot, kDue + 5ms);
    QVERIFY(std::abs(drawn.orientation[2] - std::sin(M_PI / 8)) < 1e-15); // rounding of a few operations
    QVERIFY(std::abs(drawn.orientation[3] - std::cos(M_PI / 8)) < 1e-15);
}

QTEST_GUILESS_MAIN(TestSnapshot)
#include "tst_snapshot.moc"
