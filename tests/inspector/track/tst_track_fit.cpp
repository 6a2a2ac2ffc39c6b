// SPDX-License-Identifier: MIT
// The fit finds the parameters with which a track was made, and reports what the track doesn't determine.
#include "core/track/fit_report.h"
#include "inspector/core/scenes.h"
#include "inspector/core/wall_ahead.h"
#include "inspector/track/made_track.h"
#include "support/compare.h"

using namespace inspector;

class TestTrackFit : public QObject {
    Q_OBJECT

private slots:
    void modelRollsAsTheClosedForm();
    void landingIsABounceOffTheFloor();
    void edgeOfALowKerbIsAWall();
    void ballStartsOnTheFloorThatIsBelowIt();
    void lowerFloorAfterADropIsRolledOn();
    void truthLiesNearItsIntervals();
    void wrongModelIsNamed();
    void withoutWallsRestitutionIsNotDetermined();
    void withoutBouncesTheFloorIsNotDetermined();
    void lowKerbsTellTheWallsRestitution();
    void gravityIsFound();
    void frameIsFound();
    void unknownQuantityIsOneLine();
    void quantityNamedTwiceIsRefused();
    void modelThatExplainsNothingIsNotTheBest();
    void stoppedFitIsNone();
    void fitCanBeStoppedWhereNothingIsLikeTheTrack();

private:
    std::vector<TrackBounce> bouncesOn(const Scene &scene);
    FitPlan plan(const Scene &scene, Track track, const char *quantities);
    Registry m_registry = makeRegistry(nullptr);
};

namespace {

Scene level(int number) {
    QString error;
    Scene scene = loadScene(QStringLiteral(LEVELS_FOLDER "/%1.txt").arg(number, 2, 10, QLatin1Char('0')), &error);
    if (!scene) qFatal("%s", qPrintable(error));
    return scene;
}

BoardParameters usual() { return {initialInputs().params, 9.81, {}, 0.0, {}}; }

TrackFit fitted(const FitPlan &plan) {
    QString error;
    std::optional<TrackFit> fit = fitTrack(plan, {}, {}, &error);
    if (!fit) qFatal("%s", qPrintable(error));
    return std::move(*fit);
}

const FittedValue &valueOf(const ModelFit &fit, const char *id) {
    for (const FittedValue &value : fit.values)
        if (value.quantity.id == QLatin1String(id)) return value;
    qFatal("no %s", id);
}

// The floor of the start ends 3 cm to its right; another one lies 2 cm below.
Scene stepDown() {
    return sceneOf({{{-1.0, -1.0, -0.02}, {0.03, 1.0, 0.0}}, {{-1.0, -1.0, -0.04}, {1.0, 1.0, -0.02}}});
}

// The start's floor ends 3 cm to its right; 2 cm below, another one lies between walls.
Scene twoFloors() {
    return sceneOf({{{-0.03, -0.05, -0.04}, {0.03, 0.05, 0.0}},
                    {{0.03, -0.05, -0.04}, {0.2, 0.05, -0.02}},
                    {{0.2, -0.05, -0.04}, {0.21, 0.05, 0.02}},
                    {{-0.04, -0.05, -0.04}, {-0.03, 0.05, 0.02}},
                    {{-0.04, -0.06, -0.04}, {0.21, -0.05, 0.02}},
                    {{-0.04, 0.05, -0.04}, {0.21, 0.06, 0.02}}});
}

// Four edges of 0.4 R around the start.
Scene betweenKerbs() {
    constexpr double kHeight = 0.4 * 0.006;
    return sceneOf({{{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}},
                    {{-0.1, -0.1, 0.0}, {-0.05, 0.1, kHeight}},
                    {{0.05, -0.1, 0.0}, {0.1, 0.1, kHeight}},
                    {{-0.05, -0.1, 0.0}, {0.05, -0.05, kHeight}},
                    {{-0.05, 0.05, 0.0}, {0.05, 0.1, kHeight}}});
}

} // namespace

// The bounces of 2 s from rest under a tilt of 2 degrees to the right.
std::vector<TrackBounce> TestTrackFit::bouncesOn(const Scene &scene) {
    Track track;
    for (int i = 0; i <= 60; ++i) track.points.push_back({i / 30.0, 0.0, 0.0});
    track.tilts = {{0.0, {radians(2.0), 0.0}}};
    const BallModel model(m_registry, scene, track, nullptr);
    std::vector<TrackPoint> seen;
    std::vector<TrackBounce> bounces;
    if (!model.run(usual(), {0.0, 0.0, 0.0, 0.0}, 0, 60, seen, &bounces)) qFatal("refused");
    return bounces;
}

FitPlan TestTrackFit::plan(const Scene &scene, Track track, const char *quantities) {
    QString error;
    FitPlan result{m_registry, scene, std::move(track), usual(), {}, {}};
    const auto parsed = parseFitQuantities(quantities, &error);
    if (!parsed) qFatal("%s", qPrintable(error));
    result.quantities = *parsed;
    return result;
}

