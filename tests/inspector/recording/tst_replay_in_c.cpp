// SPDX-License-Identifier: MIT
// Recordings are portable: the C example, which uses only the library, reports the same as the inspector.
#include "support/files.h"
#include "support/stepper_rows.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using support::contentOf;

class TestReplayInC : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void sameIsSame_data();
    void sameIsSame();
    void severalRunsInOneFileAreSame();
    void stepThatFailedFailsAgain();
    void cutOffRecordingIsSameAsFarAsItGoes();
    void differenceIsAtTheSameStep();
    void anotherMazeIsRefused();
    void bothReadTheSameFormat_data();
    void bothReadTheSameFormat();
    void whatIsNoRecordingIsRefused_data();
    void whatIsNoRecordingIsRefused();

private:
    struct Result {
        int status;
        QByteArray out, messages;
    };
    static Result runOf(const QString &program, const QStringList &words);
    Result inspector(const QStringList &words) const { return runOf(INSPECTOR, words); }
    // With levels 1 to 3 to choose from.
    Result inC(const QString &file) const;
    QString recorded(const QStringList &words);
    QString written(const QByteArray &bytes);
    void compareVerdicts(const QString &file, int status);

    QTemporaryDir m_folder;
    int m_files = 0;
};

namespace {

const QStringList kLevels{LEVELS_FOLDER "/01.txt", LEVELS_FOLDER "/02.txt", LEVELS_FOLDER "/03.txt"};

} // namespace

TestReplayInC::Result TestReplayInC::runOf(const QString &program, const QStringList &words) {
    QProcess process;
    process.start(program, words);
    const bool hasEnded = process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit;
    return {hasEnded ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

TestReplayInC::Result TestReplayInC::inC(const QString &file) const {
    return runOf(REPLAY, QStringList{file} + kLevels);
}

QString TestReplayInC::recorded(const QStringList &words) {
    QString file = m_folder.filePath(QString::number(++m_files));
    const Result result = inspector(QStringList{"--headless", "--csv", file + ".csv", "--record", file} + words);
    [&] { QVERIFY2(result.status == 0 || result.status == 1, result.messages.constData()); }();
    return file;
}

QString TestReplayInC::written(const QByteArray &bytes) {
    QString path = m_folder.filePath(QString::number(++m_files));
    QFile file(path);
    [&] { QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size()); }();
    return path;
}

void TestReplayInC::compareVerdicts(const QString &file, int status) {
    const Result expected = inspector({"--replay", file, "--check"});
    const Result found = inC(file);
    QCOMPARE(found.out, expected.out);
    QCOMPARE(found.messages, QByteArray());
    QCOMPARE(found.status, expected.status);
    QCOMPARE(found.status, status);
}

void TestReplayInC::initTestCase() { QVERIFY(m_folder.isValid()); }

void TestReplayInC::sameIsSame_data() {
    QTest::addColumn<QStringList>("words");
    for (const QByteArray &stepper : support::stepperIds())
        for (const char *model : {"rolling", "rigid"})
            QTest::addRow("%s, %s", stepper.constData(), model) << QStringList{
                "--level", "3", "--autopilot", "--duration", "3", "--stepper", stepper, "--model", model};
    QTest::newRow("other parameters") << QStringList{"--level",    "1", "--tilt-x",           "7",  "--dt", "1/60",
                                                     "--duration", "2", "--restitution-wall", "0.9"};
}

void TestReplayInC::sameIsSame() {
    QFETCH(QStringList, words);
    compareVerdicts(recorded(words), 0);
}

void TestReplayInC::severalRunsInOneFileAreSame() {
    QByteArray first = contentOf(recorded({"--level", "1", "--tilt-x", "3", "--duration", "0.5"}));
    first.chop(4); // end
    const QByteArray second =
        contentOf(recorded({"--level", "2", "--stepper", "rk4", "--dt", "5ms", "--duration", "0.5"}));
    compareVerdicts(written(first + second.mid(second.indexOf("level "))), 0);
}

void TestReplayInC::stepThatFailedFailsAgain() {
    const QString file =
        recorded({"--level", "1", "--tilt-x", "80", "--gravity", "1000", "--dt", "10", "--duration", "1000"});
    QVERIFY(contentOf(file).contains("\nfailed "));
    compareVerdicts(file, 0);
}

void TestReplayInC::cutOffRecordingIsSameAsFarAsItGoes() {
    QByteArray text = contentOf(recorded({"--level", "1", "--tilt-x", "3", "--duration", "0.5"}));
    text.chop(11); // end, and a half of the last hash
    compareVerdicts(written(text), 0);
}

void TestReplayInC::differenceIsAtTheSameStep() {
    QByteArray text = contentOf(recorded({"--level", "1", "--tilt-x", "3", "--duration", "0.5"}));
    char &digit = text[text.size() - 6 - qsizetype{17} * 20]; // the last of a hash
    digit = digit == '0' ? '1' : '0';
    compareVerdicts(written(text), 1);
}

void TestReplayInC::anotherMazeIsRefused() {
    const QString file = recorded({"--level", "4", "--duration", "0.1"});
    const Result result = inC(file);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.endsWith(": none of the levels given has the hash in this line\n"),
             result.messages.constData());
}

