// SPDX-License-Identifier: MIT
// The fit on the command line: what it says, its files and its status. The example track was made on level 3.
#include "inspector/program/headless_run.h"
#include "support/files.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace inspector;
using support::contentOf;

class TestFitCommand : public QObject {
    Q_OBJECT

private slots:
    void rightMazeIsFoundOnNearlyTheWholeTrack();
    void pointIsExplainedOnce();
    void wrongMazeExplainsNothing_data();
    void wrongMazeExplainsNothing();
    void wrongUnitsAreAskedFor();
    void restingBallDeterminesNothing();
    void fitAsksForItsMaze();
    void optionsTellWhatHasNoOption();
    void quantitiesWithoutEffectSaySo();
    void fileBesideTheTableTellsWhatMadeIt();

private:
    QString tableOf(double scale, const QByteArray &rows = {});
    QTemporaryDir m_folder;
};

namespace {

const QString kTrack = QStringLiteral(EXAMPLE_TRACK);

QString lineOf(const Result &result, const char *begin) {
    for (const QByteArray &line : result.out.split('\n'))
        if (line.trimmed().startsWith(begin)) return QString::fromUtf8(line.trimmed());
    return {};
}

} // namespace

void TestFitCommand::rightMazeIsFoundOnNearlyTheWholeTrack() {
    const Result result = runOf({"--fit", kTrack, "--level", "3"});
    QCOMPARE(result.status, 0);
    QVERIFY2(result.out.startsWith("level 03\n"), result.out.constData());
    const QString verdict = lineOf(result, "verdict:");
    QVERIFY2(verdict.startsWith("verdict: the rolling model suffices: "), qPrintable(verdict));
    QVERIFY2(verdict.contains(" of 241 points, ") && verdict.endsWith(" of 4 s"), qPrintable(verdict));
}

// Also where the track is explained in parts: the wall is missed, and each part begins behind it.
void TestFitCommand::pointIsExplainedOnce() {
    const Result result = runOf({"--fit", kTrack, "--level", "3", "--restitution-wall", "0"});
    const QRegularExpression points(QStringLiteral("(\\d+) of 241 points"));
    const QRegularExpressionMatch found = points.match(lineOf(result, "verdict:"));
    QVERIFY2(found.hasMatch(), result.out.constData());
    QVERIFY2(found.captured(1).toInt() <= 241, result.out.constData());
}

void TestFitCommand::wrongMazeExplainsNothing_data() {
    QTest::addColumn<QString>("level");
    QTest::addColumn<QString>("why");
    QTest::newRow("most points beside the board") << "1"
                                                  << "148 of 241 points lie beside the board";
    QTest::newRow("on the board, a tenth explained") << "5"
                                                     << " of 241 points, ";
    QTest::newRow("nowhere") << "6"
                             << "0 of 241 points, 0 of 4 s";
}

void TestFitCommand::wrongMazeExplainsNothing() {
    QFETCH(QString, level);
    QFETCH(QString, why);
    const Result result = runOf({"--fit", kTrack, "--level", level});
    QCOMPARE(result.status, 1);
    const QString verdict = lineOf(result, "verdict:");
    QVERIFY2(verdict.startsWith("verdict: neither model explains the track on this maze: "), qPrintable(verdict));
    QVERIFY2(verdict.contains(why), qPrintable(verdict));
    QVERIFY2(!result.out.contains("±"), result.out.constData());
    QCOMPARE(lineOf(result, "options:"), QString("options: none"));
    QVERIFY2(!result.out.contains("1 times"), result.out.constData());
}

QString TestFitCommand::tableOf(double scale, const QByteArray &rows) {
    QByteArray text = rows;
    for (const QByteArray &line : rows.isEmpty() ? contentOf(kTrack).split('\n') : QByteArrayList()) {
        QByteArrayList cells = line.split(',');
        if (cells.size() > 2 && !line.startsWith('t'))
            for (const int i : {1, 2}) cells[i] = QByteArray::number(cells[i].toDouble() * scale);
        text += cells.join(',') + '\n';
    }
    QString path = m_folder.filePath("table.csv");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("can't be written");
    file.write(text);
    return path;
}

// Millimetres for metres: nothing is compared, so that there is no figure of it.
void TestFitCommand::wrongUnitsAreAskedFor() {
    const Result result = runOf({"--fit", tableOf(1000.0), "--level", "3"});
    QCOMPARE(result.status, 1);
    QCOMPARE(lineOf(result, "verdict:"), QString("verdict: neither model explains the track on this maze: 241 of 241 "
                                                 "points lie beside the board: are units, frame and level right?"));
    QVERIFY2(!result.out.contains(" 0 mm"), result.out.constData());
    QVERIFY2(lineOf(result, "bounces:").endsWith("residuals - within 0.25 s after a bounce, - elsewhere"),
             result.out.constData());
}

void TestFitCommand::restingBallDeterminesNothing() {
    QByteArray rows = "t,x,y,tilt_x,tilt_y\n";
    for (int i = 0; i < 120; ++i) {
        const QByteArray place = QByteArray::number(-0.072 + 1e-4 * std::sin(i * i)); // of the start, with noise
        rows += QByteArray::number(i / 60.0) + "," + place + "," + place + ",0,0\n";
    }
    const Result result = runOf({"--fit", tableOf(1.0, rows), "--level", "3", "--fit-for", "restitution_wall"});
    QVERIFY2(lineOf(result, "verdict:").startsWith("verdict: none: the track determines nothing that is looked for"),
             result.out.constData());
    QCOMPARE(result.status, 1);
}

void TestFitCommand::fitAsksForItsMaze() {
    const Result result = runOf({"--fit", kTrack});
    QCOMPARE(result.status, 2);
    QCOMPARE(result.messages, QString("physics-inspector: --fit: needs the track's maze: --level L or a file\n"));
}

// The offset and the delay of the tilt, which a run doesn't have.
void TestFitCommand::optionsTellWhatHasNoOption() {
    const QString options = lineOf(runOf({"--fit", kTrack, "--level", "3"}), "options:");
    QVERIFY2(options.startsWith("options: --model rolling --rolling-friction 0.00"), qPrintable(options));
    QVERIFY2(options.contains("  # and tilt_x 0.3") && options.contains(", tilt_y -0.2") &&
                 options.contains(", delay ") && options.endsWith(" ms"),
             qPrintable(options));
}

void TestFitCommand::quantitiesWithoutEffectSaySo() {
    const Result result = runOf({"--fit", kTrack, "--level", "3"});
    for (const char *id : {"sliding_friction", "wall_friction"})
        QVERIFY2(lineOf(result, id).endsWith("not determined: no effect in the rolling model"), result.out.constData());
}

void TestFitCommand::fileBesideTheTableTellsWhatMadeIt() {
    const QString path = m_folder.filePath("residuals.csv");
    const Result result = runOf({"--fit", kTrack, "--level", "3", "--gravity", "9.8", "--csv", path});
    QCOMPARE(result.status, 0);
    const QByteArray settings = contentOf(path + ".txt");
    QVERIFY2(settings.startsWith("physics-inspector "), settings.constData());
    for (const char *line : {"\nlevel 03\n", "example_track.csv\n", "\ntrack-frame 0,0,0,1\n",
                             "\nfit-for rolling_friction,restitution_wall,", "\ngravity 9.8 m/s^2\n", "\nverdict: "})
        QVERIFY2(settings.contains(line), settings.constData());
}

QTEST_GUILESS_MAIN(TestFitCommand)
#include "tst_fit_command.moc"
