// SPDX-License-Identifier: MIT
// A measured ball beside a run: its position at the run's times, and a ball that rolls under its tilts.
#include "core/setup/levels.h"
#include "core/track/shown_track.h"
#include "inspector/core/scenes.h"
#include "inspector/track/made_track.h"
#include "support/compare.h"

#include <algorithm>
#include <cmath>

using namespace inspector;

class TestShownTrack : public QObject {
    Q_OBJECT

private slots:
    void betweenPointsItMovesStraight();
    void beforeAndAfterItIsNowhere();
    void gapsAreEmpty();
    void frameBringsItOntoTheBoard();
    void timesBeginWhereAsked();
    void ownTimesStayIfTheyBeginSoon();
    void tiltsComeWithOffsetAndDelay();
    void startRollsOnTheFloor();
    void sampleHasItsPlaceAndTheDistance();
    void ballThatFollowsItStaysWithIt();
    void tiltsThatChangeWithinAStepKeepItWithIt();
};

namespace {

// 20 points at 50 a second, 0.1 m/s along x and 0.2 m/s along y.
Track straight(double begin = 0.0) {
    Track track;
    for (int i = 0; i < 20; ++i) track.points.push_back({begin + 0.02 * i, 0.002 * i, 0.004 * i});
    track.tilts = {{begin, {0.01, 0.0}}, {begin + 0.2, {0.0, 0.03}}};
    return track;
}

BoardParameters plain() { return {initialInputs().params, 9.81, {}, 0.0, {}}; }

} // namespace

void TestShownTrack::betweenPointsItMovesStraight() {
    const ShownTrack shown(straight(), plain(), 0.0);
    const auto place = shown.at(0.105);
    QVERIFY(place);
    COMPARE_WITHIN(place->x, 0.0105, 1e-15);
    COMPARE_WITHIN(place->y, 0.021, 1e-15);
    COMPARE_WITHIN(place->vx, 0.1, 1e-12);
    COMPARE_WITHIN(place->vy, 0.2, 1e-12);
}

void TestShownTrack::beforeAndAfterItIsNowhere() {
    const ShownTrack shown(straight(), plain(), 1.0);
    QVERIFY(!shown.at(0.999));
    QVERIFY(shown.at(1.0));
    QVERIFY(shown.at(1.38));
    QVERIFY(!shown.at(1.381));
}

void TestShownTrack::gapsAreEmpty() {
    Track track = straight();
    track.points.erase(track.points.begin() + 5, track.points.begin() + 9);
    const ShownTrack shown(track, plain(), 0.0);
    QVERIFY(shown.at(0.079));
    QVERIFY(!shown.at(0.1));
    QVERIFY(shown.at(0.181));
}

void TestShownTrack::frameBringsItOntoTheBoard() {
    BoardParameters board = plain();
    board.frame = {2.0, radians(90.0), 0.5, 0.0};
    const ShownTrack shown(straight(), board, 0.0);
    const auto place = shown.at(0.2);
    COMPARE_WITHIN(place->x, 0.5 - 2.0 * 0.04, 1e-12);
    COMPARE_WITHIN(place->y, 2.0 * 0.02, 1e-12);
}

void TestShownTrack::timesBeginWhereAsked() {
    const ShownTrack shown(straight(1234.5), plain(), 0.25);
    COMPARE_EXACT(shown.begin(), 0.25);
    COMPARE_WITHIN(shown.end(), 0.25 + 0.38, 1e-9);
}

void TestShownTrack::ownTimesStayIfTheyBeginSoon() {
    COMPARE_EXACT(usualBegin(straight(0.01)), 0.01);
    COMPARE_EXACT(usualBegin(straight(1234.5)), 0.0);
    COMPARE_EXACT(usualBegin(straight(-3.0)), 0.0);
}

void TestShownTrack::tiltsComeWithOffsetAndDelay() {
    BoardParameters board = plain();
    board.tiltOffset = {0.001, 0.002};
    board.delay = 0.05;
    const ShownTrack shown(straight(), board, 0.0);
    COMPARE_EXACT(shown.tiltBetween(0.0, 0.01).x, 0.011);
    COMPARE_EXACT(shown.tiltBetween(0.24, 0.25).x, 0.011);
    COMPARE_EXACT(shown.tiltBetween(0.25, 0.26).x, 0.001);
    COMPARE_EXACT(shown.tiltBetween(0.25, 0.26).y, 0.032);
    COMPARE_WITHIN(shown.tiltBetween(0.24, 0.28).x, 0.25 * 0.011 + 0.75 * 0.001, 1e-15);
}

