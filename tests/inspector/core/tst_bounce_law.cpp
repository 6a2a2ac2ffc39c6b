// SPDX-License-Identifier: MIT
// The law of a bounce with its numbers: a ball that rolls head-on into a wall with e = 0.5, compared with closed forms.
#include "core/events/bounce_law.h"
#include "core/events/event_table.h"
#include "inspector/core/scenes.h"
#include "inspector/core/wall_ahead.h"

#include <cmath>
#include <set>

using namespace inspector;

class TestBounceLaw : public QObject {
    Q_OBJECT

private slots:
    void headOnBounceObeysTheLaw_data();
    void headOnBounceObeysTheLaw();
    void speedIsThatOfTheClosedFormAtItsTime_data();
    void speedIsThatOfTheClosedFormAtItsTime();
    void locatedBounceIsAtTheFace_data();
    void locatedBounceIsAtTheFace();
    void steppersThatLookAheadBounceEarly_data();
    void steppersThatLookAheadBounceEarly();
    void reportedOverlapIsFoundLate_data();
    void reportedOverlapIsFoundLate();
    void bounceAfterAnotherHasNoPlace();
    void roughWallTakesTwoSeventhsOfTheSlip_data();
    void roughWallTakesTwoSeventhsOfTheSlip();
    void sentenceHasTheNumbers();
    void wrongBounceIsOffByItsShare();
    void bounceThatEndsIsNotCalledWrong();
    void landingTakesTheFloorsRestitution();
    void impactWithATopsNormalTakesTheWallsRestitution();
    void edgesTakeTheWallsRestitution_data();
    void edgesTakeTheWallsRestitution();
    void tableReadsBackExactly();
    void everyKindHasItsName();
    void foldedImpactsAreCalledLeaning();
};

namespace {

constexpr double kRadius = 0.006;  // m, by default
constexpr double kDistance = 0.25; // m, gap between the ball and the wall
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

// A ball that falls onto the edge of a wall of 0.05 m, its centre beside the wall's top.
LoggedEvent firstBounceOnEdge(const QByteArray &stepper, uint32_t model) {
    const Scene scene = wallAhead(kDistance);
    QString error;
    Engine engine(scene, makeStepper(builtIn(), stepper, scene, &error));
    Inputs inputs = inputsOf(model, 0.0);
    inputs.params.restitution_floor = 0.25;
    engine.setInputs(inputs);
    phys_state state = engine.state();
    state.position = {kDistance - 0.5 * kRadius, 0.0, 0.06};
    engine.setState(state);
    engine.setDt(0.001); // in long substeps so slow an approach to an edge is no bounce: model.md 13.5
    EventLog log(64);
    LoggedEvent entry;
    while (engine.state().step < 1000 && engine.step(&error)) {
        log.note(engine, stepperIndex(builtIn(), stepper.constData()));
        for (uint64_t i = log.first(); log.read(i, entry); ++i)
            if (entry.isBounce()) return entry;
    }
    qFatal("%s: no bounce: %s", stepper.constData(), qPrintable(error));
}

// The first impact of a run from rest.
LoggedEvent firstImpact(const QByteArray &stepper, uint32_t model, double wallFriction = 0.0, double ownValue = 0.0) {
    const Scene scene = wallAhead(kDistance + kRadius);
    QString error;
    Engine engine(scene, makeStepper(builtIn(), stepper, scene, &error));
    Inputs inputs = inputsOf(model, wallFriction);
    inputs.params.stepper[0] = ownValue;
    engine.setInputs(inputs);
    EventLog log(64);
    LoggedEvent entry;
    while (engine.state().step < 1000 && engine.step(&error)) {
        log.note(engine, stepperIndex(builtIn(), stepper.constData()));
        if (log.read(log.first(), entry)) return entry;
    }
    qFatal("%s: no impact: %s", stepper.constData(), qPrintable(error));
}

bool isLocated(const QByteArray &stepper) { return stepper == "exact" || stepper == "swept"; }
bool isDiscrete(const QByteArray &stepper) { return !isLocated(stepper); }
bool isAny(const QByteArray &) { return true; }

void addRows(bool (*belongs)(const QByteArray &) = isAny) {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i) {
        if (!belongs(info.id)) continue;
        QTest::addRow("%s, rolling", info.id) << QByteArray(info.id) << uint32_t(PHYS_MODEL_ROLLING);
        QTest::addRow("%s, rigid", info.id) << QByteArray(info.id) << uint32_t(PHYS_MODEL_RIGID);
    }
}

// A time later by tau, the ball with speed v then is v tau - a tau^2/2 behind the face; a time earlier by tau, as much
// in front of it. The position of an Euler scheme is off by v h/2 at any time; h is its substep, of which a step has
// one or more.
void verifyLateness(const QByteArray &stepper, const LoggedEvent &bounce, const BouncePlace &place) {
    const double late = bounce.event.time - timeToWall();
    const double expected = late - acceleration() * late * late / (2.0 * normalLaw(bounce).before);
    const double scheme = stepper.endsWith("-euler") ? 0.5 * bounce.step.dt : 0.0;
    QVERIFY(std::abs(place.lateness - expected) <= scheme + 1e-12);
}

