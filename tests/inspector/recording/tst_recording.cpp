// SPDX-License-Identifier: MIT
// Recordings: they are read back bit by bit, replay the same, and report exactly the first step that differs.
#include "core/recording/recorder.h"
#include "core/recording/replay.h"
#include "core/schedule/recording_schedule.h"
#include "core/session/session.h"
#include "core/setup/settings_file.h"
#include "inspector/core/scenes.h"
#include "inspector/program/headless_run.h"
#include "inspector/recording/recorded_steps.h"
#include "inspector/stepping.h"
#include "support/compare.h"
#include "support/files.h"

#include <QTemporaryDir>

using namespace inspector;
using support::contentOf;
using support::sameBits;
using support::write;

class TestRecording : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void everyStepperReplaysTheSame_data();
    void everyStepperReplaysTheSame();
    void conditionsComeBackBitByBit();
    void startingStateComesBackBitByBit();
    void zeroAndMinusZeroAreTwoInputs();
    void autopilotsRunOfLevel1IsTheSame();
    void tableOfAReplayHasTheRowsOfTheRun();
    void tableOfAReplayIsDescribedByTheRecording();
    void tableOfAReplayIsDescribedWholly();
    void flippedBitOfAHashNamesItsStep_data();
    void flippedBitOfAHashNamesItsStep();
    void changedInputNamesTheStepItActsOn();
    void changesWhileRunningReplayTheSame();
    void sessionOfAPersonReplaysTheSame();
    void recordingOfAPartReplaysTheSame();
    void lastRunIsAScheduleOfTheTrade();
    void failedStepIsRecordedAndReplaysTheSame();
    void otherVersionsAreNamedWhereAStepDiffers();
    void cutRecordingReplaysUpToWhereItIsWhole();
    void recordingOfNoStepsIsTheSame();
    void localeAndLineEndingsMakeNoDifference();
    void mazeIsFoundBesideTheRecording();

private:
    QString path(const char *name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

Result checkOf(const QString &file) { return runOf({"--replay", file, "--check"}); }

QByteArrayList rowsOf(const QByteArray &table) {
    QByteArrayList lines = table.split('\n');
    lines.removeIf([](const QByteArray &line) { return line.startsWith('#'); });
    return lines;
}

bool isHash(const QByteArray &line) { return line.size() == 16 && !line.contains(' '); }

// The line of the recording's step `number`, from 1.
qsizetype lineOfStep(const QByteArrayList &lines, int number) {
    for (qsizetype i = 0; i < lines.size(); ++i)
        if (isHash(lines[i]) && --number == 0) return i;
    return -1;
}

std::unique_ptr<Engine> recordedEngine(Recorder &recorder, const QByteArray &stepper = PHYS_STEPPER_DEFAULT) {
    const Registry registry = makeRegistry(nullptr);
    const QString maze = LEVELS_FOLDER "/01.txt";
    const Scene scene = levelScene(1);
    recorder.setOrigin(originOf(registry, stepper, maze));
    return std::make_unique<Engine>(scene, makeStepper(registry, stepper, scene, nullptr));
}

} // namespace

void TestRecording::everyStepperReplaysTheSame_data() {
    QTest::addColumn<QString>("stepper");
    QTest::addColumn<QString>("model");
    for (uint32_t i = 0; i < phys_registry_count(nullptr); ++i) {
        phys_stepper_info info;
        QCOMPARE(phys_registry_info(nullptr, i, &info), PHYS_OK);
        for (const char *model : {"rolling", "rigid"})
            QTest::addRow("%s, %s", info.id, model) << QString(info.id) << QString(model);
    }
}

void TestRecording::everyStepperReplaysTheSame() {
    QFETCH(QString, stepper);
    QFETCH(QString, model);
    const Result run = runOf({"--headless", "--stepper", stepper, "--model", model, "--duration", "5", "--tilt-x", "3",
                              "--tilt-y", "-2", "--dt", "0.004", "--record", path("r")});
    QCOMPARE(run.status, 0);
    const Result check = checkOf(path("r"));
    QCOMPARE(check.out, QByteArray("same: 1250 steps\n"));
    QCOMPARE(check.status, 0);
}

