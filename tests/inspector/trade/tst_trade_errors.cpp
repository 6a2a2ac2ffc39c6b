// SPDX-License-Identifier: MIT
// The errors reported for steppers, compared with closed forms where there are any.
#include "core/schedule/trade_reference.h"
#include "core/trade/trade.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_table.h"
#include "inspector/core/scenes.h"
#include "support/compare.h"
#include "support/stepper_rows.h"

#include <array>

using namespace inspector;

class TestTradeErrors : public QObject {
    Q_OBJECT

private slots:
    void exactHasNoErrorAgainstItself();
    void exactInOtherStepsHasTheErrorOfRounding();
    void orientationIsComparedInSmallSteps();
    void withoutOrientationNoTurnIsCompared();
    void errorsAreTheWorstOfTheSchedules();
    void eulerIsWrongByHalfAStepOfTheVelocity_data();
    void eulerIsWrongByHalfAStepOfTheVelocity();
    void errorGrowsAsTheRecordsTell();
    void timeUntilWrongIsWhenTheErrorPasses();
    void halvingTheStepOfSweptQuartersTheError();
    void modelErrorBelongsToTheRollingModel();
    void modelWithoutReferenceSaysWhy();
    void quietRunHasNoHorizon();
    void bouncesOffAPillarEndInAHorizon();
    void allButTimingIsTheSameAgain();
    void cancelEndsTheMeasurementEarly();
    void resultsStreamInBeforeTheEnd();

private:
    static TradePlan plan(const Scene &scene, TiltSchedule schedule, std::vector<double> stepSizes);
    static TradeResult measured(const TradePlan &plan);
    static const TradePoint &find(const TradeResult &result, const QByteArray &stepper, double dt,
                                  uint32_t model = PHYS_MODEL_ROLLING);
};

