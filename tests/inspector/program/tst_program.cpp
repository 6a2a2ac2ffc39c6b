// SPDX-License-Identifier: MIT
// The program from the outside: output, messages, exit status; no display.
#include "inspector/core/scenes.h"
#include "inspector/program/process_run.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace inspector;

class TestProgram : public QObject {
    Q_OBJECT

private slots:
    void helpNeedsNoDisplay();
    void tableGoesToStandardOutputAndMessagesDont();
    void allLevelsAreWon();
    void wrongUseGivesStatus2AndOneLine();
    void tooFewOpenFilesGiveStatus2AndOneLine();
    void windowWithoutADisplayGivesStatus2AndOneLine();
    void displayThatCantBeOpenedGivesStatus2AndOneLine_data();
    void displayThatCantBeOpenedGivesStatus2AndOneLine();
    void aScaleThatNoScreenHasGivesStatus2AndOneLine_data();
    void aScaleThatNoScreenHasGivesStatus2AndOneLine();
    void platformWithoutOpenGLGetsAFlatPicture();
    void picturesOfOneCommandAreTheSame();
    void askedFor3dWithoutOpenGLGivesStatus2AndOneLine();
    void whatAFullStandardOutputLosesIsTold_data();
    void whatAFullStandardOutputLosesIsTold();
    void pipeThatNobodyReadsEndsTheRunWithoutAMessage();
    void whatAFileLimitLosesIsTold_data();
    void whatAFileLimitLosesIsTold();
    void mazeOfAnInputStays_data();
    void mazeOfAnInputStays();
    void windowWithoutStepsWritesNoTable();
    void settingsThatCantBeWrittenAreTold();
    void settingsThatArentKeptAreToldOnce();
    void settingsThatWouldBeWaitedForAreTold_data();
    void settingsThatWouldBeWaitedForAreTold();
    void settingsThatNameAHugeObjectEndNothing();
    void aClosedPipeEndsTheRunQuietlyAndItsRecordingWhole();
    void aClosedStandardOutputIsNoOtherFile();
    void aSignalLeavesTableAndRecordingWhole_data();
    void aSignalLeavesTableAndRecordingWhole();
    void filesOfAnyNameAreOpened();
    void aSecondProgramRecordingIntoOneFileIsTold();
    void pluginFoldersAreScannedAndWhatIsRefusedIsTold();
};

namespace {

QProcessEnvironment noDisplay() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "PHYS_PLUGIN_PATH"})
        environment.remove(name);
    return environment;
}

Ended runProgram(const QStringList &arguments, const QProcessEnvironment &environment = noDisplay()) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(INSPECTOR, arguments);
    return endOf(process);
}

// The messages of a window without a screen, whose settings are in a folder; without Qt's own warnings.
QProcessEnvironment noScreen(const QString &settingsFolder) {
    QProcessEnvironment environment = noDisplay();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    environment.insert("QT_LOGGING_RULES", "default.warning=false");
    environment.insert("XDG_CONFIG_HOME", settingsFolder);
    return environment;
}

// Run by a shell, for redirections and names of any bytes: $0 is the program, $1 a folder.
Ended runByShell(const QByteArray &script, const QString &folder = {}) {
    QProcess process;
    process.setProcessEnvironment(noDisplay());
    process.start("/bin/sh", {"-c", QString::fromLatin1(script), INSPECTOR, folder});
    return endOf(process);
}

} // namespace

void TestProgram::helpNeedsNoDisplay() {
    const Ended result = runProgram({"--help"});
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.contains("--tilt-x <deg>"));
    QVERIFY(result.messages.isEmpty());
}

void TestProgram::tableGoesToStandardOutputAndMessagesDont() {
    const Ended result = runProgram({"--headless", "--duration", "0.03"});
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.startsWith("time [s],step,"));
    QVERIFY(result.out.contains("\n0.03, 3,"));
    QVERIFY(result.messages.startsWith("level 01 "));
}

void TestProgram::allLevelsAreWon() {
    const Ended result = runProgram({"--headless", "--autopilot", "--all-levels"});
    QCOMPARE(result.status, 0);
    QCOMPARE(result.out.count(" won in "), levelCount());
}

void TestProgram::wrongUseGivesStatus2AndOneLine() {
    const Ended result = runProgram({"--headless", "--dt", "never"});
    QCOMPARE(result.status, 2);
    QVERIFY(result.out.isEmpty());
    QCOMPARE(
        result.messages,
        QByteArray(
            "physics-inspector: --dt: expected a duration from 1e-06 s to 10 s (as 5 ms or 1/60), found 'never'\n"));
}