void TestRecording::conditionsComeBackBitByBit() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    Inputs inputs = tilted(1.0 / 3.0, -0.1);
    inputs.params.restitution_wall = 0.1 + 0.2;
    inputs.params.rolling_friction = 5e-324;
    inputs.params.model = PHYS_MODEL_RIGID;
    inputs.params.sliding_friction = 1.0 / 7.0;
    inputs.params.stepper[0] = 1.0;
    engine->setInputs(inputs);
    engine->setDt(1.0 / 60.0);
    stepRecorded(*engine, recorder, 1);
    recorder.close();

    QString error;
    const auto recording = readRecording(path("r"), makeRegistry(nullptr), &error);
    QVERIFY2(recording, qPrintable(error));
    QCOMPARE(recording->segments.size(), size_t(1));
    const Conditions &read = recording->segments[0].conditions;
    QVERIFY(sameBits(read.inputs, inputs));
    QVERIFY(read.dt == 1.0 / 60.0); // not nearly
    QCOMPARE(read.maze.path, QString(LEVELS_FOLDER "/01.txt"));
    QCOMPARE(read.maze.hash, hashOf(contentOf(LEVELS_FOLDER "/01.txt")));
    QCOMPARE(read.stepper.id, QByteArray(PHYS_STEPPER_DEFAULT));
    QVERIFY(recording->isWhole);
}

void TestRecording::startingStateComesBackBitByBit() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    phys_state start = engine->state();
    start.time = 1.0 / 3.0;
    start.step = 0xffffffffffffu;
    start.velocity = {0.1, -1e-300, -0.0};
    start.spin = {2.0 / 3.0, 0.0, 1e5 / 7.0};
    engine->setState(start);
    stepRecorded(*engine, recorder, 1);
    recorder.close();
    const auto recording = readRecording(path("r"), makeRegistry(nullptr), nullptr);
    QVERIFY(recording && recording->segments.at(0).from);
    QVERIFY(sameBits(*recording->segments[0].from, start));
}

// The sign of a zero can reach the state's bits.
void TestRecording::zeroAndMinusZeroAreTwoInputs() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    Inputs inputs = tilted(0.0, 0.0);
    inputs.params.gravity.x = 0.0;
    engine->setInputs(inputs);
    stepRecorded(*engine, recorder, 1);
    inputs.params.gravity.x = -0.0;
    engine->setInputs(inputs);
    stepRecorded(*engine, recorder, 1);
    recorder.close();
    const auto recording = readRecording(path("r"), makeRegistry(nullptr), nullptr);
    QVERIFY(recording);
    QCOMPARE(recording->segments.size(), size_t(2));
    QVERIFY(std::signbit(recording->segments[1].conditions.inputs.params.gravity.x));
}

void TestRecording::autopilotsRunOfLevel1IsTheSame() {
    const Result run = runOf({"--headless", "--autopilot", "--record", path("r")});
    QVERIFY2(run.messages.startsWith("level 01 won in "), qPrintable(run.messages));
    const Result check = checkOf(path("r"));
    QCOMPARE(check.out, "same: " + QByteArray::number(rowsOf(run.out).size() - 2) + " steps\n");
    QCOMPARE(check.status, 0);
}

void TestRecording::tableOfAReplayHasTheRowsOfTheRun() {
    const Result run = runOf({"--headless", "--autopilot", "--duration", "3", "--record", path("r")});
    const Result again = runOf({"--headless", "--replay", path("r")});
    QCOMPARE(again.status, 0);
    QCOMPARE(rowsOf(again.out), rowsOf(run.out));
    QCOMPARE(again.messages, QString("same: 300 steps\n"));
}

void TestRecording::tableOfAReplayIsDescribedByTheRecording() {
    runOf({"--headless", "--stepper", "rk4", "--dt", "0.001", "--duration", "0.1", "--record", path("r")});
    const Result again = runOf({"--headless", "--replay", path("r"), "--csv", path("t.csv")});
    QCOMPARE(again.status, 0);
    const QByteArray settings = contentOf(path("t.csv.txt"));
    QVERIFY2(settings.contains("stepper rk4 "), settings.constData());
    QVERIFY2(settings.contains("dt 0.001 s"), settings.constData());
}

// From the first row to the last, over its runs.
void TestRecording::tableOfAReplayIsDescribedWholly() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    const auto makeSteps = [&](int count) {
        for (int i = 0; i < count && engine->step(nullptr); ++i) recorder.note(*engine);
    };
    makeSteps(2);
    engine->setDt(0.005);
    makeSteps(2);
    engine->restart();
    Inputs inputs = tilted(0.1, 0.0);
    inputs.params.restitution_wall = 0.25;
    engine->setInputs(inputs);
    makeSteps(2);
    recorder.close();
    QCOMPARE(runOf({"--headless", "--replay", path("r"), "--csv", path("t.csv")}).status, 0);
    const QByteArray settings = contentOf(path("t.csv.txt"));
    for (const char *line :
         {"\ndt 0.01 s\n", "\nmodel rolling\n", "\nrestitution_wall 0.5\n", "\nfrom 0.025 s: dt 0.005 s\n",
          "\nrun 2: rows from 0.005 s\nfrom 0.005 s: restitution_wall 0.25\n",
          "\ntilt varies: columns tilt_x, tilt_y\n"})
        QVERIFY2(settings.contains(line), settings.constData());
}

