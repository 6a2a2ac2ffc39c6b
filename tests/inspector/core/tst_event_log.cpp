// SPDX-License-Identifier: MIT
// The event log: what it keeps, what it folds, and that a concurrent reader sees whole entries.
#include "core/events/bounce.h"
#include "core/events/event_log.h"
#include "core/simulation/simulation.h"
#include "inspector/core/scenes.h"
#include "inspector/core/wall_ahead.h"

#include <algorithm>
#include <cmath>
#include <thread>

using namespace inspector;

class TestEventLog : public QObject {
    Q_OBJECT

private slots:
    void capacityIsAPowerOfTwo();
    void entriesReadBackInOrder();
    void oldestAreOverwritten();
    void clearStartsAnewButNumbersGoOn();
    void heldEntriesAreSeenAllAtOnce();
    void revisionTellsOfEveryChange();
    void slowImpactsInARowAreOneEntry();
    void fastImpactsAreNeverFolded();
    void fastImpactEndsARowOfSlowOnes();
    void waitBetweenSlowImpactsMakesAnotherEntry();
    void slowImpactsInTurnsOnTwoBoxesAreTwoEntries();
    void nothingIsFoldedIntoTheRunBefore();
    void lostEventsAreCountedUntilTheNextRun();
    void entryHoldsTheStepThatMadeIt();
    void leavingTheMazeIsAnEntry();
    void threadLogsTheSameAsStepsByHand();
    void restartEmptiesTheLog();
    void readingWhileAnotherThreadWritesGivesOnlyWholeEntries();
};

namespace {

constexpr double kFast = 2.0 * kCountedImpact;
constexpr double kSlow = 0.5 * kCountedImpact;
constexpr double kDt = 0.01;

phys_event impact(double time, double speed, uint32_t box = 3) {
    phys_event event{};
    event.time = time;
    event.normal = {1.0, 0.0, 0.0};
    event.speed_before = -speed;
    event.speed_after = 0.5 * speed;
    event.kind = PHYS_EVENT_IMPACT;
    event.box = box;
    return event;
}

StepFacts stepOf(uint64_t number) {
    StepFacts step;
    step.dt = kDt;
    step.after.step = number;
    step.eventCount = 1;
    return step;
}

void append(EventLog &log, const phys_event &event, uint64_t number = 0) { log.append(event, stepOf(number)); }

std::vector<LoggedEvent> entriesOf(const EventLog &log) {
    std::vector<LoggedEvent> entries;
    LoggedEvent entry;
    for (uint64_t number = log.first(); number < log.last(); ++number)
        if (log.read(number, entry)) entries.push_back(entry);
    return entries;
}

constexpr double kFace = 0.1;             // m, of the wall ahead of the ball
constexpr uint64_t kStepsToTheWall = 100; // of 10 ms at 5 degrees: s = 0.3 m without the wall

bool isSame(const LoggedEvent &a, const LoggedEvent &b) {
    return a.number == b.number && a.event.time == b.event.time && a.event.box == b.event.box && a.count == b.count &&
           a.until == b.until && a.fastest == b.fastest && a.step.after.step == b.step.after.step &&
           phys_state_hash(&a.step.after) == phys_state_hash(&b.step.after);
}

} // namespace

void TestEventLog::capacityIsAPowerOfTwo() {
    QCOMPARE(EventLog(1).capacity(), size_t(64));
    QCOMPARE(EventLog(100).capacity(), size_t(128));
    QCOMPARE(EventLog().capacity(), EventLog::kDefaultCapacity);
}

void TestEventLog::entriesReadBackInOrder() {
    EventLog log(64);
    for (uint64_t i = 0; i < 50; ++i) append(log, impact(double(i), kFast, uint32_t(i)), i);
    const std::vector<LoggedEvent> entries = entriesOf(log);
    QCOMPARE(entries.size(), size_t(50));
    for (uint64_t i = 0; i < 50; ++i) {
        QCOMPARE(entries[i].number, i);
        QCOMPARE(entries[i].event.time, double(i));
        QCOMPARE(entries[i].event.box, uint32_t(i));
        QCOMPARE(entries[i].step.after.step, i);
        QCOMPARE(entries[i].count, uint64_t(1));
    }
    LoggedEvent none;
    QVERIFY(!log.read(50, none));
}

void TestEventLog::oldestAreOverwritten() {
    EventLog log(64);
    for (uint64_t i = 0; i < 1000; ++i) append(log, impact(double(i), kFast));
    QCOMPARE(log.first(), uint64_t(1000 - 64));
    QCOMPARE(log.dropped(), uint64_t(1000 - 64));
    LoggedEvent entry;
    QVERIFY(!log.read(log.first() - 1, entry));
    QVERIFY(log.read(log.first(), entry));
    QCOMPARE(entry.event.time, double(1000 - 64));
}

void TestEventLog::clearStartsAnewButNumbersGoOn() {
    EventLog log(64);
    for (uint64_t i = 0; i < 100; ++i) append(log, impact(double(i), kFast));
    log.clear();
    QCOMPARE(log.first(), log.last());
    QCOMPARE(log.dropped(), uint64_t(0));
    QCOMPARE(log.generation(), uint64_t(1));
    append(log, impact(0.0, kFast)); // time may decrease now
    QCOMPARE(log.first(), uint64_t(100));
    QCOMPARE(log.last(), uint64_t(101));
}

