// SPDX-License-Identifier: MIT
// What is unknown about a board: its text form, sampled boards, and the ball's deviation, compared with closed forms.
#include "core/program/trade_command.h"
#include "core/trade/good_enough.h"
#include "core/trade/trade_options.h"
#include "inspector/core/scenes.h"
#include "inspector/trade/unknowns_of.h"
#include "support/compare.h"

#include <algorithm>

using namespace inspector;

class TestTradeUnknowns : public QObject {
    Q_OBJECT

private slots:
    void wordsNameQuantitiesWithUnits_data();
    void wordsNameQuantitiesWithUnits();
    void wrongWordsAreOneLine_data();
    void wrongWordsAreOneLine();
    void textReadsBackTheSame();
    void boardsLieWithinTheAmounts();
    void boardsStayWithinTheRangesOfTheirRows();
    void bandOfAnUnknownStartStaysWhatItIs();
    void bandOfAnUnknownTiltGrowsWithTheSquareOfTime();
    void nothingUnknownHasNoBand();
    void bandTellsWhenItReachesALength();
    void busyScheduleMeetsWalls();
    void nothingIsAskedBeyondTheSchedules();
    void goodEnoughIsTheCheapestBelowTheShare();
    void smallerShareIsNeverMetByACheaperSetting();
    void settingThatFailsElsewhereIsPassedOverAndNamed();
};

namespace {

constexpr double kBallRadius = 0.006;

// A ball on an open floor whose tilt is unknown, in two step sizes.
TradePlan unknownTilt() {
    TradePlan plan;
    plan.registry = makeRegistry(nullptr);
    plan.scene = openFloor();
    plan.inputs = initialInputs();
    plan.schedules = {randomSchedule(3, 1.0)};
    plan.stepSizes = {0.05, 0.01};
    plan.repeats = 1;
    plan.unknowns = unknownsOf("tilt=0.1deg");
    return plan;
}

Band bandOf(const Scene &scene, Tilt tilt, double duration, const char *words) {
    const Registry registry = makeRegistry(nullptr);
    Inputs inputs = initialInputs();
    inputs.params.rolling_friction = 0.0;
    QString error;
    const auto reference = TradeReference::run(registry, scene, inputs.params,
                                               segmentsOf({"tilt", {{0.0, tilt}}, duration}, inputs.gravity), &error);
    if (!reference) qFatal("%s", qPrintable(error));
    return uncertaintyBand({registry, scene, inputs, unknownsOf(words), 400, duration}, *reference, {});
}

} // namespace

void TestTradeUnknowns::wordsNameQuantitiesWithUnits_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("amount");
    QTest::addColumn<bool>("isShare");
    QTest::newRow("degrees") << "tilt=0.1deg" << 0.1 << false;
    QTest::newRow("bare degrees") << "tilt_x=0.1" << 0.1 << false;
    QTest::newRow("radians") << "tilt=0.01rad" << 0.01 * 180.0 / 3.141592653589793 << false;
    QTest::newRow("percent") << "rolling_friction=50%" << 0.5 << true;
    QTest::newRow("dashes") << "restitution-wall=0.04" << 0.04 << false;
    QTest::newRow("millimetres") << "start=0.1mm" << 0.1 * 1e-3 << false;
    QTest::newRow("gravity") << "gravity=0.02m/s^2" << 0.02 << false;
}

void TestTradeUnknowns::wordsNameQuantitiesWithUnits() {
    QFETCH(QString, words);
    QFETCH(double, amount);
    QFETCH(bool, isShare);
    const Unknowns unknowns = unknownsOf(qPrintable(words));
    QCOMPARE(unknowns.size(), size_t(1));
    COMPARE_EXACT(unknowns[0].amount, amount);
    QCOMPARE(unknowns[0].isShare, isShare);
}

void TestTradeUnknowns::wrongWordsAreOneLine_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("part");
    QTest::newRow("no such") << "weight=1"
                             << "found 'weight'";
    QTest::newRow("choice") << "model=1"
                            << "found 'model'";
    QTest::newRow("no amount") << "tilt"
                               << "as tilt=0.1deg; found nothing";
    QTest::newRow("zero") << "tilt=0"
                          << "an amount above 0";
    QTest::newRow("start has no percent")
        << "start=5%"
        << "start: expected a number from 0 to 1000 mm, found '5%', whose unit isn't one of: ";
    QTest::newRow("wrong unit")
        << "rolling_friction=1deg"
        << "rolling_friction: expected a number from 0 to 1e+06, found '1deg', where no unit belongs";
    QTest::newRow("tilt in metres")
        << "tilt=1m"
        << "tilt: expected a number from 0 to 80 \u00b0, found '1m', whose unit isn't one of: "
           "deg rad";
    QTest::newRow("share beyond 0") << "restitution_wall=500%"
                                    << "restitution_wall: expected a number from 0 to 100 %, found '500%'";
    QTest::newRow("more than there can be") << "restitution_wall=2"
                                            << "restitution_wall: expected a number from 0 to 1, found '2'";
    QTest::newRow("not finite") << "tilt=inf"
                                << "'inf', which isn't a finite number";
    QTest::newRow("twice") << "tilt=1,tilt=2"
                           << "'tilt' is named twice";
    QTest::newRow("nothing") << ""
                             << "found nothing";
}