void TestRecording::flippedBitOfAHashNamesItsStep_data() {
    QTest::addColumn<int>("step");
    QTest::addColumn<QString>("time");
    QTest::newRow("first") << 1 << "0";
    QTest::newRow("one in the middle") << 57 << "0.56";
    QTest::newRow("last") << 200 << "1.99";
}

void TestRecording::flippedBitOfAHashNamesItsStep() {
    QFETCH(int, step);
    QFETCH(QString, time);
    runOf({"--headless", "--tilt-x", "3", "--duration", "2", "--record", path("r")});
    QByteArrayList lines = contentOf(path("r")).split('\n');
    QByteArray &line = lines[lineOfStep(lines, step)];
    const QByteArray right = line;
    line[15] = line[15] == '0' ? '1' : '0';
    write(path("r"), lines.join('\n'));
    const Result check = checkOf(path("r"));
    QCOMPARE(check.status, 1);
    QCOMPARE(check.out, QString("differs: step %1 of the recording, step %1 since the start, from %2 s on: "
                                "expected %3, found %4\n")
                            .arg(QString::number(step), time, QString(line), QString(right))
                            .toUtf8());
}

void TestRecording::changedInputNamesTheStepItActsOn() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    engine->setInputs(tilted(3.0, 0.0));
    stepRecorded(*engine, recorder, 40);
    Inputs inputs = tilted(3.0, 0.0);
    inputs.params.rolling_friction = 0.01;
    engine->setInputs(inputs);
    stepRecorded(*engine, recorder, 40);
    recorder.close();
    write(path("r"), contentOf(path("r")).replace("set rolling_friction 0.01\n", "set rolling_friction 0.011\n"));
    const Result check = checkOf(path("r"));
    QCOMPARE(check.status, 1);
    QVERIFY2(check.out.startsWith("differs: step 41 of the recording, step 41 since the start, "),
             check.out.constData());
}

// What a user does in the window: sliders, another stepper, another step size, a restart, an earlier state.
void TestRecording::changesWhileRunningReplayTheSame() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    const Registry registry = makeRegistry(nullptr);
    for (int i = 0; i < 50; ++i) {
        engine->setInputs(tilted(0.1 * i, 0.07 * i));
        stepRecorded(*engine, recorder, 1 + i % 3);
    }
    const phys_state kept = engine->state();
    engine->setStepper(makeStepper(registry, "exact", engine->scene(), nullptr));
    recorder.setOrigin(originOf(registry, "exact", LEVELS_FOLDER "/01.txt"));
    engine->setDt(1.0 / 60.0);
    stepRecorded(*engine, recorder, 50);
    engine->restart();
    stepRecorded(*engine, recorder, 20);
    engine->setState(kept);
    stepRecorded(*engine, recorder, 20);
    const Scene other = levelScene(3);
    engine->setScene(other, makeStepper(registry, "rk4", other, nullptr));
    recorder.setOrigin(originOf(registry, "rk4", LEVELS_FOLDER "/03.txt"));
    stepRecorded(*engine, recorder, 100);
    recorder.close();
    QCOMPARE(checkOf(path("r")).out, QByteArray("same: 289 steps\n"));
    const auto recording = readRecording(path("r"), registry, nullptr);
    QVERIFY(recording);
    QCOMPARE(std::count_if(recording->segments.begin(), recording->segments.end(),
                           [](const Segment &segment) { return segment.from.has_value(); }),
             4); // start, restart, the state from earlier, the other level
}