void TestEventLog::heldEntriesAreSeenAllAtOnce() {
    EventLog log(64);
    for (uint64_t i = 0; i < 10; ++i) append(log, impact(double(i), kFast));
    const uint64_t revision = log.revision();
    log.hold();
    log.clear();
    append(log, impact(0.0, kFast));
    log.noteLost(3);
    QCOMPARE(log.last() - log.first(), uint64_t(10));
    QCOMPARE(log.generation(), uint64_t(0));
    QCOMPARE(log.revision(), revision);
    QCOMPARE(log.lost(), uint64_t(0));
    log.release();
    QCOMPARE(log.first(), uint64_t(10));
    QCOMPARE(log.last(), uint64_t(11));
    QCOMPARE(log.generation(), uint64_t(1));
    QVERIFY(log.revision() != revision);
    QCOMPARE(log.lost(), uint64_t(3));
    QCOMPARE(entriesOf(log).size(), size_t(1));
}

void TestEventLog::revisionTellsOfEveryChange() {
    EventLog log(64);
    std::vector<uint64_t> revisions{log.revision()};
    append(log, impact(0.0, kSlow));
    revisions.push_back(log.revision());
    append(log, impact(kDt, kSlow)); // grows the entry
    revisions.push_back(log.revision());
    log.noteLost(1);
    revisions.push_back(log.revision());
    log.clear();
    revisions.push_back(log.revision());
    QVERIFY(std::adjacent_find(revisions.begin(), revisions.end()) == revisions.end());
}

void TestEventLog::slowImpactsInARowAreOneEntry() {
    EventLog log(64);
    for (uint64_t i = 0; i < 83; ++i) append(log, impact(double(i) * kDt, i == 40 ? 1.5 * kSlow : kSlow), i);
    const std::vector<LoggedEvent> entries = entriesOf(log);
    QCOMPARE(entries.size(), size_t(1));
    QCOMPARE(entries[0].count, uint64_t(83));
    QCOMPARE(entries[0].event.time, 0.0);
    QCOMPARE(entries[0].until, 82 * kDt);
    QCOMPARE(entries[0].fastest, 1.5 * kSlow);
    QCOMPARE(entries[0].step.after.step, uint64_t(0)); // the first of them
}

void TestEventLog::fastImpactsAreNeverFolded() {
    EventLog log(64);
    for (uint64_t i = 0; i < 10; ++i) append(log, impact(double(i) * kDt, kCountedImpact));
    QCOMPARE(entriesOf(log).size(), size_t(10));
}

void TestEventLog::fastImpactEndsARowOfSlowOnes() {
    EventLog log(64);
    for (const double speed : {kSlow, kSlow, kFast, kSlow, kSlow, kSlow})
        append(log, impact(double(log.revision()) * kDt, speed));
    const std::vector<LoggedEvent> entries = entriesOf(log);
    QCOMPARE(entries.size(), size_t(3));
    QCOMPARE(entries[0].count, uint64_t(2));
    QCOMPARE(entries[1].count, uint64_t(1));
    QCOMPARE(entries[2].count, uint64_t(3));
}

void TestEventLog::waitBetweenSlowImpactsMakesAnotherEntry() {
    EventLog log(64);
    append(log, impact(0.0, kSlow));
    append(log, impact(0.9 * EventLog::kFoldTime, kSlow));
    append(log, impact(2.0 * EventLog::kFoldTime, kSlow));
    QCOMPARE(entriesOf(log).size(), size_t(2));
}

void TestEventLog::slowImpactsInTurnsOnTwoBoxesAreTwoEntries() {
    EventLog log(64);
    for (uint32_t step = 0; step < 50; ++step)
        for (const uint32_t box : {0U, 1U}) append(log, impact(step * kDt, kSlow, box));
    const std::vector<LoggedEvent> entries = entriesOf(log);
    QCOMPARE(entries.size(), size_t(2));
    QCOMPARE(entries[0].count, uint64_t(50));
    QCOMPARE(entries[1].count, uint64_t(50));
}

void TestEventLog::nothingIsFoldedIntoTheRunBefore() {
    EventLog log(64);
    append(log, impact(0.0, kSlow));
    log.clear();
    append(log, impact(0.0, kSlow));
    const std::vector<LoggedEvent> entries = entriesOf(log);
    QCOMPARE(entries.size(), size_t(1));
    QCOMPARE(entries[0].count, uint64_t(1));
}

void TestEventLog::lostEventsAreCountedUntilTheNextRun() {
    EventLog log(64);
    log.noteLost(5);
    log.noteLost(7);
    QCOMPARE(log.lost(), uint64_t(12));
    log.clear();
    QCOMPARE(log.lost(), uint64_t(0));
}

