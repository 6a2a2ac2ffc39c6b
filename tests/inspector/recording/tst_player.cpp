// SPDX-License-Identifier: MIT
// A recording can be shown at any position, with the recorded states, however the position is reached.
#include "core/recording/player.h"
#include "core/recording/recorder.h"
#include "core/simulation/simulation.h"
#include "inspector/core/scenes.h"
#include "inspector/recording/recorded_steps.h"
#include "support/compare.h"
#include "support/random.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>

using namespace inspector;
using support::sameBits;

class TestPlayer : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void everyStepForwardsHasItsHash();
    void everyStepBackwardsHasItsHash();
    void randomSeeksHaveTheirHashes();
    void stateBeforeAndReportAreThoseOfTheStep();
    void seekTakesAtMostTheIntervalOfKeyframes();
    void seekGoesNoFartherThanWhatIsChecked();
    void flippedHashIsTheFirstDifference();
    void stepThatFailsUnexpectedlyIsTheEnd();
    void recordedFailureIsNoStep();
    void runsAndPlacesInTime();
    void missingMazeOfALaterLevelIsFoundBeforeTheFirstStep();
    void simulationShowsTheRecordedSamples();
    void seekShowsTheSamplesOfTheRunUpToThere();
    void aFineGhostDoesntKeepASeekFromBeingReplaced();
    void stepBackAndForwardAreOneStep();
    void replayPausesAtTheFirstDifference();
    void differenceIsToldWhenStepsAreAheadOfTheChecks();
    void replayOfItsEndBeginsAgain();
    void goingOnGivesTheBitsOfAnEngineFromThere();
    void liveBallIsWhereItWasAfterAReplay();
    void ghostFollowsAReplayAsItFollowsTheLiveBall();

private:
    QString path(const char *name) const { return m_folder->filePath(name); }
    std::shared_ptr<const PlayableRecording> opened() const;
    void recordManyThings() const;
    void recordSteps(int steps, double dt) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

constexpr const char *kMaze1 = LEVELS_FOLDER "/01.txt";
constexpr const char *kMaze3 = LEVELS_FOLDER "/03.txt";

uint64_t hashAt(const PlayableRecording &recording, uint64_t position) {
    for (const Segment &segment : recording.recording().segments) {
        if (position <= segment.hashes.size()) return segment.hashes[position - 1];
        position -= segment.hashes.size();
    }
    qFatal("no such position");
}

uint64_t shownHash(const Player &player) { return phys_state_hash(&player.engine().state()); }

Player checkedPlayer(const std::shared_ptr<const PlayableRecording> &recording) {
    Player player(recording);
    while (player.check()) {
    }
    return player;
}

std::unique_ptr<Simulation> simulationOnLevel1() {
    const Scene scene = levelScene(1);
    return std::make_unique<Simulation>(scene, defaultStepper(scene));
}

} // namespace

std::shared_ptr<const PlayableRecording> TestPlayer::opened() const {
    QString error;
    auto recording = openRecording(path("r"), makeRegistry(nullptr), {}, &error);
    if (!recording) qFatal("%s", qPrintable(error));
    return recording;
}

