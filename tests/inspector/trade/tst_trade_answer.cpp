// SPDX-License-Identifier: MIT
// Which points are best for their cost, and which one is recommended, for made-up points.
#include "core/events/bounce.h"
#include "core/program/trade_command.h"
#include "core/schedule/trade_reference.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_chart.h"

#include <QTest>

using namespace inspector;

class TestTradeAnswer : public QObject {
    Q_OBJECT

private slots:
    void frontIsWhatNoOtherPointBeats();
    void equalPointsAreOnTheFrontOnce();
    void equallyCheapPointsAreJudgedByTheirError();
    void noPointsHaveNoFront();
    void errorUntilATimeIsTheLastRecordUpToIt_data();
    void errorUntilATimeIsTheLastRecordUpToIt();
    void cheapestKeepsTheErrorForTheTimeAskedOnly();
    void errorEqualToTheLimitIsAllowed();
    void mostAccurateObeysTheCostOfAStep();
    void equallyAccurateStepsAreJudgedByTheCostOfASecond();
    void nothingIsRecommendedWhereNothingFits();
    void recommendationIsTheOptionsToTypeIn();
    void timeBeyondTheComparisonIsSaid();
    void unmeasuredPointsAreNotToChooseFrom();
    void impactsAreWrongWhenMissingInventedOrSwapped_data();
    void impactsAreWrongWhenMissingInventedOrSwapped();
    void impactNearTheCountedSpeedIsNotWrong();
};

namespace {

// ns per step, microseconds per second, radii.
TradePoint point(double perStep, double perSecond, double error) {
    TradePoint result;
    result.stepper = "rk4";
    result.dt = 0.01;
    result.isValid = true;
    result.cost = {perStep * 1e-9, perSecond * 1e-6, 0.0, 5};
    result.error.positionLargest = error;
    result.error.growth = {{1.0, error}};
    return result;
}

using Indices = std::vector<size_t>;

Indices frontOf(const std::vector<ChartPoint> &points) {
    Indices indices;
    for (const ChartPoint &point : paretoFront(points)) indices.push_back(point.index);
    return indices;
}

} // namespace

void TestTradeAnswer::frontIsWhatNoOtherPointBeats() {
    QCOMPARE(frontOf({{0, 40.0, 0.01}, {1, 10.0, 1.0}, {2, 20.0, 2.0}, {3, 30.0, 0.1}, {4, 50.0, 0.01}}),
             (Indices{1, 3, 0}));
}

void TestTradeAnswer::equalPointsAreOnTheFrontOnce() {
    QCOMPARE(frontOf({{0, 10.0, 1.0}, {1, 10.0, 1.0}}), Indices{0});
}

void TestTradeAnswer::equallyCheapPointsAreJudgedByTheirError() {
    QCOMPARE(frontOf({{0, 10.0, 1.0}, {1, 10.0, 0.5}}), Indices{1});
}

void TestTradeAnswer::noPointsHaveNoFront() { QVERIFY(frontOf({}).empty()); }

void TestTradeAnswer::errorUntilATimeIsTheLastRecordUpToIt_data() {
    QTest::addColumn<double>("time");
    QTest::addColumn<double>("error");
    QTest::newRow("before the first") << 0.5 << 0.0;
    QTest::newRow("at the first") << 1.0 << 0.1;
    QTest::newRow("between") << 1.9 << 0.1;
    QTest::newRow("at the last") << 2.0 << 0.4;
    QTest::newRow("after the last") << 9.0 << 0.4;
}

void TestTradeAnswer::errorUntilATimeIsTheLastRecordUpToIt() {
    QFETCH(double, time);
    QFETCH(double, error);
    TradePoint grows = point(1, 1, 0.4);
    grows.error.growth = {{1.0, 0.1}, {2.0, 0.4}};
    QVERIFY(errorUntil(grows, time) == error);
}

void TestTradeAnswer::cheapestKeepsTheErrorForTheTimeAskedOnly() {
    std::vector<TradePoint> points{point(1, 30, 0.01), point(1, 10, 5.0)};
    points[1].error.growth = {{1.0, 0.01}, {3.0, 5.0}};
    QCOMPARE(cheapestUnder(points, 0.1, 2.0), std::optional<size_t>(1));
    QCOMPARE(cheapestUnder(points, 0.1, 3.0), std::optional<size_t>(0));
}

void TestTradeAnswer::errorEqualToTheLimitIsAllowed() {
    const std::vector<TradePoint> points{point(1, 10, 0.1)};
    QCOMPARE(cheapestUnder(points, 0.1, 2.0), std::optional<size_t>(0));
    QCOMPARE(cheapestUnder(points, 0.0999, 2.0), std::optional<size_t>());
}

void TestTradeAnswer::mostAccurateObeysTheCostOfAStep() {
    const std::vector<TradePoint> points{point(100, 1, 0.3), point(300, 1, 0.1), point(301, 1, 0.01)};
    QCOMPARE(mostAccurateWithin(points, 300.0), std::optional<size_t>(1));
    QCOMPARE(mostAccurateWithin(points, 99.0), std::optional<size_t>());
}