void TestProgram::tooFewOpenFilesGiveStatus2AndOneLine() {
    const Ended result = runByShell("ulimit -n 5; exec \"$0\" --headless --duration 0.01");
    QCOMPARE(result.status, 2);
    QCOMPARE(result.messages,
             QByteArray("physics-inspector: only 5 files can be open (ulimit -n); expected at least 24\n"));
}

void TestProgram::windowWithoutADisplayGivesStatus2AndOneLine() {
    const Ended result = runProgram({"--level", "2"});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.startsWith("physics-inspector: no display"), result.messages.constData());
    QCOMPARE(result.messages.count('\n'), 1);
    const Ended replay = runProgram({"--replay", "some.rec"});
    QCOMPARE(replay.status, 2);
    QVERIFY2(replay.messages.startsWith("physics-inspector: no display"), replay.messages.constData());
}

void TestProgram::displayThatCantBeOpenedGivesStatus2AndOneLine_data() {
    QTest::addColumn<QString>("variable");
    QTest::addColumn<QString>("value");
    QTest::newRow("no such screen") << "DISPLAY"
                                    << ":59999";
    QTest::newRow("no such platform") << "QT_QPA_PLATFORM"
                                      << "none";
    QTest::newRow("no Wayland either") << "WAYLAND_DISPLAY"
                                       << "nowhere";
}

void TestProgram::displayThatCantBeOpenedGivesStatus2AndOneLine() {
    QFETCH(QString, variable);
    QFETCH(QString, value);
    QProcessEnvironment environment = noDisplay();
    environment.insert(variable, value);
    const Ended result = runProgram({}, environment);
    QCOMPARE(result.status, 2);
    QVERIFY2(isOneLine(result.messages) && result.messages.contains("--headless"), result.messages.constData());
}

void TestProgram::aScaleThatNoScreenHasGivesStatus2AndOneLine_data() {
    QTest::addColumn<QString>("variable");
    QTest::addColumn<QString>("value");
    QTest::newRow("scale") << "QT_SCALE_FACTOR"
                           << "1000";
    QTest::newRow("dots") << "QT_FONT_DPI"
                          << "100000";
    QTest::newRow("nothing to see") << "QT_SCALE_FACTOR"
                                    << "1e-9";
}

void TestProgram::aScaleThatNoScreenHasGivesStatus2AndOneLine() {
    QFETCH(QString, variable);
    QFETCH(QString, value);
    const QTemporaryDir folder;
    QProcessEnvironment environment = noScreen(folder.path());
    environment.insert(variable, value);
    const Ended result = runProgram({"--duration", "0.01", "--grab", folder.filePath("p.png")}, environment);
    QCOMPARE(result.status, 2);
    QVERIFY2(isOneLine(result.messages) && result.messages.contains("the screen's scale is "),
             result.messages.constData());
}

void TestProgram::platformWithoutOpenGLGetsAFlatPicture() {
    const QTemporaryDir folder;
    QProcessEnvironment environment = noDisplay();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    const QString picture = folder.filePath("p.png");
    const Ended result = runProgram({"--level", "2", "--grab", picture}, environment);
    QVERIFY2(result.status == 0, result.messages.constData());
    QVERIFY(QFile::exists(picture));
}

void TestProgram::picturesOfOneCommandAreTheSame() {
    const QTemporaryDir folder;
    QByteArrayList pictures;
    for (const char *name : {"1.png", "2.png"}) {
        const Ended result = runProgram(
            {"--level", "2", "--autopilot", "--compare", "rk4", "--duration", "0.7", "--grab", folder.filePath(name)},
            noScreen(folder.path()));
        QVERIFY2(result.status == 0, result.messages.constData());
        QFile picture(folder.filePath(name));
        QVERIFY(picture.open(QIODevice::ReadOnly));
        pictures += picture.readAll();
    }
    QVERIFY(pictures[0] == pictures[1]);
}

void TestProgram::askedFor3dWithoutOpenGLGivesStatus2AndOneLine() {
    QProcessEnvironment environment = noDisplay();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    const Ended result = runProgram({"--view", "3d"}, environment);
    QCOMPARE(result.status, 2);
    QVERIFY2(isOneLine(result.messages) && result.messages.contains("--view 2d"), result.messages.constData());
}