namespace {

constexpr double kGravity = 9.81;
constexpr double kErrorTilt = 0.02; // rad
constexpr double kErrorRadius = 0.006;
constexpr double kDuration = 1.5; // s

// Straight along x; without friction a rolling ball moves by 5/14 g sin(tilt) t^2 (model.md 2.1).
TiltSchedule oneTilt() { return {"tilt", {{0.0, {kErrorTilt, 0.0}}}, kDuration}; }
double slideAcceleration() { return 5.0 / 7.0 * kGravity * std::sin(kErrorTilt); }

// A room with a pillar in the middle and the ball in a corner.
Scene pillarRoom() {
    constexpr double kHalf = 0.05;
    const auto wall = [](double x0, double y0, double x1, double y1) {
        return phys_box{{x0, y0, 0.0}, {x1, y1, 0.03}};
    };
    const std::array<phys_box, 6> boxes{{{{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}},
                                         wall(-0.1, -0.1, -kHalf, 0.1),
                                         wall(kHalf, -0.1, 0.1, 0.1),
                                         wall(-kHalf, -0.1, kHalf, -kHalf),
                                         wall(-kHalf, kHalf, kHalf, 0.1),
                                         wall(-0.01, -0.01, 0.01, 0.01)}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes.data();
    description.box_count = uint32_t(boxes.size());
    description.start = {-0.03, -0.035, kErrorRadius};
    QString error;
    return makeScene(description, &error);
}

} // namespace

TradePlan TestTradeErrors::plan(const Scene &scene, TiltSchedule schedule, std::vector<double> stepSizes) {
    TradePlan result;
    result.registry = makeRegistry(nullptr);
    result.scene = scene;
    result.inputs = initialInputs();
    result.inputs.params.rolling_friction = 0.0;
    result.schedules = {std::move(schedule)};
    result.stepSizes = std::move(stepSizes);
    result.repeats = 1;
    return result;
}

TradeResult TestTradeErrors::measured(const TradePlan &plan) {
    QString error;
    std::optional<TradeResult> result = measureTrade(plan, {}, {}, &error);
    if (!result) qFatal("%s", qPrintable(error));
    return std::move(*result);
}

const TradePoint &TestTradeErrors::find(const TradeResult &result, const QByteArray &stepper, double dt,
                                        uint32_t model) {
    for (const TradePoint &point : result.points)
        if (point.stepper == stepper && point.dt == dt && point.model == model) return point;
    qFatal("no point of %s", stepper.constData());
}

// With the reference's own steps: the same calls.
void TestTradeErrors::exactHasNoErrorAgainstItself() {
    const TradeResult result = measured(plan(pillarRoom(), randomSchedule(4, 2.0), {kScheduleHold}));
    const TradePoint &point = find(result, "exact", kScheduleHold);
    QVERIFY2(point.isValid, qPrintable(point.note));
    COMPARE_EXACT(point.error.positionLargest, 0.0);
    COMPARE_EXACT(point.error.velocityLargest, 0.0);
    QCOMPARE(point.error.wrongImpacts, 0);
    QVERIFY(!point.error.timeUntilWrong);
}

// 50 steps of rounding, some ten impacts and at most one on an edge, which multiplies by about 40: 1e-16 R to 1e-11 R.
void TestTradeErrors::exactInOtherStepsHasTheErrorOfRounding() {
    const TradeResult result = measured(plan(openFloor(), randomSchedule(4, 2.0), {0.01}));
    const TradePoint &point = find(result, "exact", 0.01);
    QVERIFY2(point.isValid && point.error.positionLargest < 1e-11, qPrintable(point.note));
}

// The orientation of exact is also of second order: in the 50 ms steps of the reference's path it would be wrong by a
// tenth of a degree; in steps of 1 ms it and the other steppers are 2500 times better.
void TestTradeErrors::orientationIsComparedInSmallSteps() {
    TradePlan turning = plan(openFloor(), randomSchedule(5, 2.0), {0.001});
    turning.withOrientation = true;
    const TradeResult result = measured(turning);
    for (const QByteArray &stepper : support::higherOrderStepperIds()) {
        const std::optional<double> error = find(result, stepper, 0.001).error.orientationLargest;
        QVERIFY2(error && *error < radians(0.01),
                 qPrintable(QString("%1: %2 degrees").arg(stepper).arg(degrees(error.value_or(0.0)))));
    }
}

void TestTradeErrors::withoutOrientationNoTurnIsCompared() {
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {0.05}));
    for (const TradePoint &point : result.points) QVERIFY(!point.error.orientationLargest);
}

// Twice the tilt gives twice the error; half the time a quarter of the distance and half the error of Euler.
void TestTradeErrors::errorsAreTheWorstOfTheSchedules() {
    TradePlan both = plan(openFloor(), oneTilt(), {0.05});
    both.schedules.push_back({"short", {{0.0, {2.0 * kErrorTilt, 0.0}}}, 0.5 * kDuration});
    const TradeResult result = measured(both);
    const TradePoint &point = find(result, "symplectic-euler", 0.05);
    QCOMPARE(point.errors.size(), size_t(2));
    COMPARE_EXACT(point.error.positionLargest,
                  std::max(point.errors[0].positionLargest, point.errors[1].positionLargest));
    for (const double time : {0.3, 0.7, 1.4})
        COMPARE_EXACT(errorUntil(point, time),
                      std::max(errorUntil(point.errors[0], time), errorUntil(point.errors[1], time)));
    QCOMPARE(point.steps, uint64_t(30 + 15));
    COMPARE_WITHIN(result.compared(PHYS_MODEL_ROLLING), 0.5 * kDuration, 1e-12);
}

void TestTradeErrors::eulerIsWrongByHalfAStepOfTheVelocity_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<double>("dt");
    for (const double dt : {0.01, 0.005}) {
        QTest::addRow("explicit %g", dt) << QByteArray("explicit-euler") << dt;
        QTest::addRow("symplectic %g", dt) << QByteArray("symplectic-euler") << dt;
    }
}