void TestShownTrack::startRollsOnTheFloor() {
    const Scene scene = openFloor();
    const phys_state start = ShownTrack(straight(), plain(), 0.0).start(scene.get());
    COMPARE_WITHIN(start.velocity.x, 0.1, 1e-9);
    COMPARE_WITHIN(start.spin.y, start.velocity.x / phys_scene_radius(scene.get()), 1e-9);
    COMPARE_EXACT(start.time, 0.0);
}

void TestShownTrack::sampleHasItsPlaceAndTheDistance() {
    const ShownTrack shown(straight(), plain(), 0.0);
    Sample sample;
    sample.values.fill(std::nan(""));
    sample.time = 0.1;
    sample[Channel::PositionX] = 0.01 + 0.003;
    sample[Channel::PositionY] = 0.02 + 0.004;
    shown.addTo(sample);
    COMPARE_WITHIN(sample[Channel::TrackX], 0.01, 1e-15);
    COMPARE_WITHIN(sample[Channel::TrackY], 0.02, 1e-15);
    COMPARE_WITHIN(sample[Channel::TrackSpeed], std::hypot(0.1, 0.2), 1e-12);
    COMPARE_WITHIN(sample[Channel::TrackDistance], 0.005, 1e-15);
    sample.time = 5.0;
    sample[Channel::TrackX] = std::nan("");
    shown.addTo(sample);
    QVERIFY(std::isnan(sample[Channel::TrackX]));
}

// Computed by "exact" under the tilts of the track: at its points both agree up to rounding.
void TestShownTrack::ballThatFollowsItStaysWithIt() {
    const Registry registry = makeRegistry(nullptr);
    const Scene scene = openFloor();
    const Track track = support::makeTrack(registry, scene, plain(), {.duration = 2.0, .rate = 100.0, .noise = 0.0});
    const auto shown = std::make_shared<ShownTrack>(track, plain(), 0.0);
    Engine engine(scene, makeStepper(registry, "exact", scene, nullptr));
    Inputs inputs = initialInputs();
    engine.setInputs(inputs);
    engine.setPilot(std::make_shared<TrackPilot>(shown));
    engine.setDt(0.01);
    for (int i = 0; i < 200; ++i) {
        QVERIFY(engine.step(nullptr));
        Sample sample = engine.sample();
        shown->addTo(sample);
        if (i < 199) QVERIFY(sample[Channel::TrackDistance] < 1e-6); // the last may be beyond the track by rounding
    }
    QVERIFY(std::hypot(engine.state().velocity.x, engine.state().velocity.y) > 0.01);
}

// A delay as fits find it. Off walls a small difference grows.
void TestShownTrack::tiltsThatChangeWithinAStepKeepItWithIt() {
    const Registry registry = makeRegistry(nullptr);
    const Scene scene = loadScene(levelsIn(LEVELS_FOLDER)[2].path, nullptr);
    BoardParameters board = plain();
    board.delay = 0.0037;
    const Track track = support::makeTrack(registry, scene, board, {.duration = 4.0, .noise = 0.0, .seed = 2});
    phys_state start;
    phys_scene_start(scene.get(), &start);
    const auto shown =
        std::make_shared<ShownTrack>(track, board, 0.0, BallStart{start.position.x, start.position.y, 0.0, 0.0});
    Engine engine(scene, makeStepper(registry, "exact", scene, nullptr));
    engine.setInputs(initialInputs());
    engine.setPilot(std::make_shared<TrackPilot>(shown));
    double largest = 0.0;
    while (engine.state().time < 1.5) { // several bounces
        QVERIFY(engine.step(nullptr));
        Sample sample = engine.sample();
        shown->addTo(sample);
        const bool isAtAPoint = engine.state().step % 20 == 0; // 12 pictures
        if (isAtAPoint) largest = std::max(largest, sample[Channel::TrackDistance]);
    }
    QVERIFY2(largest > 0.0 && largest < 5e-5, qPrintable(QString::number(largest)));
}

QTEST_GUILESS_MAIN(TestShownTrack)
#include "tst_shown_track.moc"