void TestTradeUnknowns::wrongWordsAreOneLine() {
    QFETCH(QString, words);
    QFETCH(QString, part);
    QString error;
    QVERIFY(!parseUnknowns(words, &error));
    QVERIFY2(error.contains(part) && !error.contains('\n'), qPrintable(error));
}

void TestTradeUnknowns::textReadsBackTheSame() {
    const Unknowns unknowns = unknownsOf("tilt=0.1deg,rolling_friction=50%,restitution_wall=0.04,start=0.25mm");
    QVERIFY(unknownsOf(qPrintable(unknownsText(unknowns))) == unknowns);
    QVERIFY(unknownsOf(qPrintable(unknownsText({}))).empty());
}

// Uniform: the extremes of many samples come close to the amounts and never exceed them.
void TestTradeUnknowns::boardsLieWithinTheAmounts() {
    const Inputs inputs = initialInputs();
    double largestTilt = 0.0;
    double largestStart = 0.0;
    for (const SampledBoard &draw : sampleBoards(unknownsOf("tilt=0.1deg,start=0.1mm,gravity=1%"), inputs, 1000, 7)) {
        largestTilt = std::max({largestTilt, std::abs(draw.tiltOffset.x), std::abs(draw.tiltOffset.y)});
        largestStart = std::max({largestStart, std::abs(draw.startOffset.x), std::abs(draw.startOffset.y)});
        QVERIFY(std::abs(draw.gravity - inputs.gravity) <= 0.01 * inputs.gravity);
        COMPARE_EXACT(draw.startOffset.z, 0.0);
    }
    QVERIFY(largestTilt <= radians(0.1) && largestTilt > 0.95 * radians(0.1));
    QVERIFY(largestStart <= 0.0001 && largestStart > 0.95 * 0.0001);
}

void TestTradeUnknowns::boardsStayWithinTheRangesOfTheirRows() {
    Inputs inputs = initialInputs();
    inputs.params.model = PHYS_MODEL_RIGID;
    inputs.params.restitution_wall = 0.99;
    for (const SampledBoard &draw :
         sampleBoards(unknownsOf("restitution_wall=0.2,rolling_friction=1,sliding_friction=0.2"), inputs, 300, 7)) {
        phys_error failure;
        QVERIFY2(phys_params_check(&draw.params, &failure) == PHYS_OK, failure.text);
    }
}

// On a level board the ball stays where it is: its distance is that of two numbers, each uniform within the amount. A
// circle of radius r covers pi r^2 / 4 of the square: half of it at r = sqrt(2 / pi).
void TestTradeUnknowns::bandOfAnUnknownStartStaysWhatItIs() {
    const Band band = bandOf(openFloor(), {}, 1.0, "start=0.6mm");
    const double middle = 0.1 * std::sqrt(2.0 / 3.141592653589793);                                      // radii
    for (const double time : {0.0, 0.5, 1.0}) COMPARE_WITHIN(band.middleAt(time), middle, 0.1 * middle); // 400 draws
    QCOMPARE(band.balls, 400);
    QCOMPARE(band.refused, 0);
}

// 5/14 g (tan(tilt + d) - tan(tilt)) t^2 for small d: the same square.
void TestTradeUnknowns::bandOfAnUnknownTiltGrowsWithTheSquareOfTime() {
    const Band band = bandOf(openFloor(), {0.0, 0.0}, 1.0, "tilt=0.1deg");
    const double middle = 5.0 / 14.0 * 9.81 * radians(0.1) * std::sqrt(2.0 / 3.141592653589793) / kBallRadius;
    COMPARE_WITHIN(band.middleAt(1.0), middle, 0.1 * middle);
    COMPARE_WITHIN(band.middleAt(0.5), 0.25 * band.middleAt(1.0), 1e-6);
    for (size_t i = 0; i < band.times.size(); ++i)
        QVERIFY(band.low[i] <= band.middle[i] && band.middle[i] <= band.high[i]);
}