// x = 5/14 g sin(tilt) t^2 from the moment at which the tilt is felt, without friction (model.md 2.1).
void TestTrackFit::modelRollsAsTheClosedForm() {
    Track track;
    for (int i = 0; i <= 60; ++i) track.points.push_back({i / 60.0, 0.0, 0.0});
    track.tilts = {{0.0, {}}, {0.2, {0.02, 0.0}}};
    BoardParameters board = usual();
    board.params.rolling_friction = 0.0;
    board.delay = 0.1;
    QString error;
    const BallModel model(m_registry, openFloor(), track, &error);
    std::vector<TrackPoint> seen;
    QVERIFY(model.run(board, {0.0, 0.0, 0.0, 0.0}, 0, 60, seen));
    COMPARE_WITHIN(seen.back().x, 5.0 / 14.0 * 9.81 * std::sin(0.02) * 0.7 * 0.7, 1e-12);
    COMPARE_EXACT(seen[18].x, 0.0); // 0.3 s
}

// From a step of 2 cm the ball lands on the floor below.
void TestTrackFit::landingIsABounceOffTheFloor() {
    const std::vector<TrackBounce> bounces = bouncesOn(stepDown());
    QVERIFY(!bounces.empty());
    QCOMPARE(bounces[0].surface, Surface::Floor);
    COMPARE_WITHIN(bounces[0].speed, std::sqrt(2.0 * 9.81 * 0.02), 0.01);
}

// An edge has the walls' coefficients, however steep its normal (model.md 13.1): here 0.6 of it is upwards.
void TestTrackFit::edgeOfALowKerbIsAWall() {
    const std::vector<TrackBounce> bounces = bouncesOn(wallAhead(0.05, 0.4 * 0.006));
    QVERIFY(!bounces.empty());
    QCOMPARE(bounces[0].surface, Surface::Wall);
}

void TestTrackFit::ballStartsOnTheFloorThatIsBelowIt() {
    constexpr double kRadius = 0.006;
    const Scene scene = twoFloors();
    QCOMPARE(rollingState(scene.get(), {0.0, 0.0, 0.0, 0.0}).position.z, kRadius);
    QCOMPARE(rollingState(scene.get(), {0.1, 0.0, 0.0, 0.0}).position.z, -0.02 + kRadius);
}

// The ball falls once, at 0.35 s. Segments that began after that at the start's height would fall again, and most could
// not be fitted.
void TestTrackFit::lowerFloorAfterADropIsRolledOn() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    const Scene scene = twoFloors();
    const Track track = support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 2});
    const TrackFit fit = fitted(plan(scene, track, "rolling_friction,restitution_wall,tilt,delay"));
    for (const FittedBounce &bounce : fit.best().bounces) QVERIFY(bounce.surface == Surface::Wall || bounce.time < 1.0);
    QVERIFY2(double(fit.best().residuals.size()) > 0.9 * double(track.points.size()),
             qPrintable(QString::number(fit.best().residuals.size())));
}

// 95 % intervals: chance doesn't lead beyond four times their half-widths.
void TestTrackFit::truthLiesNearItsIntervals() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    const Scene scene = level(3);
    const TrackFit fit = fitted(plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 2}),
                                     "rolling_friction,restitution_wall,tilt,delay"));
    QCOMPARE(fit.verdict, FitVerdict::RollingSuffices);
    COMPARE_WITHIN(fit.best().rms, 1e-4, 1e-5);
    for (const FittedValue &value : fit.best().values) {
        BoardParameters board = truth;
        QVERIFY2(value.isDetermined(), qPrintable(value.quantity.id + ": " + value.reason));
        QVERIFY2(std::abs(value.value - value.quantity.of(board)) < 4.0 * value.halfInterval(),
                 qPrintable(value.quantity.id + ": " + valueText(value)));
    }
}

void TestTrackFit::wrongModelIsNamed() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_RIGID, 3);
    const Scene scene = level(4);
    FitPlan wrong = plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 3}),
                         "rolling_friction,restitution_wall,tilt,delay");
    wrong.model = PHYS_MODEL_ROLLING;
    const TrackFit fit = fitted(wrong);
    QCOMPARE(fit.verdict, FitVerdict::Neither);
    QVERIFY2(verdictText(fit).startsWith("the rolling model doesn't explain the track"), qPrintable(verdictText(fit)));
}

void TestTrackFit::withoutWallsRestitutionIsNotDetermined() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 4);
    const TrackFit fit =
        fitted(plan(openFloor(), support::makeTrack(m_registry, openFloor(), truth, {.duration = 4.0, .seed = 4}),
                    "rolling_friction,restitution_wall,tilt,delay"));
    QCOMPARE(fit.verdict, FitVerdict::RollingSuffices);
    QCOMPARE(valueText(valueOf(fit.best(), "restitution_wall")), QString("not determined: no wall is hit"));
    QVERIFY(valueOf(fit.best(), "rolling_friction").isDetermined());
    QVERIFY(!fitOptions(fit).contains("restitution"));
}