// Explicit: x = a t (t - dt) / 2; symplectic: a t (t + dt) / 2. The velocity a t is right.
void TestTradeErrors::eulerIsWrongByHalfAStepOfTheVelocity() {
    QFETCH(QByteArray, stepper);
    QFETCH(double, dt);
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {dt}));
    const TradePoint &point = find(result, stepper, dt);
    const double expected = 0.5 * slideAcceleration() * kDuration * dt / kErrorRadius;
    const double rounding = 1e-12; // of some hundred additions of numbers of order 100 R
    COMPARE_WITHIN(point.error.positionFinal, expected, rounding * 100.0);
    COMPARE_WITHIN(point.error.positionLargest, expected, rounding * 100.0);
    COMPARE_WITHIN(point.error.velocityLargest, 0.0, rounding);
    QCOMPARE(point.steps, uint64_t(std::lround(kDuration / dt)));
}

void TestTradeErrors::errorGrowsAsTheRecordsTell() {
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {0.01}));
    const TradePoint &point = find(result, "symplectic-euler", 0.01);
    for (const double time : {0.25, 0.5, 1.0})
        COMPARE_WITHIN(errorUntil(point, time + 1e-9), 0.5 * slideAcceleration() * time * 0.01 / kErrorRadius, 1e-10);
}

// a t dt / 2 passes R / 10 at t = 0.857 s for a step of 10 ms; compared after each step.
void TestTradeErrors::timeUntilWrongIsWhenTheErrorPasses() {
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {0.01}));
    const double passes = 0.2 * kErrorRadius / (slideAcceleration() * 0.01);
    const TradePoint &point = find(result, "symplectic-euler", 0.01);
    QVERIFY(point.error.timeUntilWrong.has_value());
    COMPARE_WITHIN(*point.error.timeUntilWrong, 0.01 * std::ceil(passes / 0.01), 1e-9);
    QVERIFY(!find(result, "velocity-verlet", 0.01).error.timeUntilWrong);
}

// Order 2 where the motion is smooth and curved: tilts that turn, against a rolling resistance.
void TestTradeErrors::halvingTheStepOfSweptQuartersTheError() {
    TradePlan turning = plan(openFloor(), randomSchedule(5, 2.0), {0.01, 0.005, 0.0025});
    turning.inputs.params.rolling_friction = 0.01;
    const TradeResult result = measured(turning);
    const double errors[] = {find(result, "swept", 0.01).error.positionLargest,
                             find(result, "swept", 0.005).error.positionLargest,
                             find(result, "swept", 0.0025).error.positionLargest};
    for (int i = 0; i < 2; ++i) {
        const double order = std::log2(errors[i] / errors[i + 1]);
        QVERIFY2(order > 1.7 && order < 2.3, qPrintable(QString("order %1").arg(order)));
    }
}

void TestTradeErrors::modelErrorBelongsToTheRollingModel() {
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {0.05}));
    const TradePoint &rolling = find(result, "swept", 0.05, PHYS_MODEL_ROLLING);
    const TradePoint &rigid = find(result, "swept", 0.05, PHYS_MODEL_RIGID);
    QVERIFY2(rolling.error.model && rigid.error.model, qPrintable(rolling.note + rigid.note));
    // On a slope of 0.02, far below 7/2 of the friction, a rigid ball rolls: the models agree up to rounding.
    COMPARE_WITHIN(*rolling.error.model, 0.0, 1e-10);
    COMPARE_EXACT(*rigid.error.model, 0.0);
}

void TestTradeErrors::modelWithoutReferenceSaysWhy() {
    TradePlan sticky = plan(openFloor(), oneTilt(), {0.05});
    sticky.inputs.params.rolling_friction = 0.5;
    sticky.inputs.params.sliding_friction = 0.1; // less than the rolling friction, which the rigid model doesn't allow
    const TradeResult result = measured(sticky);
    const TradePoint &rigid = find(result, "swept", 0.05, PHYS_MODEL_RIGID);
    QVERIFY(!rigid.isValid);
    QVERIFY2(rigid.note.startsWith("no reference: ") && rigid.note.contains("rolling_friction"),
             qPrintable(rigid.note));
    QVERIFY(find(result, "swept", 0.05).isValid);
}

