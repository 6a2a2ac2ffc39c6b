// SPDX-License-Identifier: MIT
// The latest-value slot: the newest value wins, none is torn, nobody waits.
#include "core/simulation/latest_value.h"

#include <QTest>

#include <array>
#include <thread>

using namespace inspector;

class TestLatestValue : public QObject {
    Q_OBJECT

private slots:
    void nothingIsFreshBeforeTheFirstPublish();
    void latestWins();
    void takenValueStaysUntilTheNextTake();
    void valuesFromAnotherThreadAreWholeAndNeverGoBack();
};

void TestLatestValue::nothingIsFreshBeforeTheFirstPublish() {
    LatestValue<int> slot(7);
    QVERIFY(!slot.isFresh());
    QVERIFY(!slot.take());
    QCOMPARE(slot.value(), 7);
}

void TestLatestValue::latestWins() {
    LatestValue<int> slot(0);
    for (int i = 1; i <= 5; ++i) slot.publish(i);
    QVERIFY(slot.take());
    QCOMPARE(slot.value(), 5);
    QVERIFY(!slot.take());
}

void TestLatestValue::takenValueStaysUntilTheNextTake() {
    LatestValue<int> slot(0);
    slot.publish(1);
    QVERIFY(slot.take());
    slot.publish(2);
    slot.publish(3);
    QCOMPARE(slot.value(), 1);
    QVERIFY(slot.take());
    QCOMPARE(slot.value(), 3);
}

// All words of a value are equal, and the sequence only grows, up to the last value published.
void TestLatestValue::valuesFromAnotherThreadAreWholeAndNeverGoBack() {
    constexpr uint64_t kValues = 200000;
    using Value = std::array<uint64_t, 100>;
    LatestValue<Value> slot(Value{});
    std::jthread publisher([&] {
        Value value;
        for (uint64_t i = 1; i <= kValues; ++i) {
            value.fill(i);
            slot.publish(value);
        }
    });
    uint64_t seen = 0;
    while (seen < kValues) {
        if (!slot.take()) continue;
        const Value &value = slot.value();
        QVERIFY(value.front() > seen);
        seen = value.front();
        for (const uint64_t word : value) QCOMPARE(word, seen);
    }
}

QTEST_GUILESS_MAIN(TestLatestValue)
#include "tst_latest_value.moc"