// 2400 steps as a user makes them: tilts, another stepper and dt, a restart, an earlier state, a step that fails,
// another level.
void TestPlayer::recordManyThings() const {
    const Registry registry = makeRegistry(nullptr);
    const Scene scene = levelScene(1);
    Recorder recorder(path("r"));
    recorder.setOrigin(originOf(registry, PHYS_STEPPER_DEFAULT, kMaze1));
    Engine engine(scene, makeStepper(registry, PHYS_STEPPER_DEFAULT, scene, nullptr));
    for (int i = 0; i < 100; ++i) {
        engine.setInputs(tilted(0.05 * i, 4.0 - 0.07 * i));
        stepRecorded(engine, recorder, 7);
    }
    const phys_state kept = engine.state();
    engine.setStepper(makeStepper(registry, "exact", scene, nullptr));
    recorder.setOrigin(originOf(registry, "exact", kMaze1));
    engine.setDt(0.001);
    stepRecorded(engine, recorder, 500);
    engine.restart();
    stepRecorded(engine, recorder, 300);
    engine.setState(kept);
    stepRecorded(engine, recorder, 200);
    engine.setStepper(makeStepper(registry, PHYS_STEPPER_DEFAULT, scene, nullptr));
    recorder.setOrigin(originOf(registry, PHYS_STEPPER_DEFAULT, kMaze1));
    phys_state fast = engine.state();
    fast.velocity.x = 1e12; // more substeps than allowed
    engine.setState(fast);
    QString error;
    QVERIFY(!engine.step(&error));
    recorder.noteFailure(engine, error);
    const Scene other = levelScene(3);
    engine.setScene(other, makeStepper(registry, "rk4", other, nullptr));
    recorder.setOrigin(originOf(registry, "rk4", kMaze3));
    engine.setInputs(tilted(2.0, 1.0));
    stepRecorded(engine, recorder, 700);
    recorder.close();
}

// Of the default stepper on a tilted board.
void TestPlayer::recordSteps(int steps, double dt) const {
    const Scene scene = levelScene(1);
    Recorder recorder(path("r"));
    recorder.setOrigin(originOf(makeRegistry(nullptr), PHYS_STEPPER_DEFAULT, kMaze1));
    Engine engine(scene, defaultStepper(scene));
    engine.setDt(dt);
    engine.setInputs(tilted(3.0, 2.0));
    stepRecorded(engine, recorder, steps);
    recorder.close();
}

void TestPlayer::everyStepForwardsHasItsHash() {
    recordManyThings();
    const auto recording = opened();
    QCOMPARE(recording->length(), uint64_t(2400));
    Player player(recording);
    for (uint64_t position = 1; position <= recording->length(); ++position) {
        QVERIFY(player.next());
        QCOMPARE(player.position(), position);
        QCOMPARE(shownHash(player), hashAt(*recording, position));
    }
    QVERIFY(!player.next());
    QVERIFY(player.isChecked() && !player.difference());
}

void TestPlayer::everyStepBackwardsHasItsHash() {
    recordManyThings();
    const auto recording = opened();
    Player player = checkedPlayer(recording);
    for (uint64_t position = recording->length(); position > 0; --position) {
        player.seek(position);
        QCOMPARE(player.position(), position);
        QCOMPARE(shownHash(player), hashAt(*recording, position));
    }
    player.seek(0);
    QVERIFY(sameBits(player.engine().state(), *recording->segment(0).from));
}

void TestPlayer::randomSeeksHaveTheirHashes() {
    recordManyThings();
    const auto recording = opened();
    Player player = checkedPlayer(recording);
    const uint64_t seed = support::testSeed();
    support::Random random(seed);
    for (int i = 0; i < 500; ++i) {
        uint64_t position = 1 + random.below(uint32_t(recording->length()));
        player.seek(position);
        // Playback sometimes continues from there.
        for (uint32_t more = random.below(4); more > 0 && player.next(); --more) ++position;
        QVERIFY2(player.position() == position && shownHash(player) == hashAt(*recording, position),
                 qPrintable(QString("seed %1, seek %2, to %3").arg(seed).arg(i).arg(position)));
    }
}

// The other data that drawing and plots need is the same whether a position is played to or sought.
void TestPlayer::stateBeforeAndReportAreThoseOfTheStep() {
    recordManyThings();
    const auto recording = opened();
    Player played(recording);
    Player sought = checkedPlayer(recording);
    for (uint64_t position = 1; position <= recording->length(); ++position) {
        QVERIFY(played.next());
        const bool isNearBoundary = position % 100 <= 1;
        if (!isNearBoundary && position % 7 != 0) continue;
        sought.seek(recording->length() - position); // from another position
        sought.seek(position);
        QVERIFY(sameBits(sought.engine().previous(), played.engine().previous()));
        QVERIFY(sameBits(sought.engine().sample().values, played.engine().sample().values));
        QCOMPARE(sought.segment(), played.segment());
        QCOMPARE(sought.engine().dt(), played.engine().dt());
        QVERIFY(sameBits(sought.engine().inputs(), played.engine().inputs()));
    }
}