// Through the functions that the window uses, while the thread steps as fast as possible.
void TestRecording::sessionOfAPersonReplaysTheSame() {
    Options options;
    options.registry = makeRegistry(nullptr);
    options.levels = levelsIn(LEVELS_FOLDER);
    options.level = options.levels[0];
    options.speed = Simulation::kFastest;
    options.record = path("r");
    QSettings settings(path("settings.ini"), settingsFormat());
    QString error;
    auto session = Session::open(options, settings, &error);
    QVERIFY2(session, qPrintable(error));
    const auto playFor = [&](uint64_t steps) { // more steps
        const uint64_t begin = session->simulation().samples().last();
        QTRY_VERIFY(session->simulation().samples().last() >= begin + steps);
    };
    QVERIFY(session->isRecording());
    session->simulation().stepOnce();
    QTRY_COMPARE(session->simulation().latest().current.step, uint64_t(1));
    session->game().confirm(); // restarts
    QTRY_VERIFY(session->simulation().latest().running);
    for (int i = 1; i <= 10; ++i) {
        QVERIFY(session->parameters().set({{"tilt_x", 0.3 * i}, {"restitution_wall", 0.05 * i}}));
        playFor(5);
    }
    QVERIFY(chooseStepper(*session, "exact"));
    playFor(5);
    QVERIFY(chooseDt(*session, 0.005));
    playFor(5);
    QVERIFY(session->setAutopilot(true));
    playFor(20);
    QVERIFY(session->openLevel(session->levels().listed()[1]));
    session->game().confirm();
    playFor(20);
    session.reset();

    const Result check = checkOf(path("r"));
    QVERIFY2(check.out.startsWith("same: ") && check.out.endsWith(" steps\n"), check.out + check.messages.toUtf8());
    const auto recording = readRecording(path("r"), options.registry, nullptr);
    QVERIFY(recording);
    size_t steps = 0;
    for (const Segment &segment : recording->segments) steps += segment.hashes.size();
    QVERIFY(steps >= 101);
    QCOMPARE(recording->segments.back().conditions.maze.path, options.levels[1].path);
    QCOMPARE(recording->segments.back().conditions.stepper.id, QByteArray("exact"));
}

// Begun and ended in the middle of a run, twice into the same file: the second recording counts.
void TestRecording::recordingOfAPartReplaysTheSame() {
    Options options;
    options.registry = makeRegistry(nullptr);
    options.levels = levelsIn(LEVELS_FOLDER);
    options.level = options.levels[0];
    options.speed = Simulation::kFastest;
    QSettings settings(path("settings.ini"), settingsFormat());
    const auto session = Session::open(options, settings, nullptr);
    QVERIFY(session && !session->isRecording());
    QVERIFY(session->parameters().set({{"tilt_x", 2.0}}));
    Simulation &simulation = session->simulation();
    const auto playFor = [&](uint64_t steps) { // more steps; a command from before acts on the last of them
        const uint64_t end = simulation.samples().last() + steps;
        QTRY_VERIFY(simulation.samples().last() >= end);
    };
    simulation.run();
    playFor(10);
    session->startRecording(path("r"));
    playFor(10);
    session->startRecording(path("r"));
    playFor(10);
    session->stopRecording();
    playFor(10);
    QVERIFY(contentOf(path("r")).endsWith("\nend\n"));
    const auto recording = readRecording(path("r"), options.registry, nullptr);
    QVERIFY(recording);
    QCOMPARE(recording->segments.size(), size_t(1));
    QVERIFY(recording->segments[0].from && recording->segments[0].from->step > 10);
    QVERIFY(checkOf(path("r")).out.startsWith("same: "));
}

void TestRecording::lastRunIsAScheduleOfTheTrade() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    engine->setInputs(tilted(7.0, 7.0));
    stepRecorded(*engine, recorder, 9);
    engine->restart();
    engine->setInputs(tilted(1.0, 0.0));
    stepRecorded(*engine, recorder, 7);
    Inputs inputs = tilted(1.0, 0.0);
    inputs.params.restitution_wall = 0.25; // the tilt doesn't switch
    engine->setInputs(inputs);
    stepRecorded(*engine, recorder, 3);
    engine->setInputs(tilted(2.0, -1.0));
    engine->setDt(0.02);
    stepRecorded(*engine, recorder, 5);
    recorder.close();

    QString error;
    const TiltSchedule schedule = recordedSchedule(path("r"), makeRegistry(nullptr), 20.0, &error);
    QVERIFY2(schedule.switches.size() == 2, qPrintable(error));
    QVERIFY(schedule.switches[0].time == 0.0);
    QVERIFY(schedule.switches[0].tilt == (Tilt{radians(1.0), 0.0}));
    QVERIFY(schedule.switches[1].time == 10 * 0.01);
    QVERIFY(schedule.switches[1].tilt == (Tilt{radians(2.0), radians(-1.0)}));
    QVERIFY(schedule.duration == 10 * 0.01 + 5 * 0.02);

    { const Recorder empty(path("empty")); }
    QVERIFY(recordedSchedule(path("empty"), makeRegistry(nullptr), 20.0, &error).switches.empty());
    QCOMPARE(error, path("empty") + ": expected steps, found none");
}