void TestTradeUnknowns::nothingUnknownHasNoBand() {
    const Band band = bandOf(openFloor(), {}, 1.0, "none");
    QVERIFY(band.isEmpty());
    COMPARE_EXACT(band.middleAt(1.0), 0.0);
    QVERIFY(!band.timeUntil(1.0));
}

void TestTradeUnknowns::bandTellsWhenItReachesALength() {
    Band band;
    band.times = {0.0, 1.0, 2.0};
    band.middle = {0.0, 0.5, 2.0};
    COMPARE_EXACT(*band.timeUntil(0.5), 1.0);
    COMPARE_EXACT(*band.timeUntil(1.0), 2.0);
    QVERIFY(!band.timeUntil(3.0));
    COMPARE_EXACT(band.middleAt(1.5), 1.25);
    COMPARE_EXACT(band.middleAt(9.0), 2.0);
}

void TestTradeUnknowns::busyScheduleMeetsWalls() {
    QString error;
    TradePlan plan;
    plan.registry = makeRegistry(&error);
    plan.scene = loadScene(QStringLiteral(LEVELS_FOLDER "/03.txt"), &error);
    QVERIFY2(plan.scene, qPrintable(error));
    plan.inputs = initialInputs();
    plan.stepSizes = {0.05};
    plan.repeats = 1;
    QVERIFY2(makeSchedules("busy", 2.0, plan, &error), qPrintable(error));
    const auto result = measureTrade(plan, {}, {}, &error);
    QVERIFY2(result, qPrintable(error));
    QVERIFY(result->spans[0][PHYS_MODEL_ROLLING].early > 0);
}

void TestTradeUnknowns::nothingIsAskedBeyondTheSchedules() {
    TradePlan plan = unknownTilt();
    plan.horizon = 30.0;
    QString error;
    QVERIFY2(makeSchedules("busy", 2.0, plan, &error), qPrintable(error));
    COMPARE_EXACT(plan.horizon, 2.0);
    COMPARE_EXACT(plan.askedHorizon, 30.0);
}

void TestTradeUnknowns::goodEnoughIsTheCheapestBelowTheShare() {
    QString error;
    TradePlan plan = unknownTilt();
    const auto result = measureTrade(plan, {}, {}, &error);
    QVERIFY2(result && result->goodEnough, qPrintable(error));
    const TradePoint &best = result->points[result->goodEnough->point];
    QVERIFY(*best.share < plan.share);
    for (const TradePoint &point : result->valid(PHYS_MODEL_ROLLING))
        QVERIFY(point.cost.perSecond >= best.cost.perSecond || *point.share >= plan.share);
}

// Only "exact" has no error, so the share that is asked for orders the answers.
void TestTradeUnknowns::smallerShareIsNeverMetByACheaperSetting() {
    QString error;
    TradePlan plan = unknownTilt();
    const auto result = measureTrade(plan, {}, {}, &error);
    QVERIFY2(result, qPrintable(error));
    double before = 0.0;
    for (const double share : {1.0, 0.1, 1e-3, 1e-6}) {
        plan.share = share;
        const std::stop_token stop;
        ValidationSchedules validations(plan, stop);
        const std::optional<GoodEnough> answer = cheapestGoodEnough(plan, *result, validations);
        QVERIFY(answer);
        const double cost = result->points[answer->point].cost.perSecond;
        QVERIFY(cost >= before);
        before = cost;
    }
}

// The cheapest setting seems to have no error on the plan's schedule, but has some on others.
void TestTradeUnknowns::settingThatFailsElsewhereIsPassedOverAndNamed() {
    QString error;
    TradePlan plan = unknownTilt();
    plan.share = 1e-6;
    auto result = measureTrade(plan, {}, {}, &error);
    QVERIFY2(result, qPrintable(error));
    TradePoint &lucky = result->points[0];
    lucky.cost.perSecond = 0.0;
    for (TradeError &each : lucky.errors) each.growth.clear();
    plan.validations = 2;
    const std::stop_token stop;
    ValidationSchedules validations(plan, stop);
    const std::optional<GoodEnough> answer = cheapestGoodEnough(plan, *result, validations);
    QVERIFY(answer && answer->point != 0);
    QCOMPARE(answer->passedOver.size(), size_t(1));
    QCOMPARE(answer->passedOver[0].point, size_t(0));
    QVERIFY(answer->passedOver[0].share.value_or(0.0) >= plan.share);
    result->goodEnough = answer;
    const QString line = recommendForUnknowns(plan, *result).line;
    QVERIFY2(line.contains("; cheaper --stepper explicit-euler --dt 0.05 is off by ") &&
                 line.endsWith(" % on an unseen schedule"),
             qPrintable(line));
}

QTEST_GUILESS_MAIN(TestTradeUnknowns)
#include "tst_trade_unknowns.moc"