/// Edits of one recording: libphysics/docs/recording_format.md, rule by rule.
void TestReplayInC::bothReadTheSameFormat_data() {
    QTest::addColumn<QByteArray>("begin"); // of the line that is replaced; empty: the whole text
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<int>("status");
    const auto line = [](const char *name, const char *begin, const QByteArray &to, int status) {
        QTest::newRow(name) << QByteArray(begin) << to << status;
    };
    line("nothing", "", "", 2);
    line("a word", "", "hello", 2);
    line("half a first line", "", "physics-rec", 2);
    line("the first line alone, cut off", "", "physics-recording 1", 0);
    line("a comment first", "physics-", "# physics\nphysics-recording 1", 2);
    line("comments and empty lines", "board", "# long " + QByteArray(100000, 'a') + "\n\n@", 0);
    line("NUL as a line", "board", QByteArray("\0", 1) + "\n@", 2);
    line("NUL in a comment", "board", "#" + QByteArray("\0", 1) + "\n@", 2);
    line("carriage returns", "board", "@\r\r", 0);
    line("two blanks", "dt", "dt  0.01", 2);
    line("no level", "level", "#", 2);
    line("no stepper", "stepper", "#", 2);
    line("no dt", "dt", "#", 2);
    line("no options", "options", "#", 2);
    line("no board", "board", "#", 2);
    line("no state", "state", "#", 2);
    line("no program", "program", "#", 0);
    line("an initial parameter not set", "set restitution_wall", "#", 0);
    for (const char *dt : {"0.01 s", "+0.01", "0x1p-3", "1e400", "1e-400", "1e300", "0", "-1", "0,01", "nan", ""})
        line(qPrintable(QString("dt ") + dt), "dt", QByteArray("dt ") + dt, 2);
    line("another way to write dt", "dt", "dt 10.00e-3", 0);
    for (const char *options : {"4", "4294967297", "1.0", "+1", "-1", "0x1"})
        line(qPrintable(QString("options ") + options), "options", QByteArray("options ") + options, 2);
    line("a state of 17 numbers", "state", "@ 0", 2);
    line("half a step", "state", "state 0 0.5 -0.08 0.08 0.006 0 0 0 0 0 0 0 0 0 1 1", 2);
    line("a state without numbers", "state", "state 0 0 nan 0.08 0.006 0 0 0 0 0 0 0 0 0 1 1", 2);
    line("unknown flags", "state", "state 0 0 -0.08 0.08 0.006 0 0 0 0 0 0 0 0 0 1 16", 2);
    line("no unit quaternion", "state", "state 0 0 -0.08 0.08 0.006 0 0 0 0 0 0 0 0 0 5 1", 2);
    line("a board without numbers", "board", "board nan nan nan 0 0 -9.81", 2);
    line("an upright board", "board", "board 2 0 9.81 0 0 -9.81", 2);
    line("gravity out of range", "board", "board 0 0 9.81 0 0 -1e9", 2);
    line("gravity as a parameter", "board", "set gravity_x 3\n@", 2);
    line("a parameter before its stepper", "stepper", "set restitution_wall 0.5\n@", 2);
    line("a stepper without a version", "stepper", "stepper symplectic-euler", 2);
    line("a stepper with an empty version", "stepper", "stepper symplectic-euler ", 2);
    line("another version of the stepper", "stepper", "stepper symplectic-euler 0", 0);
    line("no hash of a level", "level", "level 0123 01.txt", 2);
    line("a second end", "end", "end\nend", 2);
    line("a comment after the end", "end", "end\n# that's all", 0);
    line("an end before the steps", "state", "@\nend", 2);
    line("a step that differs", "end", "0123456789abcdef\nend", 1);
    line("no hash of a step", "end", "0123456789abcdeg\nend", 2);
    line("a wrong line after a step that differs", "end", "0123456789abcdef\ndt 0\nend", 2);
}

void TestReplayInC::bothReadTheSameFormat() {
    QFETCH(QByteArray, begin);
    QFETCH(QByteArray, to);
    QFETCH(int, status);
    static const QByteArray good = contentOf(recorded({"--level", "1", "--tilt-x", "3", "--duration", "0.1"}));
    QByteArray text = to;
    if (!begin.isEmpty()) {
        const qsizetype place = good.startsWith(begin) ? 0 : good.indexOf('\n' + begin) + 1;
        QVERIFY(good.mid(place).startsWith(begin));
        const qsizetype length = good.indexOf('\n', place) - place;
        text = good;
        text.replace(place, length, QByteArray(to).replace("@", good.mid(place, length)));
    }
    const QString file = written(text);
    const Result one = inspector({"--replay", file, "--check"}), other = inC(file);
    QCOMPARE(one.status, status);
    QCOMPARE(other.status, status);
    QCOMPARE(other.messages.count('\n'), status == 2 ? 1 : 0);
}

void TestReplayInC::whatIsNoRecordingIsRefused_data() {
    QTest::addColumn<QByteArray>("text");
    const QByteArray head("physics-recording 1\n");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("another version") << QByteArray("physics-recording 2\n");
    QTest::newRow("a step of nothing") << head + "0123456789abcdef\n";
    QTest::newRow("an unknown word") << head + "jump 3\n";
    QTest::newRow("half a state") << head + "state 0 0 0\n";
    QTest::newRow("no number") << head + "dt soon\n";
    QTest::newRow("a long line") << head + "failed " + QByteArray(100000, 'a') + "\n";
}

void TestReplayInC::whatIsNoRecordingIsRefused() {
    QFETCH(QByteArray, text);
    const Result result = inC(written(text));
    QCOMPARE(result.status, 2);
    QCOMPARE(result.messages.count('\n'), 1);
}

QTEST_GUILESS_MAIN(TestReplayInC)
#include "tst_replay_in_c.moc"