void TestPlayer::seekTakesAtMostTheIntervalOfKeyframes() {
    recordSteps(1000000, 0.01);
    const auto recording = opened();
    Player player = checkedPlayer(recording);
    QCOMPARE(player.checked(), uint64_t(1000000));
    support::Random random(support::testSeed());
    for (int i = 0; i < 1000; ++i) {
        const uint64_t position = random.below(1000001);
        const uint64_t steps = player.seek(position);
        QVERIFY(player.position() == position);
        QVERIFY(steps <= Player::kKeyframeInterval);
        if (position > 0) QCOMPARE(shownHash(player), hashAt(*recording, position));
    }
    QCOMPARE(player.seek(player.position()), uint64_t(0));
}

void TestPlayer::seekGoesNoFartherThanWhatIsChecked() {
    recordManyThings();
    Player player(opened());
    for (int i = 0; i < 100; ++i) QVERIFY(player.check());
    player.seek(2000);
    QCOMPARE(player.position(), uint64_t(100));
}

void TestPlayer::flippedHashIsTheFirstDifference() {
    recordManyThings();
    Recording text = *readRecording(path("r"), makeRegistry(nullptr), nullptr);
    uint64_t &hash = text.segments.back().hashes[41];
    hash ^= 1;
    const uint64_t expected = hash;
    const auto recording = PlayableRecording::make(text, makeRegistry(nullptr), {}, nullptr);
    Player player(recording);
    while (player.check() && player.checked() < 1741) {
    }
    QVERIFY(!player.difference());
    QVERIFY(player.check());
    QVERIFY(player.difference());
    QCOMPARE(player.difference()->number, uint64_t(1742));
    QCOMPARE(player.difference()->step, uint64_t(42));
    while (player.check()) {
    }
    QCOMPARE(player.difference()->number, uint64_t(1742));
    QCOMPARE(player.end(), uint64_t(2400));
    QVERIFY(verdict(*recording, {0, player.difference()})
                .startsWith(
                    QString("differs: step 1742 of the recording, step 42 since the start, from 0.041 s on: "
                            "expected %1, found %2")
                        .arg(QString::fromLatin1(hashText(expected)), QString::fromLatin1(hashText(expected ^ 1)))));
}

void TestPlayer::stepThatFailsUnexpectedlyIsTheEnd() {
    recordManyThings();
    Recording text = *readRecording(path("r"), makeRegistry(nullptr), nullptr);
    for (Segment &segment : text.segments)
        if (!segment.failure.isEmpty()) segment.hashes = {1, 2, 3};
    Player player = checkedPlayer(PlayableRecording::make(text, makeRegistry(nullptr), {}, nullptr));
    QVERIFY(player.difference());
    QCOMPARE(player.difference()->number, uint64_t(1701));
    QCOMPARE(player.end(), uint64_t(1700));
    player.seek(1702);
    QCOMPARE(player.position(), uint64_t(1700));
    QVERIFY(!player.next());
}

void TestPlayer::recordedFailureIsNoStep() {
    recordManyThings();
    const auto recording = opened();
    const auto &segments = recording->recording().segments;
    QCOMPARE(std::count_if(segments.begin(), segments.end(), [](const Segment &s) { return !s.failure.isEmpty(); }), 1);
    Player player = checkedPlayer(recording);
    player.seek(1699);
    QVERIFY(!player.enterRun());
    QVERIFY(player.next());
    QVERIFY(player.enterRun()); // on the other level
    QCOMPARE(player.position(), uint64_t(1700));
    QCOMPARE(player.engine().state().step, uint64_t(0));
    QVERIFY(player.next());
    QCOMPARE(player.engine().state().step, uint64_t(1));
}