void TestTradeAnswer::equallyAccurateStepsAreJudgedByTheCostOfASecond() {
    const std::vector<TradePoint> points{point(100, 20, 0.0), point(200, 10, 0.0)};
    QCOMPARE(mostAccurateWithin(points, 300.0), std::optional<size_t>(1));
}

void TestTradeAnswer::nothingIsRecommendedWhereNothingFits() {
    TradeResult result;
    result.points = {point(1, 10, 0.5)};
    result.spans.resize(1);
    result.spans[0][PHYS_MODEL_ROLLING].compared = 3.0;
    TradeOptions wish;
    wish.under = {0.25, true};
    const Recommendation answer = recommend(result, PHYS_MODEL_ROLLING, wish, 0.006);
    QVERIFY(!answer.point);
    QCOMPARE(answer.line, QString("none: nothing keeps the error at or under 0.25 R for 3 s"));
}

void TestTradeAnswer::recommendationIsTheOptionsToTypeIn() {
    TradeResult result;
    result.points = {point(120, 10, 0.5)};
    result.spans.resize(1);
    result.spans[0][PHYS_MODEL_ROLLING].compared = 3.0;
    TradeOptions wish;
    wish.under = {0.004, false}; // 1 R, exactly
    const Recommendation answer = recommend(result, PHYS_MODEL_ROLLING, wish, 0.004);
    QCOMPARE(answer.line, QString("--stepper rk4 --dt 0.01  # error 2 mm = 0.5 R in 3 s, 120 ns a step, 10 µs a "
                                  "simulated second"));
}

void TestTradeAnswer::timeBeyondTheComparisonIsSaid() {
    TradeResult result;
    result.points = {point(120, 10, 0.01)};
    result.spans.resize(1);
    result.spans[0][PHYS_MODEL_ROLLING].compared = 3.0;
    TradeOptions wish;
    wish.seconds = 60.0;
    const QString line = recommend(result, PHYS_MODEL_ROLLING, wish, 0.006).line;
    QVERIFY2(line.endsWith("(60 s were asked for; beyond 3 s there is nothing to compare with)"), qPrintable(line));
}

void TestTradeAnswer::unmeasuredPointsAreNotToChooseFrom() {
    TradeResult result;
    result.points = {point(1, 1, 0.1), point(1, 1, 0.1), point(1, 1, 0.1), point(1, 1, 0.1)};
    result.points[0].isValid = false;
    result.points[1].cost.repeats = 0;
    result.points[2].model = PHYS_MODEL_RIGID;
    result.points[3].dt = 0.25;
    const std::vector<TradePoint> valid = result.valid(PHYS_MODEL_ROLLING);
    QCOMPARE(valid.size(), size_t(1));
    QCOMPARE(valid[0].dt, 0.25);
}

void TestTradeAnswer::impactsAreWrongWhenMissingInventedOrSwapped_data() {
    QTest::addColumn<QList<uint32_t>>("expected");
    QTest::addColumn<QList<uint32_t>>("found");
    QTest::addColumn<int>("wrong");
    QTest::newRow("none") << QList<uint32_t>{} << QList<uint32_t>{} << 0;
    QTest::newRow("same") << QList<uint32_t>{3, 1, 3} << QList<uint32_t>{3, 1, 3} << 0;
    QTest::newRow("missing") << QList<uint32_t>{3, 1, 3} << QList<uint32_t>{3, 3} << 1;
    QTest::newRow("invented") << QList<uint32_t>{3, 1} << QList<uint32_t>{3, 2, 2, 1} << 2;
    QTest::newRow("swapped: one of two misses its place, on both sides")
        << QList<uint32_t>{3, 1} << QList<uint32_t>{1, 3} << 2;
    QTest::newRow("another box") << QList<uint32_t>{3} << QList<uint32_t>{4} << 2;
}

void TestTradeAnswer::impactsAreWrongWhenMissingInventedOrSwapped() {
    QFETCH(QList<uint32_t>, expected);
    QFETCH(QList<uint32_t>, found);
    QFETCH(int, wrong);
    const auto impacts = [](const QList<uint32_t> &boxes) {
        std::vector<Impact> result;
        for (const uint32_t box : boxes) result.push_back({double(result.size()), box, 1.0});
        return result;
    };
    QCOMPARE(wrongImpacts(impacts(expected), impacts(found)), wrong);
}

void TestTradeAnswer::impactNearTheCountedSpeedIsNotWrong() {
    QCOMPARE(wrongImpacts({{0.0, 7, 1.01 * kCountedImpact}}, {{0.0, 7, 0.99 * kCountedImpact}}), 0);
    QCOMPARE(wrongImpacts({{0.0, 7, 0.99 * kCountedImpact}}, {}), 0);
}

QTEST_GUILESS_MAIN(TestTradeAnswer)
#include "tst_trade_answer.moc"
