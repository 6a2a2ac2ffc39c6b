// SPDX-License-Identifier: MIT
// The ring of samples: what it keeps, and that the pyramid has the same extremes as the samples.
#include "core/simulation/sample_ring.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>

using namespace inspector;

class TestSampleRing : public QObject {
    Q_OBJECT

private slots:
    void capacityIsAPowerOfTwo();
    void samplesReadBackInFull();
    void oldestAreOverwritten();
    void clearStartsAnewButNumbersGoOn();
    void findIsTheFirstAtOrAfterATime();
    void fewSamplesAreShownOneByOne();
    void columnsHoldTheExtremesOfTheirSamples();
    void columnsNeverExceedWhatWasAskedFor();
    void columnsStayWhereTheyAreWhileThePlotScrolls();
    void columnsSpanNoMoreThanTheirShareOfTheTimeAfterStepsGetShorter();
    void spreadSamplesAreEvenInTimeAfterStepsGetShorter();
    void emptyRingHasNoColumns();
    void missingValuesCountInNoColumn();
    void heldSamplesAreSeenAllAtOnce();
    void readingWhileAnotherThreadAppendsGivesOnlyWholeSamples();
};

namespace {

constexpr double kSampleDt = 0.01;

// Every value follows from the number, so that a torn sample shows.
Sample sampleOf(uint64_t number) {
    Sample sample;
    sample.time = double(number) * kSampleDt;
    sample.step = number;
    for (size_t i = 0; i < kChannelCount; ++i) sample.values[i] = double(number * 100 + i);
    return sample;
}

bool isWhole(const Sample &sample, uint64_t number) {
    const Sample expected = sampleOf(number);
    return sample.time == expected.time && sample.step == expected.step && sample.values == expected.values;
}

void fill(SampleRing &ring, uint64_t count) {
    for (uint64_t i = 0; i < count; ++i) ring.append(sampleOf(i));
}

constexpr double kEnd = 6.5; // s

/// 2.5 s in steps of 10 ms, then 4 s in steps of 0.1 ms; the speed is the time.
void fillWithShorterSteps(SampleRing &ring) {
    double time = 0.0;
    for (uint64_t i = 1; time < kEnd; ++i) {
        time += i <= 250 ? 0.01 : 0.0001;
        Sample sample = sampleOf(i);
        sample.time = sample[Channel::Speed] = time;
        ring.append(sample);
    }
}

} // namespace

void TestSampleRing::capacityIsAPowerOfTwo() {
    QCOMPARE(SampleRing(1).capacity(), size_t(256));
    QCOMPARE(SampleRing(1000).capacity(), size_t(1024));
    QCOMPARE(SampleRing(4096).capacity(), size_t(4096));
}

void TestSampleRing::samplesReadBackInFull() {
    SampleRing ring(256);
    fill(ring, 100);
    QCOMPARE(ring.first(), uint64_t(0));
    QCOMPARE(ring.last(), uint64_t(100));
    Sample sample;
    for (uint64_t i = 0; i < 100; ++i) {
        QVERIFY(ring.read(i, sample));
        QVERIFY(isWhole(sample, i));
    }
    QVERIFY(!ring.read(100, sample));
}

void TestSampleRing::oldestAreOverwritten() {
    SampleRing ring(256);
    fill(ring, 1000);
    QCOMPARE(ring.first(), uint64_t(1000 - 256));
    Sample sample;
    QVERIFY(!ring.read(ring.first() - 1, sample));
    QVERIFY(ring.read(ring.first(), sample));
    QVERIFY(isWhole(sample, 1000 - 256));
}

void TestSampleRing::clearStartsAnewButNumbersGoOn() {
    SampleRing ring(256);
    fill(ring, 50);
    ring.clear();
    QCOMPARE(ring.first(), ring.last());
    QCOMPARE(ring.generation(), uint64_t(1));
    ring.append(sampleOf(0)); // time may decrease now
    QCOMPARE(ring.first(), uint64_t(50));
    QCOMPARE(ring.last(), uint64_t(51));
    QCOMPARE(ring.columns(Channel::Speed, 0.0, 1.0, 10).size(), size_t(1));
}