void TestPlayer::runsAndPlacesInTime() {
    recordManyThings();
    const auto recording = opened();
    QCOMPARE(recording->runs(), (std::vector<uint64_t>{0, 1200, 1500, 1700}));
    QCOMPARE(recording->runAt(0).begin, uint64_t(0));
    QCOMPARE(recording->runAt(1).begin, uint64_t(0));
    QCOMPARE(recording->runAt(1200).begin, uint64_t(0)); // its last step
    QCOMPARE(recording->runAt(1201).begin, uint64_t(1200));
    QCOMPARE(recording->runAt(2400).begin, uint64_t(1700));
    // 700 steps of 10 ms, then 1700 of 1 ms.
    QCOMPARE(recording->positionAt(0.0), uint64_t(0));
    QCOMPARE(recording->positionAt(0.3), uint64_t(30));
    QCOMPARE(recording->positionAt(7.0), uint64_t(700));
    QCOMPARE(recording->positionAt(7.25), uint64_t(950));
    QCOMPARE(recording->positionAt(8.7), uint64_t(2400));
    QCOMPARE(recording->positionAt(1e9), uint64_t(2400));
}

void TestPlayer::missingMazeOfALaterLevelIsFoundBeforeTheFirstStep() {
    recordManyThings();
    Recording text = *readRecording(path("r"), makeRegistry(nullptr), nullptr);
    text.segments.back().conditions.maze = {"/nowhere/none.txt", 1};
    QString error;
    QVERIFY(!PlayableRecording::make(text, makeRegistry(nullptr), {}, &error));
    QCOMPARE(error,
             QString("%1:%2: expected the maze file '/nowhere/none.txt' there, beside the recording or among the "
                     "levels, found none")
                 .arg(path("r"))
                 .arg(text.segments.back().mazeLine));
}

// ---- on the thread ----

void TestPlayer::simulationShowsTheRecordedSamples() {
    recordManyThings();
    const auto recording = opened();
    const auto simulation = simulationOnLevel1();
    simulation->setSpeed(Simulation::kFastest);
    simulation->startReplay(recording);
    simulation->run();
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(2400));
    QTRY_VERIFY(!simulation->latest().running);
    const Snapshot end = simulation->latest();
    QCOMPARE(phys_state_hash(&end.current), hashAt(*recording, 2400));
    QVERIFY(end.replay.isChecked && !end.replay.difference);
    QCOMPARE(end.dt, 0.001);
    // The ring holds the last run, from its first step to its last.
    const SampleRing &samples = simulation->samples();
    QCOMPARE(samples.last() - samples.first(), uint64_t(700));
    Player player = checkedPlayer(recording);
    Sample sample;
    for (uint64_t i = 0; i < 700; ++i) {
        player.seek(1701 + i);
        QVERIFY(samples.read(samples.first() + i, sample));
        QVERIFY(sameBits(sample.values, player.engine().sample().values));
    }
}

void TestPlayer::seekShowsTheSamplesOfTheRunUpToThere() {
    recordManyThings();
    const auto simulation = simulationOnLevel1();
    simulation->startReplay(opened());
    const SampleRing &samples = simulation->samples();
    for (const uint64_t position : {2400, 1300, 1350, 1200, 1, 600, 0}) {
        const uint64_t number = simulation->seek(position);
        QTRY_COMPARE(simulation->latest().replay.seeks, number);
        QCOMPARE(simulation->latest().replay.position, position);
        const uint64_t begin = position > 1700 ? 1700 : position > 1200 ? 1200 : 0;
        QCOMPARE(samples.last() - samples.first(), position - begin);
        Sample last;
        if (position == 0) continue;
        QVERIFY(samples.read(samples.last() - 1, last));
        QVERIFY(last.time == simulation->latest().current.time);
    }
}

