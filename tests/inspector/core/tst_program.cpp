// SPDX-License-Identifier: MIT
// The program itself, from the outside: output, messages, exit status; no display.
#include <QProcess>
#include <QTest>

class TestProgram : public QObject {
    Q_OBJECT

private slots:
    void helpNeedsNoDisplay();
    void tableGoesToStandardOutputAndMessagesDont();
    void allLevelsAreWon();
    void wrongUseGivesStatus2AndOneLine();
    void windowWithoutADisplayGivesStatus2AndOneLine();
};

namespace {

struct Result {
    int status;
    QByteArray out, messages;
};

Result runOf(const QStringList &arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    environment.remove("WAYLAND_DISPLAY");
    environment.remove("QT_QPA_PLATFORM");
    process.setProcessEnvironment(environment);
    process.start(INSPECTOR, arguments);
    const bool hasEnded = process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit;
    return {hasEnded ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

void TestProgram::helpNeedsNoDisplay() {
    const Result result = runOf({"--help"});
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.contains("--tilt-x <deg>"));
    QVERIFY(result.messages.isEmpty());
}

void TestProgram::tableGoesToStandardOutputAndMessagesDont() {
    const Result result = runOf({"--headless", "--duration", "0.03"});
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.startsWith("# physics-inspector 1.1.0"));
    QVERIFY(result.out.contains("\n0.03,3,"));
    QVERIFY(result.messages.startsWith("level 01 "));
}

void TestProgram::allLevelsAreWon() {
    const Result result = runOf({"--headless", "--autopilot", "--all-levels"});
    QCOMPARE(result.status, 0);
    QCOMPARE(result.out.count(" won in "), 10);
}

void TestProgram::wrongUseGivesStatus2AndOneLine() {
    const Result result = runOf({"--headless", "--dt", "never"});
    QCOMPARE(result.status, 2);
    QVERIFY(result.out.isEmpty());
    QCOMPARE(
        result.messages,
        QByteArray(
            "physics-inspector: --dt: expected a duration from 1e-06 s to 10 s (as 5 ms or 1/60), found 'never'\n"));
}

void TestProgram::windowWithoutADisplayGivesStatus2AndOneLine() {
    const Result result = runOf({"--level", "2"});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.startsWith("physics-inspector: no display"), result.messages.constData());
    QCOMPARE(result.messages.count('\n'), 1);
    const Result replay = runOf({"--replay", "some.rec"});
    QCOMPARE(replay.status, 2);
    QVERIFY2(replay.messages.startsWith("physics-inspector: no display"), replay.messages.constData());
}

QTEST_GUILESS_MAIN(TestProgram)
#include "tst_program.moc"