void TestEventLog::entryHoldsTheStepThatMadeIt() {
    const auto engine = engineOn(wallAhead(kFace));
    engine->setInputs(tilted(5.0, 0.0));
    EventLog log(64);
    while (log.last() == 0 && engine->state().step < kStepsToTheWall) {
        QVERIFY(engine->step(nullptr));
        log.note(*engine, 1);
    }
    LoggedEvent entry;
    QVERIFY(log.read(0, entry));
    QCOMPARE(entry.event.kind, uint32_t(PHYS_EVENT_IMPACT));
    QCOMPARE(entry.event.box, uint32_t(1));
    QCOMPARE(entry.event.normal.x, -1.0);
    QCOMPARE(phys_state_hash(&entry.step.before), phys_state_hash(&engine->previous()));
    QCOMPARE(phys_state_hash(&entry.step.after), phys_state_hash(&engine->state()));
    QCOMPARE(entry.step.params.restitution_wall, engine->inputs().params.restitution_wall);
    QCOMPARE(entry.step.penetration, engine->report().penetration);
    QCOMPARE(entry.step.dt, engine->dt());
    QCOMPARE(entry.step.stepper, uint32_t(1));
    QCOMPARE(entry.step.eventCount, engine->report().event_count);
}

void TestEventLog::leavingTheMazeIsAnEntry() {
    const auto engine = engineOn(openFloor());
    engine->setInputs(tilted(10.0, 0.0));
    EventLog log(64);
    while (!(engine->state().flags & PHYS_OUT) && engine->state().step < 1000) {
        QVERIFY(engine->step(nullptr));
        log.note(*engine, kNoStepper);
    }
    QVERIFY(engine->step(nullptr)); // also outside, but it doesn't leave again
    log.note(*engine, kNoStepper);
    const std::vector<LoggedEvent> entries = entriesOf(log);
    const auto isLeaving = [](const LoggedEvent &entry) { return entry.event.kind == kLeftMazeEvent; };
    QCOMPARE(std::count_if(entries.begin(), entries.end(), isLeaving), 1L);
    const auto left = std::find_if(entries.begin(), entries.end(), isLeaving);
    QCOMPARE(left->event.time, engine->previous().time);
    QCOMPARE(left->event.box, PHYS_NO_BOX);
}

void TestEventLog::threadLogsTheSameAsStepsByHand() {
    const Scene scene = wallAhead(kFace);
    const auto engine = engineOn(scene);
    engine->setInputs(tilted(5.0, 2.0));
    EventLog expected;
    Simulation simulation(scene, defaultStepper(scene));
    simulation.setInputs(tilted(5.0, 2.0));
    for (uint64_t i = 0; i < 3 * kStepsToTheWall; ++i) {
        QVERIFY(engine->step(nullptr));
        expected.note(*engine, kNoStepper);
        simulation.stepOnce();
    }
    QTRY_COMPARE(simulation.latest().current.step, uint64_t(3 * kStepsToTheWall));
    const std::vector<LoggedEvent> byHand = entriesOf(expected);
    QTRY_COMPARE(simulation.events().revision(), expected.revision());
    const std::vector<LoggedEvent> byThread = entriesOf(simulation.events());
    QVERIFY(!byHand.empty());
    QVERIFY(std::equal(byHand.begin(), byHand.end(), byThread.begin(), byThread.end(), isSame));
}

void TestEventLog::restartEmptiesTheLog() {
    const Scene scene = wallAhead(kFace);
    Simulation simulation(scene, defaultStepper(scene));
    simulation.setInputs(tilted(5.0, 0.0));
    for (uint64_t i = 0; i < kStepsToTheWall; ++i) simulation.stepOnce();
    QTRY_VERIFY(simulation.events().last() > 0);
    simulation.restart();
    QTRY_COMPARE(simulation.events().generation(), uint64_t(1));
    QCOMPARE(simulation.events().first(), simulation.events().last());
}

// Every number of an entry follows from its own number and count, so that a torn entry shows. Each is written three
// times: two slow impacts on a box of its own are folded into the first.
void TestEventLog::readingWhileAnotherThreadWritesGivesOnlyWholeEntries() {
    constexpr int kReads = 20000;
    EventLog log(64);
    const std::jthread writer([&](const std::stop_token &stop) {
        for (uint64_t i = 0; !stop.stop_requested(); ++i)
            for (int n = 0; n < 3; ++n) append(log, impact(double(i) + 0.01 * n, kSlow, uint32_t(i)), i);
    });
    for (int reads = 0; reads < kReads;) {
        const uint64_t last = log.last();
        for (const uint64_t back : {uint64_t(1), uint64_t(32), uint64_t(62)}) {
            LoggedEvent entry;
            if (last < back || !log.read(last - back, entry)) continue;
            ++reads;
            QCOMPARE(entry.number, last - back);
            QCOMPARE(entry.event.time, double(entry.number));
            QCOMPARE(entry.event.box, uint32_t(entry.number));
            QCOMPARE(entry.step.after.step, entry.number);
            QVERIFY(entry.count >= 1 && entry.count <= 3);
            QCOMPARE(entry.until, double(entry.number) + 0.01 * double(entry.count - 1));
        }
    }
}

QTEST_GUILESS_MAIN(TestEventLog)
#include "tst_event_log.moc"