// A step of this ghost takes about a millisecond, and the first position is ten thousand steps away.
void TestPlayer::aFineGhostDoesntKeepASeekFromBeingReplaced() {
    recordSteps(20000, 0.01);
    const auto simulation = simulationOnLevel1();
    const auto recording = opened();
    simulation->startReplay(recording);
    QTRY_VERIFY(simulation->latest().replay.isChecked);
    QString error;
    const auto setup =
        makeGhostSetup(recording->registry(), {"exact", GhostChoice::kMostSubsteps}, recording->scene(0), &error);
    QVERIFY2(setup, qPrintable(error));
    simulation->compareWith(*setup, PHYS_STEPPER_DEFAULT);
    QSignalSpy ran(simulation.get(), &Simulation::runningChanged);
    simulation->seek(20000);
    simulation->run(); // shows that the previous commands have been executed
    QTRY_COMPARE(ran.size(), 1);
    simulation->pause();
    const uint64_t number = simulation->seek(3);
    QTRY_COMPARE(simulation->latest().replay.seeks, number);
    QCOMPARE(simulation->latest().replay.position, uint64_t(3));
    simulation->seek(20000);
    // Ending the simulation waits for at most one slice of that.
}

void TestPlayer::stepBackAndForwardAreOneStep() {
    recordManyThings();
    const auto recording = opened();
    const auto simulation = simulationOnLevel1();
    simulation->startReplay(recording);
    simulation->seek(1201);
    for (int i = 0; i < 5; ++i) simulation->stepBack();
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1196));
    QVERIFY(!simulation->latest().running);
    QCOMPARE(hashOf(simulation->latest()), hashAt(*recording, 1196));
    for (int i = 0; i < 6; ++i) simulation->stepOnce(); // across a restart
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1202));
    QCOMPARE(hashOf(simulation->latest()), hashAt(*recording, 1202));
    simulation->stepBack();
    simulation->stepOnce(); // immediately; the same position
    simulation->stepBack();
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1201));
    simulation->seek(0);
    simulation->stepBack();
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(0));
}

void TestPlayer::replayPausesAtTheFirstDifference() {
    recordManyThings();
    Recording text = *readRecording(path("r"), makeRegistry(nullptr), nullptr);
    text.segments[3].hashes[2] ^= 1; // step 24
    const auto simulation = simulationOnLevel1();
    std::vector<Difference> found;
    int reached = 0;
    connect(simulation.get(), &Simulation::differenceFound, this,
            [&](uint64_t, const Difference &difference) { found.push_back(difference); });
    connect(simulation.get(), &Simulation::differenceReached, this, [&](uint64_t) { ++reached; });
    simulation->startReplay(PlayableRecording::make(text, makeRegistry(nullptr), {}, nullptr));
    simulation->run();
    QTRY_COMPARE(reached, 1);
    QVERIFY(!simulation->latest().running);
    QCOMPARE(simulation->latest().replay.position, uint64_t(24));
    QTRY_COMPARE(found.size(), size_t(1));
    QCOMPARE(found[0].number, uint64_t(24));
    QCOMPARE(simulation->latest().replay.difference, std::optional<uint64_t>(24));
    simulation->run(); // continues if the user wants it
    QTRY_VERIFY(simulation->latest().replay.position > 24);
}

// Steps of 1 us are always due, so that nothing is checked ahead any more; a busy machine has as little time for
// that.
void TestPlayer::differenceIsToldWhenStepsAreAheadOfTheChecks() {
    constexpr uint64_t kLast = 200000;
    recordSteps(int(kLast), 1e-6);
    Recording text = *readRecording(path("r"), makeRegistry(nullptr), nullptr);
    text.segments.back().hashes.back() ^= 1;
    const auto simulation = simulationOnLevel1();
    QStringList told;
    connect(simulation.get(), &Simulation::differenceFound, this, [&] { told << "found"; });
    connect(simulation.get(), &Simulation::differenceReached, this, [&] { told << "reached"; });
    simulation->setSpeed(Simulation::kFastest);
    simulation->startReplay(PlayableRecording::make(text, makeRegistry(nullptr), {}, nullptr));
    simulation->run();
    QTRY_COMPARE_WITH_TIMEOUT(simulation->latest().replay.position, kLast, 60000); // only ends what hangs
    QTRY_VERIFY(!simulation->latest().running);
    QTRY_COMPARE(told, (QStringList{"found", "reached"}));
}