void TestProgram::whatAFullStandardOutputLosesIsTold_data() {
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("help") << QByteArray("--help");
    QTest::newRow("version") << QByteArray("--version");
    QTest::newRow("list") << QByteArray("--list-steppers");
    QTest::newRow("short table") << QByteArray("--headless --duration 0.01");
    QTest::newRow("long table") << QByteArray("--headless --duration 10");
    QTest::newRow("levels") << QByteArray("--all-levels --dt 1/60");
    QTest::newRow("verdict") << QByteArray("--replay \"$1/r\" --check");
    QTest::newRow("table of a replay") << QByteArray("--replay \"$1/r\" --headless");
}

void TestProgram::whatAFullStandardOutputLosesIsTold() {
    if (!QFile::exists("/dev/full")) QSKIP("this system has no /dev/full");
    QFETCH(QByteArray, words);
    const QTemporaryDir folder;
    QCOMPARE(runProgram({"--headless", "--duration", "0.1", "--record", folder.filePath("r")}).status, 0);
    const Ended result = runByShell("exec \"$0\" " + words + " >/dev/full", folder.path());
    QCOMPARE(result.status, 1);
    QVERIFY2(result.messages.contains("physics-inspector: 'standard output': No space left on device\n"),
             result.messages.constData());
}

void TestProgram::pipeThatNobodyReadsEndsTheRunWithoutAMessage() {
    const Ended result = runByShell("\"$0\" --headless --duration 1000 | head -1", {});
    QCOMPARE(result.messages, QByteArray());
}

void TestProgram::whatAFileLimitLosesIsTold_data() {
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("standard output") << QByteArray("--headless --duration 1 >\"$1/t\"");
    QTest::newRow("help") << QByteArray("--help >\"$1/t\"");
    QTest::newRow("table") << QByteArray("--headless --duration 1 --csv \"$1/t\"");
    QTest::newRow("table of a replay") << QByteArray("--replay \"$1/r\" --headless --csv \"$1/t\"");
    QTest::newRow("recording") << QByteArray("--headless --duration 1 --record \"$1/t\" >/dev/null");
    QTest::newRow("curves") << QByteArray("--trade 1 --steps 10ms --duration 0.1 --plot \"$1/t.svg\" >/dev/null");
    QTest::newRow("curves as a picture") << QByteArray(
        "--trade 1 --steps 10ms --duration 0.1 --plot \"$1/t.png\" >/dev/null");
    QTest::newRow("picture") << QByteArray("--level 2 --grab \"$1/t.png\"");
    QTest::newRow("recording of a window") << QByteArray("--duration 1 --autopilot --record \"$1/t\"");
    QTest::newRow("table of a window") << QByteArray("--duration 1 --autopilot --csv \"$1/t\"");
}

void TestProgram::whatAFileLimitLosesIsTold() {
    QFETCH(QByteArray, words);
    const QTemporaryDir folder;
    QCOMPARE(runProgram({"--headless", "--duration", "0.3", "--record", folder.filePath("r")}).status, 0);
    const Ended result = runByShell(
        "ulimit -f 1; export QT_QPA_PLATFORM=offscreen XDG_CONFIG_HOME=\"$1\"; exec \"$0\" " + words, folder.path());
    QCOMPARE(result.status, 1);
    QCOMPARE(result.messages.count("File too large\n"), 1);
    QVERIFY2(!result.messages.contains("libpng"), result.messages.constData());
}

void TestProgram::mazeOfAnInputStays_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("replay") << QStringList{"--headless", "--replay"};
    QTest::newRow("schedule") << QStringList{"--trade", "1", "--steps", "10ms", "--schedule"};
}

// Without its maze a recording can't be played any more.
void TestProgram::mazeOfAnInputStays() {
    QFETCH(QStringList, words);
    const QTemporaryDir folder;
    const QString maze = folder.filePath("m.txt");
    QVERIFY(QFile::copy(LEVELS_FOLDER "/01.txt", maze));
    const QString recording = folder.filePath("r");
    QCOMPARE(
        runProgram({"--headless", "--level", maze, "--tilt-x", "3", "--duration", "0.3", "--record", recording}).status,
        0);
    const Ended result = runProgram(words + QStringList{recording, "--csv", maze, "--force"});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.contains("is read by this run"), result.messages.constData());
}

void TestProgram::windowWithoutStepsWritesNoTable() {
    const QTemporaryDir folder;
    QFile table(folder.filePath("t.csv"));
    QVERIFY(table.open(QIODevice::WriteOnly) && table.write("time [s],step,\n") > 0);
    table.close();
    QProcess process;
    process.setProcessEnvironment(noScreen(folder.path()));
    process.start(INSPECTOR, {"--grab", folder.filePath("p.png"), "--csv", table.fileName()});
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().endsWith("t.csv': no samples\n"));
    QCOMPARE(table.size(), qint64(15));
    QVERIFY(!QFile::exists(table.fileName() + ".txt"));
}

