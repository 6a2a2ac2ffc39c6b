// SPDX-License-Identifier: MIT
// The law of a bounce with the numbers put in: a ball that rolls head-on into a wall with e = 0.5, against closed
// forms.
#include "core/events/bounce_law.h"
#include "core/events/event_table.h"
#include "scenes.h"
#include "wall_ahead.h"

#include <cmath>
#include <set>

using namespace inspector;

class TestBounceLaw : public QObject {
    Q_OBJECT

private slots:
    void headOnBounceObeysTheLaw_data();
    void headOnBounceObeysTheLaw();
    void speedAtTheWallIsThatOfTheClosedForm_data();
    void speedAtTheWallIsThatOfTheClosedForm();
    void latenessIsWhatTheStepperIsLateBy_data();
    void latenessIsWhatTheStepperIsLateBy();
    void roughWallTakesTwoSeventhsOfTheSlip_data();
    void roughWallTakesTwoSeventhsOfTheSlip();
    void sentenceHasTheNumbers();
    void wrongBounceIsOffByItsShare();
    void bounceThatEndsIsNotCalledWrong();
    void landingTakesTheFloorsRestitution();
    void steepNormalTakesTheFloorsRestitution();
    void tableReadsBackExactly();
    void everyKindHasItsName();
    void foldedImpactsAreCalledLeaning();
};

namespace {

constexpr double kRadius = 0.006;  // m, by default
constexpr double kDistance = 0.25; // m, of the ball's front from the wall
constexpr double kTilt = 5.0;      // degrees
constexpr double kRestitution = 0.5;

Registry builtIn() {
    static const Registry registry = makeRegistry(nullptr);
    return registry;
}

Inputs inputsOf(uint32_t model, double wallFriction) {
    Inputs inputs = tilted(kTilt, 0.0);
    inputs.params.model = model;
    inputs.params.restitution_wall = kRestitution;
    inputs.params.rolling_friction = 0.0;
    inputs.params.wall_friction = wallFriction;
    return inputs;
}

// model.md 2.1: (5/7) of gravity's part along the floor.
double acceleration() { return 5.0 / 7.0 * inputsOf(PHYS_MODEL_ROLLING, 0.0).params.gravity.x; }
double speedAtWall() { return std::sqrt(2.0 * acceleration() * kDistance); }
double timeToWall() { return std::sqrt(2.0 * kDistance / acceleration()); }

// The first impact of a run from rest.
LoggedEvent firstImpact(const QByteArray &stepper, uint32_t model, double wallFriction = 0.0) {
    const Scene scene = wallAhead(kDistance + kRadius);
    QString error;
    Engine engine(scene, makeStepper(builtIn(), stepper, scene, &error));
    engine.setInputs(inputsOf(model, wallFriction));
    EventLog log(64);
    LoggedEvent entry;
    while (engine.state().step < 1000 && engine.step(&error)) {
        log.note(engine, stepperIndex(builtIn(), stepper.constData()));
        if (log.read(log.first(), entry)) return entry;
    }
    qFatal("%s: no impact: %s", stepper.constData(), qPrintable(error));
}

bool isLocated(const QByteArray &stepper) { return stepper == "exact" || stepper == "swept"; }
bool isCured(const QByteArray &stepper) { return stepper == "velocity-verlet" || stepper == "rk4"; }

void addRows() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i) {
        QTest::addRow("%s, rolling", info.id) << QByteArray(info.id) << uint32_t(PHYS_MODEL_ROLLING);
        QTest::addRow("%s, rigid", info.id) << QByteArray(info.id) << uint32_t(PHYS_MODEL_RIGID);
    }
}

LoggedEvent madeUp(double before, double after) {
    LoggedEvent bounce;
    bounce.event.kind = PHYS_EVENT_IMPACT;
    bounce.event.normal = {-1.0, 0.0, 0.0};
    bounce.event.speed_before = before;
    bounce.event.speed_after = after;
    bounce.count = 1;
    bounce.step.params = inputsOf(PHYS_MODEL_ROLLING, 0.0).params;
    bounce.step.params.restitution_floor = 0.25;
    bounce.step.eventCount = 1;
    return bounce;
}

} // namespace

