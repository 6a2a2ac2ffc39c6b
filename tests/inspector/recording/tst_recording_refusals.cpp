// SPDX-License-Identifier: MIT
// Recordings that can't be read, followed or written: one line each with the place, the expected and the found text.
#include "core/recording/recorder.h"
#include "core/simulation/simulation.h"
#include "inspector/core/scenes.h"
#include "inspector/program/headless_run.h"
#include "support/files.h"

#include <QTemporaryDir>

using namespace inspector;
using support::contentOf;
using support::write;

class TestRecordingRefusals : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void wrongTextIsRefusedWithItsLine_data();
    void wrongTextIsRefusedWithItsLine();
    void missingFileIsRefused();
    void missingMazeIsRefused();
    void changedMazeIsRefused();
    void wordsThatDontGoTogether_data();
    void wordsThatDontGoTogether();
    void folderThatIsntThereIsToldBeforeTheRun();
    void fullDiskLeavesTheRunAsItIs();
    void simulationGoesOnWithoutItsRecording();

private:
    QString path(const char *name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
    QByteArray m_good; // a recording of three steps
};

namespace {

// The text with the first line that begins with `begin` replaced; `to` is without its line break.
QByteArray changed(const QByteArray &text, const QByteArray &begin, const QByteArray &to) {
    QByteArrayList lines = text.split('\n');
    for (QByteArray &line : lines)
        if (line.startsWith(begin)) {
            line = to;
            return lines.join('\n');
        }
    qFatal("the recording has no line '%s'", begin.constData());
}

int lineOf(const QByteArray &text, const QByteArray &begin) {
    return int(text.left(text.indexOf('\n' + begin)).count('\n')) + 2;
}

} // namespace

void TestRecordingRefusals::initTestCase() {
    runOf({"--headless", "--tilt-x", "3", "--duration", "0.03", "--record", path("good")});
    m_good = contentOf(path("good"));
    QVERIFY(m_good.endsWith("\nend\n"));
}