void TestProgram::settingsThatCantBeWrittenAreTold() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("libphysics"));
    QFile settings(folder.filePath("libphysics/physics-inspector.conf"));
    QVERIFY(settings.open(QIODevice::WriteOnly) && settings.write("window/theme=\"1\"\n") > 0);
    settings.close();
    QProcess process;
    process.setProcessEnvironment(noScreen(folder.path()));
    process.start("/bin/sh", {"-c", "ulimit -f 1; exec \"$0\" --record \"$1/r\"", INSPECTOR, folder.path()});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(QFile::exists(folder.filePath("r")));
    process.terminate();
    const Ended result = endOf(process);
    QCOMPARE(result.status, 128 + SIGTERM);
    QVERIFY2(result.messages.contains("physics-inspector.conf': settings can't be read or written\n"),
             result.messages.constData());
    QVERIFY(settings.open(QIODevice::ReadOnly));
    QCOMPARE(settings.readAll(), QByteArray("window/theme=\"1\"\n"));
}

void TestProgram::settingsThatArentKeptAreToldOnce() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("libphysics/physics-inspector.conf"));
    QProcess process;
    process.setProcessEnvironment(noScreen(folder.path()));
    process.start(INSPECTOR, {"--record", folder.filePath("r")});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(QFile::exists(folder.filePath("r")));
    process.terminate();
    const Ended result = endOf(process);
    QCOMPARE(result.status, 128 + SIGTERM);
    QVERIFY2(isOneLine(result.messages), result.messages.constData());
}

void TestProgram::settingsThatWouldBeWaitedForAreTold_data() {
    QTest::addColumn<QByteArray>("command");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("pipe") << QByteArray("mkfifo") << QByteArray("it, or its lock, is no file\n");
    QTest::newRow("folder") << QByteArray("mkdir") << QByteArray("it, or its lock, is no file\n");
    QTest::newRow("pipe for a lock") << QByteArray("f=$f.lock; mkfifo") << QByteArray("it, or its lock, is no file\n");
    QTest::newRow("folder for a lock") << QByteArray("f=$f.lock; mkdir") << QByteArray("it, or its lock, is no file\n");
    QTest::newRow("lock of nobody") << QByteArray("f=$f.lock; >") << QByteArray("another program holds its lock\n");
}

void TestProgram::settingsThatWouldBeWaitedForAreTold() {
    QFETCH(QByteArray, command);
    QFETCH(QByteArray, reason);
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("libphysics"));
    runByShell("f=$1/libphysics/physics-inspector.conf; " + command + " \"$f\"", folder.path());
    const Ended result = runProgram({"--duration", "0"}, noScreen(folder.path()));
    QCOMPARE(result.status, 0);
    QVERIFY2(isOneLine(result.messages) && result.messages.endsWith(": settings aren't kept: " + reason),
             result.messages.constData());
}

void TestProgram::settingsThatNameAHugeObjectEndNothing() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("libphysics"));
    QFile settings(folder.filePath("libphysics/physics-inspector.conf"));
    QVERIFY(settings.open(QIODevice::WriteOnly));
    settings.write("[window]\ntheme=@Variant(\\0\\0\\0\\tix0x6`2)\n");
    settings.close();
    const Ended result = runProgram({"--duration", "0"}, noScreen(folder.path()));
    QCOMPARE(result.status, 0);
    QCOMPARE(result.messages, QByteArray());
}

void TestProgram::aClosedPipeEndsTheRunQuietlyAndItsRecordingWhole() {
    const QTemporaryDir folder;
    const Ended result = runByShell("\"$0\" --headless --duration 1e6 --record \"$1/r\" | head -n 1", folder.path());
    QCOMPARE(result.status, 0); // of head
    QCOMPARE(result.out, QByteArray(result.out).left(result.out.indexOf('\n') + 1));
    QVERIFY2(!result.messages.contains("standard output"), result.messages.constData());
    QVERIFY(runProgram({"--replay", folder.filePath("r"), "--check"}).out.startsWith("same: "));
}

