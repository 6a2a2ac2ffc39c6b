// SPDX-License-Identifier: MIT
// Deadlines: absolute, with a limited backlog. Times are passed in, so no test waits.
#include "core/engine/pacer.h"
#include "core/engine/rate_meter.h"

#include <QTest>

using namespace inspector;
using namespace std::chrono_literals;

class TestPacer : public QObject {
    Q_OBJECT

private slots:
    void firstStepIsDueAfterOneInterval();
    void speedShortensTheInterval_data();
    void speedShortensTheInterval();
    void deadlinesDontDrift();
    void lateStepDoesntMoveTheNextDeadline();
    void shortBacklogIsCaughtUpInFull();
    void stallOfFiveSecondsIsDroppedAndCounted();
    void stepsAfterAStallKeepTheirPace();
    void tooSlowStepsLoseTimeWithoutEnd();
    void ratesAreThoseOfTheLastHalfSecond();
    void ratesStartUnknown();
};

namespace {

const Clock::time_point kStart{1000s};

// The number of steps made at `now`.
int stepsDue(Pacer &pacer, Clock::time_point now) {
    int steps = 0;
    for (; pacer.isDue(now); ++steps) pacer.advance();
    return steps;
}

} // namespace

void TestPacer::firstStepIsDueAfterOneInterval() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    QVERIFY(!pacer.isDue(kStart + 10ms - 1ns));
    QVERIFY(pacer.isDue(kStart + 10ms));
}

void TestPacer::speedShortensTheInterval_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<qint64>("nanoseconds");
    QTest::newRow("1/16") << 1.0 / 16.0 << qint64(160'000'000);
    QTest::newRow("1") << 1.0 << qint64(10'000'000);
    QTest::newRow("16") << 16.0 << qint64(625'000);
}

void TestPacer::speedShortensTheInterval() {
    QFETCH(double, speed);
    QFETCH(qint64, nanoseconds);
    Pacer pacer;
    pacer.start(kStart, 0.01, speed);
    QCOMPARE(pacer.interval(), std::chrono::nanoseconds(nanoseconds));
}

// A third of a millisecond isn't a whole number of nanoseconds: summed, it would be off by 100 us after 300,000 steps.
void TestPacer::deadlinesDontDrift() {
    Pacer pacer;
    pacer.start(kStart, 0.001, 3.0);
    for (int i = 0; i < 300000 - 1; ++i) pacer.advance();
    QCOMPARE(pacer.deadline(), kStart + 100s);
}

void TestPacer::lateStepDoesntMoveTheNextDeadline() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    QVERIFY(pacer.isDue(kStart + 17ms));
    pacer.advance();
    QCOMPARE(pacer.deadline(), kStart + 20ms);
}

void TestPacer::shortBacklogIsCaughtUpInFull() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    QCOMPARE(stepsDue(pacer, kStart + 100ms), 10);
    QCOMPARE(pacer.lostTime(), 0.0);
}

void TestPacer::stallOfFiveSecondsIsDroppedAndCounted() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    QCOMPARE(stepsDue(pacer, kStart + 10ms), 1);
    QCOMPARE(stepsDue(pacer, kStart + 20ms + 5s), 1); // the one that was due; the rest isn't caught up with
    QCOMPARE(pacer.lostTime(), 5.0);
}

void TestPacer::stepsAfterAStallKeepTheirPace() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    const Clock::time_point back = kStart + 5s;
    QCOMPARE(stepsDue(pacer, back), 1);
    QVERIFY(!pacer.isDue(back + 10ms - 1ns));
    QCOMPARE(stepsDue(pacer, back + 50ms), 5);
    QCOMPARE(pacer.lostTime(), 4.99); // exactly what the stall lost
}

// Steps that take 30 ms but are due every 10 ms: two thirds of the time are lost.
void TestPacer::tooSlowStepsLoseTimeWithoutEnd() {
    Pacer pacer;
    pacer.start(kStart, 0.01, 1.0);
    Clock::time_point now = kStart + 10ms;
    int steps = 0;
    for (; now <= kStart + 30s; now += 30ms, ++steps) {
        QVERIFY(pacer.isDue(now));
        pacer.advance();
    }
    const double simulated = steps * 0.01;
    // All time is either simulated or lost, except for a backlog that is still allowed.
    QVERIFY(std::abs(30.0 - simulated - pacer.lostTime()) <= 0.1 + 0.03);
}

void TestPacer::ratesAreThoseOfTheLastHalfSecond() {
    RateMeter meter;
    meter.start(kStart);
    for (int i = 1; i <= 100; ++i) meter.count(kStart + i * 5ms, 0.01);
    QCOMPARE(meter.stepsPerSecond(), 200.0);
    QCOMPARE(meter.speed(), 2.0);
    for (int i = 1; i <= 50; ++i) meter.count(kStart + 500ms + i * 10ms, 0.01);
    QCOMPARE(meter.stepsPerSecond(), 100.0);
    QCOMPARE(meter.speed(), 1.0);
}

void TestPacer::ratesStartUnknown() {
    RateMeter meter;
    meter.start(kStart);
    meter.count(kStart + 10ms, 0.01);
    QCOMPARE(meter.stepsPerSecond(), 0.0);
}

QTEST_GUILESS_MAIN(TestPacer)
#include "tst_pacer.moc"