void TestRecordingRefusals::wrongTextIsRefusedWithItsLine_data() {
    QTest::addColumn<QByteArray>("begin"); // of the line to change
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no recording") << QByteArray("physics-") << QByteArray("time [s],step")
                                  << "expected a recording: 'physics-recording VERSION', found 'time [s],step";
    QTest::newRow("other version") << QByteArray("physics-") << QByteArray("physics-recording 2")
                                   << "expected version 1 of the format, found '2'";
    QTest::newRow("no version") << QByteArray("physics-") << QByteArray("physics-recording")
                                << "expected version 1 of the format, found nothing";
    QTest::newRow("unknown word") << QByteArray("dt") << QByteArray("duration 3")
                                  << "expected the hash of a step or a word as 'set', found 'duration 3'";
    QTest::newRow("unknown stepper") << QByteArray("stepper") << QByteArray("stepper perpetual 1") << "perpetual";
    QTest::newRow("stepper without version")
        << QByteArray("stepper") << QByteArray("stepper rk4") << "expected 'stepper ID VERSION', found 'stepper rk4'";
    QTest::newRow("unknown parameter") << QByteArray("set restitution_wall") << QByteArray("set bounciness 0.5")
                                       << "expected a parameter of stepper symplectic-euler, found 'bounciness'";
    QTest::newRow("parameter out of range")
        << QByteArray("set restitution_wall") << QByteArray("set restitution_wall 1.5") << "restitution_wall";
    QTest::newRow("parameter without value") << QByteArray("set restitution_wall") << QByteArray("set restitution_wall")
                                             << "expected 'set PARAMETER VALUE', found 'set restitution_wall'";
    QTest::newRow("parameter with two blanks")
        << QByteArray("set restitution_wall") << QByteArray("set restitution_wall  1")
        << "expected 'set PARAMETER VALUE', found 'set restitution_wall  1'";
    QTest::newRow("not a number") << QByteArray("set restitution_wall") << QByteArray("set restitution_wall 0,5")
                                  << "expected a finite number, found '0,5'";
    QTest::newRow("not finite") << QByteArray("set restitution_wall") << QByteArray("set restitution_wall nan")
                                << "expected a finite number, found 'nan'";
    QTest::newRow("parameter before its stepper") << QByteArray("stepper") << QByteArray("set restitution_wall 0.5")
                                                  << "expected 'stepper' before its parameters";
    QTest::newRow("dt out of range") << QByteArray("dt") << QByteArray("dt 0")
                                     << "expected dt from 1e-06 to 10 s, found '0'";
    QTest::newRow("options out of range")
        << QByteArray("options") << QByteArray("options 4") << "expected options from 0 to 3, found '4'";
    QTest::newRow("short board") << QByteArray("board") << QByteArray("board 0 0 9.81")
                                 << "expected 'board' and 6 numbers, found 'board 0 0 9.81'";
    QTest::newRow("upright board") << QByteArray("board") << QByteArray("board 1.6 0 9.81 0 0 -9.81")
                                   << "expected two tilts within pi/2 and a strength >= 0";
    QTest::newRow("gravity out of range")
        << QByteArray("board") << QByteArray("board 0 0 9.81 0 0 -1e9") << "gravity_z";
    QTest::newRow("level without file") << QByteArray("level") << QByteArray("level 0123456789abcdef")
                                        << "expected 'level HASH FILE', found 'level 0123456789abcdef'";
    QTest::newRow("level without hash") << QByteArray("level") << QByteArray("level maze 01.txt")
                                        << "expected a hash of 16 hexadecimal digits, found 'maze'";
    QTest::newRow("short state") << QByteArray("state") << QByteArray("state 0 0 0 0 0.006")
                                 << "expected 'state' and 16 numbers, found 'state 0 0 0 0 0.006'";
    QTest::newRow("step that is no whole number")
        << QByteArray("state") << QByteArray("state 0 0.5 0 0 0 0 0 0 0 0 0 0 0 0 1 0")
        << "expected a whole number, found '0.5'";
    QTest::newRow("state that no ball can have")
        << QByteArray("state") // no unit quaternion
        << QByteArray("state 0 0 0 0 0 0 0 0 0 0 0 0 0 0 2 0") << "orientation";
    QTest::newRow("words after the end") << QByteArray("end") << QByteArray("end\ndt 1")
                                         << "expected nothing after 'end', found 'dt 1'";
    QTest::newRow("no state") << QByteArray("state") << QByteArray("#") << "expected 'state' before the first step";
    QTest::newRow("no level") << QByteArray("level") << QByteArray("#") << "expected 'level' before the first step";
    QTest::newRow("no dt") << QByteArray("dt") << QByteArray("#") << "expected 'dt' before the first step";
}

void TestRecordingRefusals::wrongTextIsRefusedWithItsLine() {
    QFETCH(QByteArray, begin);
    QFETCH(QByteArray, to);
    QFETCH(QString, reason);
    write(path("r"), changed(m_good, begin, to));
    const Result check = runOf({"--replay", path("r"), "--check"});
    QCOMPARE(check.status, 2);
    QVERIFY(check.out.isEmpty());
    QVERIFY2(check.messages.contains(reason), qPrintable(check.messages));
    QCOMPARE(check.messages.count('\n'), 1);
    if (reason.contains("before the first step") || reason == "gravity_z") return; // names that step
    const int line = begin == "physics-" ? 1 : lineOf(m_good, begin) + int(to.count('\n'));
    const QString where = QString("physics-inspector: --replay: %1:%2: ").arg(path("r")).arg(line);
    QVERIFY2(check.messages.startsWith(where), qPrintable(check.messages));
}

void TestRecordingRefusals::missingFileIsRefused() {
    const Result check = runOf({"--replay", "nowhere/r", "--check"});
    QCOMPARE(check.status, 2);
    QVERIFY2(check.messages.startsWith("physics-inspector: --replay: 'nowhere/r': "), qPrintable(check.messages));
}