void TestSampleRing::findIsTheFirstAtOrAfterATime() {
    SampleRing ring(256);
    fill(ring, 1000);
    QCOMPARE(ring.find(-1.0), ring.first());
    QCOMPARE(ring.find(900 * kSampleDt), uint64_t(900));
    QCOMPARE(ring.find(900.5 * kSampleDt), uint64_t(901));
    QCOMPARE(ring.find(1e9), ring.last());
}

void TestSampleRing::fewSamplesAreShownOneByOne() {
    SampleRing ring(256);
    fill(ring, 100);
    const std::vector<Column> columns = ring.columns(Channel::Speed, 9.5 * kSampleDt, 19.5 * kSampleDt, 100);
    QCOMPARE(columns.size(), size_t(12)); // 10 .. 19 and one on each side
    for (size_t i = 0; i < columns.size(); ++i) {
        const Sample expected = sampleOf(9 + i);
        QCOMPARE(columns[i].time, expected.time);
        QCOMPARE(columns[i].min, expected[Channel::Speed]);
        QCOMPARE(columns[i].max, expected[Channel::Speed]);
    }
}

// Compared with a plain loop over all samples, for random signals, ranges and widths, including wrapped rings.
void TestSampleRing::columnsHoldTheExtremesOfTheirSamples() {
    constexpr unsigned kSeed = 20;
    std::mt19937 random(kSeed);
    std::vector<double> values(9000);
    for (double &value : values) value = double(random() % 100000) - 50000.0;
    SampleRing ring(4096);
    for (size_t i = 0; i < values.size(); ++i) {
        Sample sample = sampleOf(i);
        sample.values[size_t(Channel::VelocityX)] = values[i];
        ring.append(sample);
    }
    for (int round = 0; round < 200; ++round) {
        const double from = double(4904 + random() % 4000) * kSampleDt;
        const double to = from + double(random() % 4000) * kSampleDt;
        const std::vector<Column> columns = ring.columns(Channel::VelocityX, from, to, 1 + random() % 300);
        QVERIFY(!columns.empty());
        const uint64_t end = std::min(ring.last(), ring.find(to) + 1);
        for (size_t i = 0; i < columns.size(); ++i) {
            const auto begin = values.begin() + long(ring.find(columns[i].time));
            const auto stop = i + 1 < columns.size() ? values.begin() + long(ring.find(columns[i + 1].time))
                                                     : values.begin() + long(end);
            QCOMPARE(columns[i].min, *std::min_element(begin, stop));
            QCOMPARE(columns[i].max, *std::max_element(begin, stop));
        }
    }
}

void TestSampleRing::columnsNeverExceedWhatWasAskedFor() {
    SampleRing ring(4096);
    fill(ring, 5000);
    for (const size_t wanted : {size_t(2), size_t(3), size_t(10), size_t(333), size_t(1000)}) {
        const size_t found = ring.columns(Channel::Speed, 0.0, 1e9, wanted).size();
        QVERIFY(found <= wanted);
        QVERIFY(2 * found + 2 >= std::min<size_t>(wanted, 4096)); // detail isn't thrown away either
    }
}

void TestSampleRing::columnsStayWhereTheyAreWhileThePlotScrolls() {
    SampleRing ring(4096);
    fill(ring, 4000);
    const std::vector<Column> before = ring.columns(Channel::Speed, 10.0, 30.0, 500);
    const std::vector<Column> after = ring.columns(Channel::Speed, 10.0 + kSampleDt, 30.0 + kSampleDt, 500);
    // All columns are the same except for those cut by the plot's borders.
    for (size_t i = 1; i + 1 < after.size(); ++i) {
        const auto isSame = [&](const Column &column) {
            return column.time == after[i].time && column.min == after[i].min && column.max == after[i].max;
        };
        QVERIFY(std::any_of(before.begin(), before.end(), isSame));
    }
    QVERIFY(after.size() > 100);
}

