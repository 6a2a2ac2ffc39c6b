// SPDX-License-Identifier: MIT
// The history: every place of it can be restored, bit by bit, in bounded memory.
#include "core/recording/history.h"
#include "core/recording/player.h"
#include "inspector/core/scenes.h"
#include "support/compare.h"

#include <random>

using namespace inspector;
using support::sameBits;

class TestHistory : public QObject {
    Q_OBJECT

private slots:
    void init();
    void everyPlaceIsBitByBitWhatItWas();
    void memoryIsBounded();
    void runsBeginWhereTheBallWasPut();
    void placeIsFoundByItsTime();
    void savedRunIsTheSame();

private:
    void play(uint64_t steps);
    void restart();
    void setState(const phys_state &state);
    Past past(uint64_t from = 0, uint64_t to = UINT64_MAX);

    Registry m_registry;
    std::unique_ptr<Engine> m_engine;
    std::unique_ptr<History> m_history;
    std::vector<phys_state> m_states; // after each step, from the first
};

void TestHistory::init() {
    m_registry = makeRegistry(nullptr);
    m_engine = engineOn(levelScene(1));
    m_history = std::make_unique<History>();
    m_history->setOrigin(originOf(m_registry, PHYS_STEPPER_DEFAULT, QStringLiteral(LEVELS_FOLDER "/01.txt")));
    m_states.clear();
}

// Tilts anew every 20 steps.
void TestHistory::play(uint64_t steps) {
    for (uint64_t i = 0; i < steps; ++i) {
        const size_t tilts = m_states.size() / 20;
        const double angle = 0.3 * double(tilts);
        if (m_states.size() % 20 == 0) m_engine->setInputs(tilted(6.0 * std::sin(angle), 6.0 * std::cos(angle)));
        QString error;
        if (!m_engine->step(&error)) qFatal("%s", qPrintable(error));
        m_history->note(*m_engine);
        m_states.push_back(m_engine->state());
    }
}

void TestHistory::restart() {
    m_engine->restart();
    m_history->beginRun();
}

void TestHistory::setState(const phys_state &state) {
    m_engine->setState(state);
    m_history->beginRun();
}

Past TestHistory::past(uint64_t from, uint64_t to) {
    QString error;
    std::optional<Past> past = m_history->past(from, to, &error);
    if (!past) qFatal("%s", qPrintable(error));
    return *past;
}

// With a restart, another step size and a state set back in between.
void TestHistory::everyPlaceIsBitByBitWhatItWas() {
    play(700);
    restart();
    play(300);
    m_engine->setDt(0.001);
    play(2000);
    setState(m_states[500]);
    play(100);
    const Past kept = past();
    QCOMPARE(kept.begin, uint64_t(0));
    QCOMPARE(kept.end(), uint64_t(m_states.size() + 2)); // and two more places where runs begin
    Player player(kept.recording, kept.keyframes);
    constexpr unsigned kSeed = 17;
    std::mt19937 random(kSeed);
    for (int i = 0; i < 300; ++i) {
        const uint64_t place = 1 + random() % m_states.size();
        const uint64_t steps = player.seek(place);
        QVERIFY(steps <= History::kBlockSteps);
        QVERIFY2(sameBits(player.engine().state(), m_states[place - 1]), qPrintable(QString::number(place)));
    }
}

void TestHistory::memoryIsBounded() {
    constexpr uint64_t kMost = 2000;
    m_history = std::make_unique<History>(kMost);
    m_history->setOrigin(originOf(m_registry, PHYS_STEPPER_DEFAULT, QStringLiteral(LEVELS_FOLDER "/01.txt")));
    play(10000);
    QCOMPARE(m_history->end(), uint64_t(10000));
    const uint64_t kept = m_history->end() - m_history->begin();
    QVERIFY(kept >= kMost && kept < kMost + History::kBlockSteps);
    const Past past = this->past();
    Player player(past.recording, past.keyframes);
    player.seek(1);
    QVERIFY(sameBits(player.engine().state(), m_states[past.begin]));
}

void TestHistory::runsBeginWhereTheBallWasPut() {
    play(100);
    restart();
    play(50);
    setState(m_states[30]);
    play(70);
    const Past kept = past();
    QCOMPARE(kept.recording->runs(), (std::vector<uint64_t>{0, 100, 150}));
    QCOMPARE(kept.beginOfRun(100), uint64_t(0));
    QCOMPARE(kept.endOfRun(100), uint64_t(100));
    QCOMPARE(kept.beginOfRun(101), uint64_t(101));
    QCOMPARE(kept.endOfRun(101), uint64_t(151));
    QCOMPARE(kept.beginOfRun(152), uint64_t(152));
    QCOMPARE(kept.endOfRun(200), uint64_t(222));
    QCOMPARE(kept.positionOf(100), uint64_t(100));
    QCOMPARE(kept.positionOf(101), uint64_t(100));
    QCOMPARE(kept.positionOf(222), uint64_t(220));
}

void TestHistory::placeIsFoundByItsTime() {
    play(300);
    restart();
    m_engine->setDt(0.002);
    play(300);
    const Past kept = past();
    QCOMPARE(kept.placeAt(1.0, 10), uint64_t(100));   // of the first run, at 10 ms
    QCOMPARE(kept.placeAt(1.001, 10), uint64_t(101)); // at or after
    QCOMPARE(kept.placeAt(0.1, 400), uint64_t(351));  // of the second, at 2 ms
    QCOMPARE(kept.placeAt(99.0, 10), uint64_t(300));
    QCOMPARE(kept.placeAt(0.0, 10), uint64_t(0));
    QCOMPARE(kept.placeAt(0.0, 400), uint64_t(301)); // 300 is the end of the first
}

// Saves a part that begins in the middle.
void TestHistory::savedRunIsTheSame() {
    play(300);
    restart();
    play(400);
    const QByteArray text = recordingText(past(301, 701).recording->recording(), m_registry);
    QString error;
    std::optional<Recording> read = parseRecording(text, m_registry, &error);
    QVERIFY2(read, qPrintable(error));
    const auto playable = PlayableRecording::make(*std::move(read), m_registry, levelsIn(LEVELS_FOLDER), &error);
    QVERIFY2(playable, qPrintable(error));
    QCOMPARE(playable->length(), uint64_t(400));
    const ReplayOutcome outcome = replay(playable, [](const Engine &) { return true; });
    QCOMPARE(outcome.steps, uint64_t(400));
    QVERIFY(!outcome.difference);
}

QTEST_GUILESS_MAIN(TestHistory)
#include "tst_history.moc"