void TestTradeErrors::quietRunHasNoHorizon() {
    const TradeResult result = measured(plan(openFloor(), oneTilt(), {0.05}));
    QVERIFY(!result.spans[0][PHYS_MODEL_ROLLING].isSensitive);
    COMPARE_WITHIN(result.spans[0][PHYS_MODEL_ROLLING].compared, kDuration, 1e-12);
}

// Each bounce off an edge multiplies a push by about 1 + 2 L / R (L: free path, here 5 R), so that three or more
// bounces make 1e-6 R visible.
void TestTradeErrors::bouncesOffAPillarEndInAHorizon() {
    TradePlan bouncing = plan(pillarRoom(), randomSchedule(2, 30.0), {0.05});
    bouncing.inputs.params.restitution_wall = 1.0;
    const TradeResult result = measured(bouncing);
    const TradeSpan &span = result.spans[0][PHYS_MODEL_ROLLING];
    QVERIFY(span.isSensitive);
    QVERIFY2(span.compared > 0.0 && span.compared < 30.0, qPrintable(QString::number(span.compared)));
}

void TestTradeErrors::allButTimingIsTheSameAgain() {
    const TradePlan again = plan(pillarRoom(), randomSchedule(4, 2.0), {0.05, 0.01});
    const TradeResult first = measured(again);
    const TradeResult second = measured(again);
    for (size_t i = 0; i < first.points.size(); ++i) {
        for (const TradeColumn &column : tradeColumns())
            if (!QByteArray(column.id).startsWith("cpu_") && QByteArray(column.id) != "repeats")
                QVERIFY2(column.value(first.points[i]) == column.value(second.points[i]), column.id);
        QCOMPARE(first.points[i].note, second.points[i].note);
    }
}

void TestTradeErrors::cancelEndsTheMeasurementEarly() {
    QString error;
    std::stop_source stop;
    int count = 0;
    TradeListener listener;
    listener.measured = [&](size_t, const TradePoint &) {
        if (++count == 2) stop.request_stop();
    };
    const std::optional<TradeResult> result =
        measureTrade(plan(openFloor(), oneTilt(), {0.05, 0.01}), listener, stop.get_token(), &error);
    QVERIFY2(result, qPrintable(error));
    QVERIFY(!result->isComplete);
    QCOMPARE(count, 2);
    QCOMPARE(result->valid(PHYS_MODEL_ROLLING).size(), size_t(2));
}

void TestTradeErrors::resultsStreamInBeforeTheEnd() {
    QString error;
    TradeListener listener;
    size_t announced = 0;
    std::vector<int> times;
    double share = 0.0;
    listener.began = [&](const TradeResult &result) {
        announced = result.points.size();
        times.resize(announced);
    };
    listener.measured = [&](size_t index, const TradePoint &) { ++times[index]; };
    listener.progressed = [&](double now, const QString &) {
        QVERIFY(now >= share && now <= 1.0);
        share = now;
    };
    TradePlan twice = plan(openFloor(), oneTilt(), {0.05});
    twice.repeats = 3;
    const std::optional<TradeResult> result = measureTrade(twice, listener, {}, &error);
    QVERIFY2(result, qPrintable(error));
    QCOMPARE(announced, 2 * size_t(phys_registry_count(nullptr)));
    for (size_t i = 0; i < announced; ++i) QCOMPARE(times[i], result->points[i].isValid ? 3 : times[i]);
    QVERIFY(share == 1.0 && result->isComplete);
}

QTEST_GUILESS_MAIN(TestTradeErrors)
#include "tst_trade_errors.moc"