void TestBounceLaw::headOnBounceObeysTheLaw_data() { addRows(); }

// Whatever the stepper came with, it gives back half: a product with 0.5 isn't rounded.
void TestBounceLaw::headOnBounceObeysTheLaw() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const NormalLaw law = normalLaw(bounce);
    QCOMPARE(law.restitution, kRestitution);
    QCOMPARE(law.found, 0.5 * law.before);
    QCOMPARE(law.deviation, 0.0);
    QVERIFY(!law.ends);
    // Nothing moves along the wall, neither before nor after.
    const AlongLaw along = alongLaw(bounce, 0.006);
    QCOMPARE(along.expected, 0.0);
    QCOMPARE(along.off, 0.0);
}

void TestBounceLaw::speedAtTheWallIsThatOfTheClosedForm_data() { addRows(); }

// Constant acceleration: second order is exact, and its bounce is corrected to the face (model.md 10.3 a). An Euler
// scheme is off by half a step's gain, and by what it gains behind the face: less than two steps' gain in all.
void TestBounceLaw::speedAtTheWallIsThatOfTheClosedForm() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const bool isEuler = !isLocated(stepper) && !isCured(stepper);
    const double tolerance = isEuler ? 2.0 * acceleration() * bounce.step.dt : 1e-12 * speedAtWall();
    QVERIFY(std::abs(normalLaw(bounce).before - speedAtWall()) <= tolerance);
}

void TestBounceLaw::latenessIsWhatTheStepperIsLateBy_data() { addRows(); }

// Late by tau, the ball is v tau + a tau^2/2 deep: the depth divided by v is tau, and less than a tau^2/(2 v) more. An
// Euler scheme's own error of the time comes on top: a step at most.
void TestBounceLaw::latenessIsWhatTheStepperIsLateBy() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const double late = bounce.event.time - timeToWall();
    const double rounding = 1e-12;
    if (isLocated(stepper)) {
        QVERIFY(std::abs(late) < rounding);
        QVERIFY(lateness(bounce) < rounding);
        return;
    }
    QVERIFY(lateness(bounce) > 0.0);
    const double scheme = isCured(stepper) ? rounding : bounce.step.dt;
    const double most = late + acceleration() * late * late / (2.0 * speedAtWall());
    QVERIFY(lateness(bounce) >= late - scheme);
    QVERIFY(lateness(bounce) <= most + scheme);
}

void TestBounceLaw::roughWallTakesTwoSeventhsOfTheSlip_data() { addRows(); }

// model.md 4: a ball that rolls head-on slips with its own speed at the wall. mu (1 + e) V > 2/7 V: it sticks. The slip
// is that of the state before the step, which is up to a step's gain slower.
void TestBounceLaw::roughWallTakesTwoSeventhsOfTheSlip() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model, 0.3);
    const AlongLaw law = alongLaw(bounce, 0.006);
    if (model == PHYS_MODEL_ROLLING) { // which knows no slip
        QCOMPARE(law.tangential, 0.0);
        return;
    }
    QCOMPARE(law.friction, 0.3);
    QCOMPARE(law.impulse, 1.5 * -bounce.event.speed_before);
    QVERIFY(law.sticks);
    QVERIFY(std::abs(law.slip - speedAtWall()) <= 2.0 * acceleration() * bounce.step.dt);
    QCOMPARE(law.tangential, 2.0 / 7.0 * law.slip);
    QVERIFY(law.off <= law.allowance);
}

void TestBounceLaw::sentenceHasTheNumbers() {
    const LoggedEvent bounce = firstImpact("exact", PHYS_MODEL_ROLLING);
    const auto text = [](double value) { return QString::number(value, 'g', 4); };
    const QString expected = QStringLiteral("v'n = -e vn: %1 m/s = 0.5 × %2 m/s   (model.md 2.1 R2); to the last bit")
                                 .arg(text(0.5 * speedAtWall()), text(speedAtWall()));
    const std::vector<LawLine> lines = lawLines(bounce, 0.006);
    QCOMPARE(lines.size(), size_t(2)); // and what happens along the wall
    QCOMPARE(lines[0].text, expected);
}

