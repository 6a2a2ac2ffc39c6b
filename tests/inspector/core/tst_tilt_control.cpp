// SPDX-License-Identifier: MIT
// Arrow keys to tilt.
#include "core/pilot/tilt_control.h"

#include <QTest>

#include <cmath>

using namespace inspector;

class TestTiltControl : public QObject {
    Q_OBJECT

private slots:
    void eachKeyTiltsItsOwnWay_data();
    void eachKeyTiltsItsOwnWay();
    void tiltGrowsSmoothlyAndNeverBeyondTheLimit();
    void releasedKeyLetsTheBoardComeBackToLevelAndRest();
    void oppositeKeysCancel();
    void frameRateMakesNoDifference();
    void startsFromTheTiltItIsPutTo();
    void noTimeChangesNothing();
};

namespace {

const double kLimit = radians(kPlayTilt);

Tilt after(TiltControl &control, double seconds) {
    for (int i = 0; i < int(std::round(seconds * 100)); ++i) control.advance(0.01);
    return control.tilt();
}

} // namespace

void TestTiltControl::eachKeyTiltsItsOwnWay_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::newRow("left") << 0 << -1 << 0;
    QTest::newRow("right") << 1 << 1 << 0;
    QTest::newRow("up") << 2 << 0 << 1;
    QTest::newRow("down") << 3 << 0 << -1;
}

void TestTiltControl::eachKeyTiltsItsOwnWay() {
    QFETCH(int, key);
    QFETCH(int, x);
    QFETCH(int, y);
    TiltControl control;
    control.setKeys({key == 0, key == 1, key == 2, key == 3});
    const Tilt tilt = after(control, 3.0);
    // 25 time constants: exp(-25) of the way is left.
    QVERIFY(std::abs(tilt.x - x * kLimit) < 1e-9);
    QVERIFY(std::abs(tilt.y - y * kLimit) < 1e-9);
}

void TestTiltControl::tiltGrowsSmoothlyAndNeverBeyondTheLimit() {
    TiltControl control;
    control.setKeys({.right = true});
    double before = 0.0;
    // The fastest that a critically damped spring moves from rest is limit / (e tau).
    const double fastest = kLimit / (M_E * TiltControl::kResponse) * 0.01 * (1.0 + 1e-12);
    for (int i = 0; i < 300; ++i) {
        const double now = control.advance(0.01).x;
        QVERIFY(now >= before && now <= kLimit);
        QVERIFY(now - before <= fastest);
        before = now;
    }
}

void TestTiltControl::releasedKeyLetsTheBoardComeBackToLevelAndRest() {
    TiltControl control;
    control.setKeys({.up = true});
    after(control, 1.0);
    QVERIFY(!control.isAtRest());
    control.setKeys({});
    QVERIFY(!control.isAtRest());
    after(control, 3.0);
    QCOMPARE(control.tilt().y, 0.0); // exactly, so that it ends
    QVERIFY(control.isAtRest());
}

void TestTiltControl::oppositeKeysCancel() {
    TiltControl control;
    control.setKeys({true, true, true, true});
    QCOMPARE(after(control, 1.0).x, 0.0);
    QCOMPARE(control.tilt().y, 0.0);
}

// The spring is solved exactly, so only rounding separates 10 pictures a second from 1000.
void TestTiltControl::frameRateMakesNoDifference() {
    TiltControl slow;
    TiltControl fast;
    slow.setKeys({.left = true});
    fast.setKeys({.left = true});
    for (int i = 0; i < 4; ++i) slow.advance(0.1);
    for (int i = 0; i < 400; ++i) fast.advance(0.001);
    QVERIFY(std::abs(slow.tilt().x - fast.tilt().x) < 1e-13);
}

void TestTiltControl::startsFromTheTiltItIsPutTo() {
    TiltControl control;
    control.setTilt({radians(5.0), 0.0});
    QCOMPARE(control.tilt().x, radians(5.0));
    QVERIFY(control.advance(0.01).x < radians(5.0));
    QVERIFY(control.tilt().x > 0.0);
}

void TestTiltControl::noTimeChangesNothing() {
    TiltControl control;
    control.setTilt({0.05, -0.02});
    control.setKeys({.right = true});
    QVERIFY(std::abs(control.advance(0.0).x - 0.05) < 1e-16);
}

QTEST_GUILESS_MAIN(TestTiltControl)
#include "tst_tilt_control.moc"