void TestSampleRing::columnsSpanNoMoreThanTheirShareOfTheTimeAfterStepsGetShorter() {
    SampleRing ring(65536);
    fillWithShorterSteps(ring);
    constexpr size_t kColumns = 1000;
    for (const Column &column : ring.columns(Channel::Speed, 0.0, kEnd, kColumns)) {
        QCOMPARE(column.min, column.time);
        QVERIFY(column.max - column.time <= 2.0 * kEnd / kColumns);
    }
}

void TestSampleRing::spreadSamplesAreEvenInTimeAfterStepsGetShorter() {
    SampleRing ring(65536);
    fillWithShorterSteps(ring);
    const std::vector<Sample> samples = ring.spread(ring.first(), ring.last(), 1000);
    QVERIFY(samples.size() <= 1001);
    for (size_t i = 1; i < samples.size(); ++i) QVERIFY(samples[i].time - samples[i - 1].time < 0.011);
}

void TestSampleRing::emptyRingHasNoColumns() {
    const SampleRing ring(256);
    QVERIFY(ring.columns(Channel::Speed, 0.0, 1.0, 100).empty());
    QCOMPARE(ring.find(0.0), uint64_t(0));
}

void TestSampleRing::heldSamplesAreSeenAllAtOnce() {
    SampleRing ring(256);
    fill(ring, 50);
    ring.hold();
    ring.clear();
    ring.append(sampleOf(0));
    ring.append(sampleOf(1));
    Sample sample;
    QCOMPARE(ring.last() - ring.first(), uint64_t(50));
    QCOMPARE(ring.generation(), uint64_t(0));
    QVERIFY(ring.read(49, sample));
    QVERIFY(!ring.read(50, sample));
    ring.release();
    QCOMPARE(ring.first(), uint64_t(50));
    QCOMPARE(ring.last(), uint64_t(52));
    QCOMPARE(ring.generation(), uint64_t(1));
    QVERIFY(!ring.read(49, sample));
    QVERIFY(ring.read(51, sample) && sample.time == sampleOf(1).time);
}

// Values in the samples 100 to 199 of 300 only, at every zoom.
void TestSampleRing::missingValuesCountInNoColumn() {
    SampleRing ring(1024);
    constexpr uint64_t kCount = 300;
    for (uint64_t i = 0; i < kCount; ++i) {
        Sample sample = sampleOf(i);
        if (i < 100 || i >= 200) sample[Channel::Distance] = std::nan("");
        ring.append(sample);
    }
    for (const size_t columns : {1, 3, 10, 40, 300}) {
        double min = std::nan("");
        double max = std::nan("");
        for (const Column &column : ring.columns(Channel::Distance, 0.0, kCount * kSampleDt, columns)) {
            QCOMPARE(std::isnan(column.min), std::isnan(column.max));
            min = std::fmin(min, column.min);
            max = std::fmax(max, column.max);
        }
        QCOMPARE(min, sampleOf(100)[Channel::Distance]);
        QCOMPARE(max, sampleOf(199)[Channel::Distance]);
    }
    for (const Column &column : ring.columns(Channel::Distance, 0.0, kCount * kSampleDt, 300))
        QCOMPARE(std::isnan(column.min), column.time < sampleOf(100).time || column.time > sampleOf(199).time);
}

// read() and columns() never return anything older than what the ring then still holds, or torn values.
void TestSampleRing::readingWhileAnotherThreadAppendsGivesOnlyWholeSamples() {
    constexpr int kReads = 20000;
    SampleRing ring(256);
    const std::jthread writer([&](const std::stop_token &stop) {
        for (uint64_t i = 0; !stop.stop_requested(); ++i) ring.append(sampleOf(i));
    });
    for (int reads = 0; reads < kReads;) {
        const uint64_t number = ring.first() + ring.capacity() / 2;
        Sample sample;
        if (ring.read(number, sample)) {
            QVERIFY(isWhole(sample, number));
            ++reads;
        }
        if (reads % 100 != 0) continue;
        for (const Column &column : ring.columns(Channel::PositionX, 0.0, 1e9, 16)) QVERIFY(column.min <= column.max);
    }
}

QTEST_GUILESS_MAIN(TestSampleRing)
#include "tst_sample_ring.moc"