void TestBounceLaw::wrongBounceIsOffByItsShare() {
    const LoggedEvent bounce = madeUp(-0.5, 0.3);                 // 0.25 would be right
    QVERIFY(std::abs(normalLaw(bounce).deviation - 0.1) < 1e-15); // a few roundings
    QVERIFY(lawLines(bounce, 0.006)[0].text.endsWith(QStringLiteral("off by 10 %")));
}

void TestBounceLaw::bounceThatEndsIsNotCalledWrong() {
    const LoggedEvent bounce = madeUp(-0.01, 0.0);
    QVERIFY(normalLaw(bounce).ends);
    QVERIFY(lawLines(bounce, 0.006)[0].text.contains(QStringLiteral("stays in contact")));
}

void TestBounceLaw::landingTakesTheFloorsRestitution() {
    LoggedEvent bounce = madeUp(-0.5, 0.125);
    bounce.event.kind = PHYS_EVENT_LANDING;
    bounce.event.normal = {0.0, 0.0, 1.0};
    QCOMPARE(normalLaw(bounce).restitution, 0.25);
    QCOMPARE(normalLaw(bounce).deviation, 0.0);
}

void TestBounceLaw::steepNormalTakesTheFloorsRestitution() {
    LoggedEvent bounce = madeUp(-0.5, 0.125);
    bounce.event.normal = {0.6, 0.0, 0.8};
    QVERIFY(surfaceOf(bounce.event) == Surface::Floor);
    bounce.event.normal = {0.8, 0.0, 0.6};
    QVERIFY(surfaceOf(bounce.event) == Surface::Wall);
}

void TestBounceLaw::tableReadsBackExactly() {
    const LoggedEvent bounce = firstImpact("rk4", PHYS_MODEL_ROLLING);
    const QList<QByteArray> lines = eventCsv({bounce, bounce}, builtIn(), ',').split('\n');
    QCOMPARE(lines.size(), 4); // header, two rows, the end
    QVERIFY(lines[3].isEmpty());
    const QList<QByteArray> names = lines[0].split(',');
    const QList<QByteArray> values = lines[1].split(',');
    QCOMPARE(values.size(), names.size());
    QCOMPARE(values[0], QByteArray("Impact"));
    QCOMPARE(values[1], QByteArray("rk4"));
    QCOMPARE(values[2], QByteArray("rolling"));
    QCOMPARE(values[names.indexOf("time [s]")].toDouble(), bounce.event.time);
    QCOMPARE(values[names.indexOf("speed_before [m/s]")].toDouble(), bounce.event.speed_before);
    QCOMPARE(values[names.indexOf("speed_after [m/s]")].toDouble(), bounce.event.speed_after);
    QCOMPARE(values[names.indexOf("point_x [m]")].toDouble(), bounce.event.point.x);
    QCOMPARE(values[names.indexOf("normal_x")].toDouble(), -1.0);
    QCOMPARE(values[names.indexOf("box")].toInt(), 1);
}

void TestBounceLaw::everyKindHasItsName() {
    std::set<QString> names;
    for (uint32_t kind = PHYS_EVENT_IMPACT; kind <= PHYS_EVENT_RELEASE; ++kind) names.insert(eventKindName(kind));
    names.insert(eventKindName(kLeftMazeEvent));
    QCOMPARE(names.size(), size_t(PHYS_EVENT_RELEASE) + 1);
    for (const QString &name : names) QVERIFY(!name.startsWith(QStringLiteral("Event")));
    QCOMPARE(eventKindName(42), QStringLiteral("Event 42"));
}

void TestBounceLaw::foldedImpactsAreCalledLeaning() {
    LoggedEvent bounce = madeUp(-0.01, 0.0);
    bounce.event.time = 2.0;
    bounce.until = 2.83;
    bounce.count = 83;
    QCOMPARE(eventText(bounce), QStringLiteral("Leaning: 0.83 s, 83 impacts"));
}

QTEST_GUILESS_MAIN(TestBounceLaw)
#include "tst_bounce_law.moc"