void TestRecording::failedStepIsRecordedAndReplaysTheSame() {
    Recorder recorder(path("r"));
    const auto engine = recordedEngine(recorder);
    stepRecorded(*engine, recorder, 3);
    phys_state fast = engine->state();
    fast.velocity.x = 1e9; // more substeps than allowed
    engine->setState(fast);
    QString error;
    QVERIFY(!engine->step(&error));
    recorder.noteFailure(*engine, error);
    engine->restart();
    stepRecorded(*engine, recorder, 4);
    recorder.close();
    QCOMPARE(checkOf(path("r")).out, QByteArray("same: 7 steps\n"));

    write(path("r"), contentOf(path("r")).replace("failed ", "failed not "));
    const QByteArray out = checkOf(path("r")).out;
    QVERIFY2(out.startsWith("differs: step 4 of the recording, step 4 since the start, "), out.constData());
    QVERIFY2(out.contains(error.toUtf8()), out.constData());
}

void TestRecording::otherVersionsAreNamedWhereAStepDiffers() {
    runOf({"--headless", "--tilt-x", "3", "--duration", "1", "--record", path("r")});
    QByteArray text = contentOf(path("r"));
    text.replace("library " + QByteArray(phys_version()), "library 0.9");
    text.replace("stepper symplectic-euler ", "stepper symplectic-euler 0.");
    write(path("r"), text);
    QCOMPARE(checkOf(path("r")).out, QByteArray("same: 100 steps\n"));
    write(path("r"), text.replace("set rolling_friction ", "set rolling_friction 1"));
    const QByteArray out = checkOf(path("r")).out;
    QVERIFY2(out.contains("; libphysics was 0.9, is 1.1.0; stepper symplectic-euler was version 0."), out.constData());
    QCOMPARE(out.count('\n'), 1);
}

// Truncated at each byte after the first line: never an error, never a step that differs.
void TestRecording::cutRecordingReplaysUpToWhereItIsWhole() {
    runOf({"--headless", "--tilt-x", "3", "--duration", "0.03", "--record", path("r")});
    const QByteArray text = contentOf(path("r"));
    const Registry registry = makeRegistry(nullptr);
    for (qsizetype size = text.indexOf('\n') + 1; size < text.size(); ++size) {
        QString error;
        auto recording = parseRecording(text.left(size), registry, &error);
        QVERIFY2(recording, qPrintable(error));
        QVERIFY(!recording->isWhole);
        const auto playable = PlayableRecording::make(*std::move(recording), registry, {}, &error);
        QVERIFY2(playable, qPrintable(error));
        uint64_t whole = 0;
        const QByteArrayList lines = text.left(size).split('\n');
        for (qsizetype i = 0; i + 1 < lines.size(); ++i) whole += isHash(lines[i]) ? 1 : 0;
        const ReplayOutcome outcome = replay(playable, [](const Engine &) { return true; });
        QVERIFY(!outcome.difference);
        QCOMPARE(outcome.steps, whole);
    }
    write(path("r"), text.left(text.size() - 12)); // "end" and half of the last hash
    QCOMPARE(checkOf(path("r")).out, QByteArray("same: 2 steps (the recording is cut off after them)\n"));
    QCOMPARE(checkOf(path("r")).status, 0);
}

void TestRecording::recordingOfNoStepsIsTheSame() {
    { const Recorder recorder(path("r")); }
    const Result check = checkOf(path("r"));
    QCOMPARE(check.out, QByteArray("same: 0 steps\n"));
    QCOMPARE(check.status, 0);
}

void TestRecording::localeAndLineEndingsMakeNoDifference() {
    const QLocale locale;
    QLocale::setDefault(QLocale(QLocale::German));
    runOf({"--headless", "--tilt-x", "3.5", "--duration", "0.2", "--record", path("r")});
    write(path("r"), contentOf(path("r")).replace("\n", "\r\n"));
    const QByteArray out = checkOf(path("r")).out;
    QLocale::setDefault(locale);
    QCOMPARE(out, QByteArray("same: 20 steps\n"));
}

void TestRecording::mazeIsFoundBesideTheRecording() {
    QVERIFY(QFile::copy(LEVELS_FOLDER "/05.txt", path("mine.txt")));
    runOf({"--headless", "--level", path("mine.txt"), "--duration", "0.1", "--record", path("r")});
    write(path("r"), contentOf(path("r")).replace(path("mine.txt").toUtf8(), "/elsewhere/mine.txt"));
    QCOMPARE(checkOf(path("r")).out, QByteArray("same: 10 steps\n"));
}

QTEST_GUILESS_MAIN(TestRecording)
#include "tst_recording.moc"