// The text about the position.
QString foundText(const LoggedEvent &bounce) {
    for (const LawLine &line : eventLines(bounce, wallAhead(kDistance + kRadius).get(), builtIn())) {
        if (line.label == QStringLiteral("Found")) return line.text;
    }
    return {};
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

// The ball leaves with half the speed with which it came: a product with 0.5 isn't rounded.
void TestBounceLaw::headOnBounceObeysTheLaw() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const NormalLaw law = normalLaw(bounce);
    QCOMPARE(law.restitution, kRestitution);
    QCOMPARE(law.found, 0.5 * law.before);
    QCOMPARE(law.deviation, 0.0);
    QVERIFY(!law.ends);
    // There is no motion along the wall, before or after.
    const TangentialLaw tangential = tangentialLaw(bounce, 0.006);
    QCOMPARE(tangential.expected, 0.0);
    QCOMPARE(tangential.off, 0.0);
}

void TestBounceLaw::speedIsThatOfTheClosedFormAtItsTime_data() { addRows(); }

// Constant acceleration from rest: v = a t, which every scheme gets right. Rounding: of some hundred sums.
void TestBounceLaw::speedIsThatOfTheClosedFormAtItsTime() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const double speed = acceleration() * bounce.event.time;
    QVERIFY(std::abs(normalLaw(bounce).before - speed) <= 1e-12 * speed);
}

void TestBounceLaw::locatedBounceIsAtTheFace_data() { addRows(isLocated); }

void TestBounceLaw::locatedBounceIsAtTheFace() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    QVERIFY(std::abs(bounce.event.time - timeToWall()) < 1e-12);
    const auto place = bouncePlace(bounce, kRadius);
    QVERIFY(place);
    QVERIFY(std::abs(place->gap) < 1e-12);
    QVERIFY(place->isAtFace(kRadius));
    QVERIFY(foundText(bounce) == "at the face");
}

void TestBounceLaw::steppersThatLookAheadBounceEarly_data() { addRows(isDiscrete); }

// model.md 13.5: at the beginning of the substep in which the ball would reach the wall.
void TestBounceLaw::steppersThatLookAheadBounceEarly() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model);
    const auto place = bouncePlace(bounce, kRadius);
    QVERIFY(place);
    QVERIFY(place->gap > 0.0);
    QVERIFY(place->lateness < 0.0);
    QVERIFY(place->lateness > -bounce.step.dt);
    verifyLateness(stepper, bounce, *place);
    QVERIFY2(foundText(bounce).endsWith(" ms early"), qPrintable(foundText(bounce)));
}

void TestBounceLaw::reportedOverlapIsFoundLate_data() { addRows(isDiscrete); }

// Textbook collisions are detected at the end of the step, behind the face.
void TestBounceLaw::reportedOverlapIsFoundLate() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model, 0.0, 1.0);
    const auto place = bouncePlace(bounce, kRadius);
    QVERIFY(place);
    QVERIFY(place->gap < 0.0);
    QVERIFY(place->lateness > 0.0);
    QVERIFY(place->lateness < bounce.step.dt);
    verifyLateness(stepper, bounce, *place);
    QVERIFY2(foundText(bounce).endsWith(" ms late"), qPrintable(foundText(bounce)));
}

void TestBounceLaw::bounceAfterAnotherHasNoPlace() {
    LoggedEvent bounce = madeUp(-0.5, 0.25);
    bounce.event.time = 0.006;
    bounce.step.firstEvent = 0.006;
    QVERIFY(bouncePlace(bounce, kRadius));
    bounce.step.firstEvent = 0.004;
    QVERIFY(!bouncePlace(bounce, kRadius));
}

void TestBounceLaw::roughWallTakesTwoSeventhsOfTheSlip_data() { addRows(); }

// model.md 4: a ball that rolls head-on into a wall slips there with its own speed. mu (1 + e) V > 2/7 V: it sticks.
// The slip is that of the state before the step, which is slower by up to one step's gain.
void TestBounceLaw::roughWallTakesTwoSeventhsOfTheSlip() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstImpact(stepper, model, 0.3);
    const TangentialLaw law = tangentialLaw(bounce, 0.006);
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

// Right at the border of a top face the normal is the same, but the edge has the walls' coefficients (model.md 13.1).
void TestBounceLaw::impactWithATopsNormalTakesTheWallsRestitution() {
    LoggedEvent bounce = madeUp(-0.5, 0.25);
    bounce.event.normal = {0.0, 0.0, 1.0};
    QCOMPARE(normalLaw(bounce).restitution, 0.5);
    QCOMPARE(normalLaw(bounce).deviation, 0.0);
}

void TestBounceLaw::edgesTakeTheWallsRestitution_data() { addRows(); }

// model.md 13.1: only a top face has the floor's coefficients, however steep other normals are.
void TestBounceLaw::edgesTakeTheWallsRestitution() {
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const LoggedEvent bounce = firstBounceOnEdge(stepper, model);
    QVERIFY(bounce.event.normal.z > std::sqrt(0.5));
    QVERIFY(bounce.event.normal.z < 1.0);
    QCOMPARE(normalLaw(bounce).restitution, kRestitution);
    QVERIFY(normalLaw(bounce).deviation < 1e-13); // some roundings
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