void TestPlayer::replayOfItsEndBeginsAgain() {
    recordManyThings();
    const auto simulation = simulationOnLevel1();
    simulation->startReplay(opened());
    simulation->seek(2400);
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(2400));
    simulation->run();
    QTRY_VERIFY(simulation->latest().running && simulation->latest().replay.position < 2400);
}

void TestPlayer::goingOnGivesTheBitsOfAnEngineFromThere() {
    recordManyThings();
    const auto recording = opened();
    for (const uint64_t position : {350, 900, 1200, 2000, 2400}) {
        Player player = checkedPlayer(recording);
        player.seek(position);
        const Engine &there = player.engine();
        Engine engine(there.scene(), recording->stepper(player.segment()));
        engine.setDt(there.dt());
        engine.setInputs(there.inputs());
        engine.setState(there.state());

        const auto simulation = simulationOnLevel1();
        simulation->startReplay(recording);
        simulation->seek(position);
        QTRY_COMPARE(simulation->latest().replay.position, position);
        simulation->goOnFrom(position, {});
        QTRY_COMPARE(simulation->latest().replay.number, uint64_t(0));
        QCOMPARE(simulation->latest().current.time, there.state().time);
        for (int i = 0; i < 200; ++i) {
            QVERIFY(engine.step(nullptr));
            simulation->stepOnce();
        }
        const phys_state expected = engine.state();
        QTRY_COMPARE(simulation->latest().current.step, expected.step);
        QVERIFY(sameBits(simulation->latest().current, expected));
    }
}

void TestPlayer::liveBallIsWhereItWasAfterAReplay() {
    recordManyThings();
    const auto simulation = simulationOnLevel1();
    simulation->setInputs(tilted(1.0, 1.0));
    for (int i = 0; i < 5; ++i) simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().current.step, uint64_t(5));
    const phys_state before = simulation->latest().current;
    simulation->startReplay(opened());
    simulation->run();
    QTRY_VERIFY(simulation->latest().replay.position > 10);
    simulation->endReplay();
    QTRY_COMPARE(simulation->latest().replay.number, uint64_t(0));
    QVERIFY(!simulation->latest().running);
    QVERIFY(sameBits(simulation->latest().current, before));
    QCOMPARE(simulation->samples().first(), simulation->samples().last());
}

// Whether played or sought, from the start of the run.
void TestPlayer::ghostFollowsAReplayAsItFollowsTheLiveBall() {
    recordManyThings();
    const auto recording = opened();
    const auto simulation = simulationOnLevel1();
    const auto setup = makeGhostSetup(recording->registry(), {"velocity-verlet", 2}, recording->scene(0), nullptr);
    QVERIFY(setup);
    simulation->startReplay(recording);
    simulation->compareWith(*setup, PHYS_STEPPER_DEFAULT);
    simulation->seek(1201); // a step after a restart
    for (int i = 0; i < 250; ++i) simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1451));
    QVERIFY(simulation->latest().ghost);
    const phys_state played = simulation->latest().ghost->current;
    simulation->seek(100);
    simulation->seek(1451);
    simulation->stepBack();
    simulation->stepOnce();
    QTRY_COMPARE(simulation->latest().replay.seeks, uint64_t(3));
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1451));

    Player player = checkedPlayer(recording);
    player.seek(1200);
    QVERIFY(player.enterRun());
    GhostEngine ghost(player.engine(), *setup, "exact");
    for (int i = 0; i < 251; ++i) QVERIFY(player.next() && ghost.follow(player.engine(), nullptr));
    QVERIFY(sameBits(played, ghost.state()));
    QVERIFY(sameBits(simulation->latest().ghost->current, ghost.state()));
    QVERIFY(simulation->latest().ghost->deviation.distance > 0.0);

    simulation->seek(1701); // on another level: the comparison ends until it is requested there
    QTRY_COMPARE(simulation->latest().replay.position, uint64_t(1701));
    QVERIFY(!simulation->latest().ghost);
}

QTEST_GUILESS_MAIN(TestPlayer)
#include "tst_player.moc"