void TestTrackFit::withoutBouncesTheFloorIsNotDetermined() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    const Scene scene = level(3);
    const TrackFit fit = fitted(plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 4.0, .seed = 2}),
                                     "rolling_friction,restitution_wall,restitution_floor,tilt,delay"));
    QCOMPARE(valueText(valueOf(fit.best(), "restitution_floor")), QString("not determined: no bounce on the floor"));
    QVERIFY(valueOf(fit.best(), "restitution_wall").isDetermined());
}

void TestTrackFit::lowKerbsTellTheWallsRestitution() {
    const BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    const Scene scene = betweenKerbs();
    const TrackFit fit = fitted(plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 2}),
                                     "restitution_wall,tilt,delay"));
    const FittedValue &restitution = valueOf(fit.best(), "restitution_wall");
    QVERIFY2(restitution.isDetermined(), qPrintable(valueText(restitution)));
    QVERIFY2(std::abs(restitution.value - truth.params.restitution_wall) < 4.0 * restitution.halfInterval(),
             qPrintable(valueText(restitution)));
}

void TestTrackFit::gravityIsFound() {
    BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    truth.gravity = 9.78;
    const Scene scene = level(3);
    const TrackFit fit = fitted(plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 2}),
                                     "rolling_friction,restitution_wall,gravity,tilt,delay"));
    const FittedValue &gravity = valueOf(fit.best(), "gravity");
    QVERIFY2(std::abs(gravity.value - 9.78) < 4.0 * gravity.halfInterval(), qPrintable(valueText(gravity)));
    QVERIFY2(gravity.halfInterval() < 0.05, qPrintable(valueText(gravity)));
}

// A tracker whose picture is rotated by 2 degrees and 1 % too small.
void TestTrackFit::frameIsFound() {
    BoardParameters truth = support::drawTruth(PHYS_MODEL_ROLLING, 2);
    truth.frame.angle = radians(2.0);
    truth.frame.scale = 1.01;
    const Scene scene = level(3);
    const TrackFit fit = fitted(plan(scene, support::makeTrack(m_registry, scene, truth, {.duration = 8.0, .seed = 2}),
                                     "rolling_friction,restitution_wall,tilt,delay,frame"));
    QCOMPARE(fit.verdict, FitVerdict::RollingSuffices);
    const FittedValue &angle = valueOf(fit.best(), "frame_angle");
    const FittedValue &scale = valueOf(fit.best(), "frame_scale");
    QVERIFY2(std::abs(angle.value - truth.frame.angle) < 4.0 * angle.halfInterval(), qPrintable(valueText(angle)));
    QVERIFY2(std::abs(scale.value - truth.frame.scale) < 4.0 * scale.halfInterval(), qPrintable(valueText(scale)));
}

void TestTrackFit::unknownQuantityIsOneLine() {
    QString error;
    QVERIFY(!parseFitQuantities("tilt,weight", &error));
    QVERIFY2(error.endsWith("tilt, frame; found 'weight'"), qPrintable(error));
}

void TestTrackFit::quantityNamedTwiceIsRefused() {
    QString error;
    QVERIFY(!parseFitQuantities("tilt,delay,tilt_x", &error));
    QCOMPARE(error, QString("'tilt_x' is named twice"));
}

// One picture per 100 s of a ball that jumps about: no segment of it can be fitted.
void TestTrackFit::fitCanBeStoppedWhereNothingIsLikeTheTrack() {
    Track track;
    for (int i = 0; i < 300; ++i) track.points.push_back({100.0 * i, 1e-3 * std::sin(i), 1e-3 * std::cos(i)});
    track.tilts = {{0.0, {}}};
    std::stop_source stop;
    int told = 0;
    const FitProgress progress = [&](double, const QString &) {
        if (++told == 10) stop.request_stop();
    };
    QString error;
    QVERIFY(!fitTrack(plan(level(1), track, "rolling_friction,tilt"), progress, stop.get_token(), &error));
    QCOMPARE(error, QString("stopped"));
    QCOMPARE(told, 10);
}

// Without a segment it has no breaks either.
void TestTrackFit::modelThatExplainsNothingIsNotTheBest() {
    TrackFit fit;
    fit.fits.resize(2);
    fit.fits[0].model = PHYS_MODEL_ROLLING;
    fit.fits[0].breaks = 6;
    fit.fits[0].share = 0.9;
    fit.fits[1].model = PHYS_MODEL_RIGID;
    QCOMPARE(fit.best().model, uint32_t(PHYS_MODEL_ROLLING));
    fit.fits[1].isGood = true;
    QCOMPARE(fit.best().model, uint32_t(PHYS_MODEL_RIGID));
}

void TestTrackFit::stoppedFitIsNone() {
    QString error;
    std::stop_source stop;
    stop.request_stop();
    const Scene scene = level(3);
    const FitPlan stopped =
        plan(scene, support::makeTrack(m_registry, scene, usual(), {.duration = 2.0, .seed = 1}), "tilt");
    QVERIFY(!fitTrack(stopped, {}, stop.get_token(), &error));
    QCOMPARE(error, QString("stopped"));
}

QTEST_GUILESS_MAIN(TestTrackFit)
#include "tst_track_fit.moc"