void TestRecordingRefusals::missingMazeIsRefused() {
    const QByteArray to = "level 0123456789abcdef /nowhere/none.txt";
    write(path("r"), changed(m_good, "level", to));
    const Result check = runOf({"--replay", path("r"), "--check"});
    QCOMPARE(check.status, 2);
    QVERIFY2(check.messages.contains(":7: expected the maze file '/nowhere/none.txt'"), qPrintable(check.messages));
}

void TestRecordingRefusals::changedMazeIsRefused() {
    const QByteArray file = LEVELS_FOLDER "/01.txt";
    write(path("r"), changed(m_good, "level", "level 0123456789abcdef " + file));
    const Result check = runOf({"--replay", path("r"), "--check"});
    QCOMPARE(check.status, 2);
    QVERIFY2(check.messages.contains("expected a maze file with the hash 0123456789abcdef, found '" + file + "' with "),
             qPrintable(check.messages));
}

void TestRecordingRefusals::wordsThatDontGoTogether_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("line");
    QTest::newRow("a table of a window") << "--replay r --csv t"
                                         << "--replay: its table needs --headless; doesn't go with --csv";
    QTest::newRow("a ghost without a window") << "--replay r --check --compare exact"
                                              << "--compare: goes with --replay in the window only";
    QTest::newRow("a picture without a window") << "--replay r --check --grab p.png"
                                                << "doesn't go with --grab";
    QTest::newRow("check alone") << "--check"
                                 << "--check: needs --replay";
    QTest::newRow("a level") << "--replay r --check --level 2"
                             << "doesn't go with --level";
    QTest::newRow("a parameter") << "--replay r --check --tilt-x 2"
                                 << "doesn't go with --tilt-x";
    QTest::newRow("a trade") << "--replay r --check --trade 1"
                             << "doesn't go with --trade";
    QTest::newRow("recording a replay") << "--replay r --check --record s"
                                        << "--record: doesn't go with --replay";
    QTest::newRow("recording all levels") << "--all-levels --record s"
                                          << "--record: doesn't go with --all-levels";
}

void TestRecordingRefusals::wordsThatDontGoTogether() {
    QFETCH(QString, words);
    QFETCH(QString, line);
    const Result result = runOf(words.split(' '));
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.contains(line), qPrintable(result.messages));
    QCOMPARE(result.messages.count('\n'), 1);
}

void TestRecordingRefusals::folderThatIsntThereIsToldBeforeTheRun() {
    const Result result = runOf({"--headless", "--duration", "0.5", "--record", "/nowhere/r"});
    QCOMPARE(result.status, 2);
    QVERIFY(result.out.isEmpty());
    QCOMPARE(result.messages, QString("physics-inspector: --record: '/nowhere/r': No such file or directory\n"));
}

void TestRecordingRefusals::fullDiskLeavesTheRunAsItIs() {
    if (!QFile::exists("/dev/full")) QSKIP("this system has no /dev/full");
    const Result plain = runOf({"--headless", "--duration", "0.5"});
    const Result result = runOf({"--headless", "--duration", "0.5", "--record", "/dev/full"});
    QCOMPARE(result.status, 1);
    QCOMPARE(result.out, plain.out);
    QCOMPARE(result.messages.count("can't record into '/dev/full': No space left"), 1);
}

void TestRecordingRefusals::simulationGoesOnWithoutItsRecording() {
    const Scene scene = levelScene(1);
    Simulation simulation(scene, defaultStepper(scene));
    QStringList lines;
    connect(&simulation, &Simulation::recordingFailed, this, [&](const QString &line) { lines += line; });
    simulation.startRecording("/nowhere/r", {});
    simulation.run();
    QTRY_VERIFY(simulation.latest().current.step > 20);
    QVERIFY(simulation.latest().running);
    QTRY_COMPARE(lines.size(), 1);
    QVERIFY2(lines[0].startsWith("can't record into '/nowhere/r': No such file"), qPrintable(lines[0]));
}

QTEST_GUILESS_MAIN(TestRecordingRefusals)
#include "tst_recording_refusals.moc"