void TestProgram::aClosedStandardOutputIsNoOtherFile() {
    const QTemporaryDir folder;
    const Ended result =
        runByShell("exec \"$0\" --headless --duration 0.1 --record \"$1/r\" >&- 2>\"$1/said\"", folder.path());
    QCOMPARE(result.status, 1);
    const Ended check = runProgram({"--replay", folder.filePath("r"), "--check"});
    QCOMPARE(check.status, 0);
}

void TestProgram::aSignalLeavesTableAndRecordingWhole_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGHUP") << SIGHUP;
}

void TestProgram::aSignalLeavesTableAndRecordingWhole() {
    QFETCH(int, signal);
    const QTemporaryDir folder;
    QProcess process;
    process.setProcessEnvironment(noDisplay());
    // The program leaves a signal ignored that is so, as in what a script starts in the background.
    process.setChildProcessModifier([signal] { std::signal(signal, SIG_DFL); });
    process.start(INSPECTOR, {"--headless", "--duration", "1e6", "--csv-every", "1000", "--csv", folder.filePath("t"),
                              "--record", folder.filePath("r")});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(QFileInfo(folder.filePath("r")).size() > 100000);
    ::kill(pid_t(process.processId()), signal);
    const Ended result = endOf(process);
    QCOMPARE(result.status, 128 + signal);
    QFile table(folder.filePath("t"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    const QByteArray text = table.readAll();
    QVERIFY(text.startsWith("time [s],step,") && text.endsWith('\n') && text.contains("\n10, 1000,"));
    QFile recording(folder.filePath("r"));
    QVERIFY(recording.open(QIODevice::ReadOnly));
    QVERIFY(recording.readAll().endsWith("\nend\n"));
}

void TestProgram::filesOfAnyNameAreOpened() {
    const QTemporaryDir folder;
    const QByteArray name = "\"$1/$(printf 'h\\366he \\033[31m\\nx.txt')\"";
    const QByteArray prepare = "cp '" LEVELS_FOLDER "/01.txt' " + name + " && ";
    const Ended run =
        runByShell(prepare + "\"$0\" --headless --duration 0.1 --level " + name + " --record \"$1/r\"", folder.path());
    QCOMPARE(run.status, 0);
    QCOMPARE(run.messages.count('\n'), 1);
    QVERIFY2(run.messages.contains("level h\\xf6he \\x1b[31m\\nx not won"), run.messages.constData());
    const Ended again = runByShell("\"$0\" --replay \"$1/r\" --check; rm " + name, folder.path());
    QVERIFY2(again.out.startsWith("same: 10 steps"), again.messages.constData());
}

void TestProgram::aSecondProgramRecordingIntoOneFileIsTold() {
    const QTemporaryDir folder;
    const QStringList words{"--headless", "--duration", "1e6",      "--csv-every",
                            "1000000",    "--force",    "--record", folder.filePath("r")};
    QProcess first;
    first.setProcessEnvironment(noDisplay());
    first.start(INSPECTOR, words);
    QVERIFY(first.waitForStarted());
    QTRY_VERIFY(QFileInfo(folder.filePath("r")).size() > 1000);
    const Ended second = runProgram(words);
    first.kill();
    first.waitForFinished();
    QCOMPARE(second.status, 2);
    QVERIFY2(isOneLine(second.messages) && second.messages.contains("another program is writing to it"),
             second.messages.constData());
}

void TestProgram::pluginFoldersAreScannedAndWhatIsRefusedIsTold() {
    const QTemporaryDir folder;
    QVERIFY(QFile::copy(ADAPTIVE_DRAG, folder.filePath("a.so")));
    QFile broken(folder.filePath("b.so"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("no plugin") > 0);
    broken.close();
    QProcessEnvironment environment = noDisplay();
    environment.insert("PHYS_PLUGIN_PATH", folder.path());
    const Ended result = runProgram({"--list-steppers"}, environment);
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.contains("\nadaptive-drag "));
    QVERIFY2(isOneLine(result.messages) && result.messages.contains("plugin left out: ") &&
                 result.messages.contains("b.so"),
             result.messages.constData());
    // A plugin that is both named and in the folder is no error.
    const Ended named = runProgram({"--list-steppers", "--plugin", folder.filePath("a.so")}, environment);
    QCOMPARE(named.messages.count("left out"), 1);
    // Nor is a folder that is named twice.
    environment.insert("PHYS_PLUGIN_PATH", folder.path() + ':' + folder.path() + "/.");
    const Ended twice = runProgram({"--list-steppers"}, environment);
    QVERIFY2(!twice.messages.contains("a.so"), twice.messages.constData());
}

QTEST_GUILESS_MAIN(TestProgram)
#include "tst_program.moc"
