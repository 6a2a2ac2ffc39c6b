// SPDX-License-Identifier: MIT
// The uncertainty band of a run that is being played equals the one computed directly from the same start.
#include "core/trade/ball_ensemble.h"
#include "core/trade/live_band.h"
#include "inspector/core/scenes.h"
#include "inspector/trade/unknowns_of.h"
#include "support/compare.h"

#include <cmath>

using namespace inspector;

class TestLiveBand : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_band.reset(); }
    void quantilesAreThoseOfDrawnBalls();
    void timesAreThoseOfTheRun();
    void longPiecesAreSmooth();
    void unknownStartIsThereFromTheBeginning();
    void anotherParameterCountsFromThenOn();
    void anotherBeginningForgetsWhatWas();
    void endLeavesNone();
    void endsAtItsReach();
    void finishWaitsForAll();

private:
    void begin(const char *words, double time = 0.0);
    void roll(int segments, double length, Tilt tilt = {0.02, 0.01});
    // Waits for a band that reaches this time, s.
    Band bandUntil(double time);

    Registry m_registry = makeRegistry(nullptr);
    Scene m_scene = openFloor();
    Inputs m_inputs = initialInputs();
    double m_radius = phys_scene_radius(m_scene.get());
    std::unique_ptr<LiveBand> m_band;
};

namespace {

constexpr int kBandPatience = 60000; // ms

} // namespace

void TestLiveBand::init() {
    m_inputs = initialInputs();
    m_band = std::make_unique<LiveBand>(m_registry);
}

void TestLiveBand::begin(const char *words, double time) {
    phys_state start;
    phys_scene_start(m_scene.get(), &start);
    start.time = time;
    m_band->begin({m_scene, start, unknownsOf(words)});
}

void TestLiveBand::roll(int segments, double length, Tilt tilt) {
    LiveBand::Segment segment{m_inputs, length};
    segment.inputs.tilt = tilt;
    m_band->goOn(std::vector<LiveBand::Segment>(size_t(segments), segment));
}

Band TestLiveBand::bandUntil(double time) {
    const auto isThere = [&] { return m_band->latest() && m_band->latest()->times.back() >= time - 1e-9; };
    if (!QTest::qWaitFor(isThere, kBandPatience)) qFatal("no band until %g s", time);
    return *m_band->latest();
}

void TestLiveBand::quantilesAreThoseOfDrawnBalls() {
    begin("tilt=0.1deg,rolling_friction=50%");
    roll(25, 0.04);
    const Band band = bandUntil(1.0);

    phys_state start;
    phys_scene_start(m_scene.get(), &start);
    const Stepper stepper = makeStepper(m_registry, "exact", m_scene, nullptr);
    const Unknowns unknowns = unknownsOf("tilt=0.1deg,rolling_friction=50%");
    BallEnsemble balls(stepper, m_scene, sampleBoards(unknowns, m_inputs, LiveBand::kBalls, kBandSeed), start);
    BallEnsemble known(stepper, m_scene, {SampledBoard{m_inputs.params, m_inputs.gravity, {}, {}}}, start);
    Band expected;
    appendQuantiles(expected, 0.0, balls.distancesFrom(known.centre(0)), m_radius);
    for (int i = 1; i <= 25; ++i) {
        balls.step({0.02, 0.01}, 0.04, 1);
        known.step({0.02, 0.01}, 0.04, 1);
        appendQuantiles(expected, 0.04 * i, balls.distancesFrom(known.centre(0)), m_radius);
    }
    QCOMPARE(band.times.size(), size_t(26));
    for (size_t i = 0; i < expected.times.size(); ++i) {
        COMPARE_EXACT(band.low[i], expected.low[i]);
        COMPARE_EXACT(band.middle[i], expected.middle[i]);
        COMPARE_EXACT(band.high[i], expected.high[i]);
    }
    QVERIFY(band.middle.back() > 0.0);
}

void TestLiveBand::timesAreThoseOfTheRun() {
    begin("tilt=0.1deg", 3.5);
    roll(10, 0.05);
    const Band band = bandUntil(4.0);
    COMPARE_EXACT(band.times.front(), 3.5);
    COMPARE_WITHIN(band.times.back(), 4.0, 1e-9);
}

void TestLiveBand::longPiecesAreSmooth() {
    begin("tilt=0.1deg");
    roll(1, 2.0);
    const Band band = bandUntil(2.0);
    for (size_t i = 1; i < band.times.size(); ++i) QVERIFY(band.times[i] - band.times[i - 1] < 0.051);
}

// Each coordinate is off by at most 0.1 mm.
void TestLiveBand::unknownStartIsThereFromTheBeginning() {
    begin("start=0.1mm");
    roll(1, 0.05, {});
    const Band band = bandUntil(0.05);
    QVERIFY(band.low.front() > 0.0);
    QVERIFY(band.high.front() * m_radius <= 1e-4 * std::sqrt(2.0));
    COMPARE_WITHIN(band.middle.back(), band.middle.front(), 1e-9); // level and at rest
}

// A share of a friction that is 0 is 0.
void TestLiveBand::anotherParameterCountsFromThenOn() {
    m_inputs.params.rolling_friction = 0.0;
    begin("rolling_friction=50%");
    roll(20, 0.05);
    COMPARE_EXACT(bandUntil(1.0).high.back(), 0.0);
    m_inputs.params.rolling_friction = 0.005;
    roll(20, 0.05);
    QVERIFY(bandUntil(2.0).middle.back() > 0.0);
}

void TestLiveBand::anotherBeginningForgetsWhatWas() {
    begin("tilt=0.1deg");
    roll(20, 0.05);
    bandUntil(1.0);
    begin("tilt=0.1deg", 7.0);
    QVERIFY(!m_band->latest());
    roll(2, 0.05);
    COMPARE_EXACT(bandUntil(7.1).times.front(), 7.0);
}

void TestLiveBand::endLeavesNone() {
    begin("tilt=0.1deg");
    roll(20, 0.05);
    bandUntil(1.0);
    m_band->end();
    QVERIFY(!m_band->latest());
}

void TestLiveBand::endsAtItsReach() {
    begin("start=0.1mm");
    roll(int(LiveBand::kReach) + 5, 1.0, {});
    const Band band = bandUntil(LiveBand::kReach);
    QVERIFY(band.times.back() < LiveBand::kReach + 1.001);
}

void TestLiveBand::finishWaitsForAll() {
    begin("tilt=0.1deg");
    roll(200, 0.05);
    m_band->finish();
    QVERIFY(m_band->latest());
    COMPARE_WITHIN(m_band->latest()->times.back(), 10.0, 1e-9);
    m_band->end();
    m_band->finish(); // nothing to wait for
}

QTEST_GUILESS_MAIN(TestLiveBand)
#include "tst_live_band.moc"
