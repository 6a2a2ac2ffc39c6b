// SPDX-License-Identifier: MIT
// Runs without a window: their table, when they end, and their exit status.
#include "core/program/csv_writer.h"
#include "inspector/core/scenes.h"
#include "inspector/program/headless_run.h"
#include "support/files.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <clocale>

using namespace inspector;

class TestHeadless : public QObject {
    Q_OBJECT

private slots:
    void headerNamesEveryColumnWithItsUnit();
    void firstLineIsTheHeaderAndNothingIsAComment();
    void fileBesideTheTableTellsHowToRepeatTheRun();
    void fileBesideTheAutopilotsTableNamesNoTilt();
    void fileOfAnotherKindBesideTheTableStays();
    void rowPerStepReadsBackExactly();
    void everySoManyStepsIsARow();
    void tableWithoutARowIsTold();
    void localeMakesNoDifference();
    void durationIsReachedInWholeSteps_data();
    void durationIsReachedInWholeSteps();
    void runWithoutStepsWritesNothing();
    void runWithoutDurationEndsOutOfTheMaze();
    void autopilotThatDoesntGetOutGivesStatus1();
    void startBesideTheBoardIsNoWin();
    void allLevelsAreWonAndEachHasALine();
    void levelThatCannotBePlayedIsALineAmongTheOthers();
    void missingLevelGivesOneLineAndStatus2();
    void unwritableTableGivesOneLineAndStatus2();
    void fullDiskGivesOneLineAndStatus1();
    void timeOfWinningIsSaidWhenTheRunGoesOn();
    void rowThatLacksAValueHasNoBlanks();
    void lostSamplesAreTold();
    void samplesOfAnEarlierRunAreNotMissed();
    void progressOfAFitIsALineAndIsErased();
    void columnsWithoutAnyValueAreLeftOut();
    void tableOfARingHasTheSameRowsAsThatOfTheRun();
};

namespace {

// Compares samples `from` to `to` of a run at 10 ms.
void append(SampleRing &samples, int from, int to) {
    Sample sample;
    for (int i = from; i <= to; ++i) {
        sample.time = 0.01 * i;
        samples.append(sample);
    }
}

Result headless(const QString &words) { return inspector::runOf(("--headless " + words).split(' ')); }

} // namespace

void TestHeadless::headerNamesEveryColumnWithItsUnit() {
    QCOMPARE(csvHeader(), QByteArray("time [s],step,position_x [m],position_y [m],position_z [m],velocity_x [m/s],"
                                     "velocity_y [m/s],velocity_z [m/s],speed [m/s],spin_x [rad/s],spin_y [rad/s],"
                                     "spin_z [rad/s],energy [J/kg],tilt_x [deg],tilt_y [deg],substeps,penetration [m],"
                                     "flags\n"));
}

void TestHeadless::progressOfAFitIsALineAndIsErased() {
    const QTemporaryDir folder;
    QFile table(folder.filePath("t.csv"));
    QVERIFY(table.open(QIODevice::WriteOnly));
    table.write("t,x,y\n");
    for (int i = 0; i < 100; ++i)
        table.write(QByteArray::number(i * 100) + ",0.00" + QByteArray::number(i % 7) + ",0\n");
    table.close();
    const Result result = inspector::runOf({"--fit", table.fileName(), "--level", "1"});
    QCOMPARE(result.status, 1); // no ball can move like that
    const QStringList lines = result.progress.split("\r\x1b[K");
    QVERIFY(lines.size() > 2);
    QCOMPARE(lines.first(), QString());
    QCOMPARE(lines.last(), QString());
    for (const QString &line : lines) QVERIFY2(line.size() < 80 && !line.contains('\n'), qPrintable(line));
}

void TestHeadless::firstLineIsTheHeaderAndNothingIsAComment() {
    const QByteArrayList lines = headless("--level 2 --duration 0.05").out.trimmed().split('\n');
    QVERIFY2(lines.first().startsWith("time [s],step,position_x [m],"), lines.first().constData());
    for (const QByteArray &line : lines) QCOMPARE(line.count(','), lines.first().count(','));
}

void TestHeadless::fileBesideTheTableTellsHowToRepeatTheRun() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("t.csv");
    headless("--level 2 --dt 0.005 --duration 0.01 --tilt-x 2.5 --stepper rk4 --csv " + path);
    const QByteArray settings = support::contentOf(path + ".txt");
    phys_stepper_info info;
    phys_registry_find(nullptr, "rk4", &info, nullptr);
    const QByteArray expected = "physics-inspector 1.1.0, libphysics " + QByteArray(phys_version()) +
                                "\nlevel 02\nstepper rk4 " + info.version + "\ndt 0.005 s\nautopilot off\n" +
                                "tilt_x 2.5 deg\ntilt_y 0 deg\ngravity 9.81 m/s^2\n";
    QVERIFY2(settings.startsWith(expected), settings.constData());
    const Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i)
        QVERIFY2(settings.contains('\n' + QByteArray(parameters.row(i).id) + ' '), parameters.row(i).id);
}

void TestHeadless::fileBesideTheAutopilotsTableNamesNoTilt() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("t.csv");
    headless("--autopilot --duration 0.01 --csv " + path);
    const QByteArray settings = support::contentOf(path + ".txt");
    QVERIFY2(settings.contains("\nautopilot on\ngravity ") && !settings.contains("\ntilt_"), settings.constData());
    QVERIFY2(settings.endsWith("\ntilt varies: columns tilt_x, tilt_y\n"), settings.constData());
}

void TestHeadless::fileOfAnotherKindBesideTheTableStays() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("t.csv");
    QFile other(path + ".txt");
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write("mine");
    other.close();
    const Result run = headless("--duration 0.01 --csv " + path);
    QVERIFY(run.status != 0);
    QCOMPARE(support::contentOf(path + ".txt"), QByteArray("mine"));
}

void TestHeadless::rowPerStepReadsBackExactly() {
    const QByteArrayList rows = headless("--duration 0.5 --tilt-x 3 --tilt-y 1").rows();
    QCOMPARE(rows.size(), 50);
    const auto engine = engineOn(levelScene(1));
    engine->setInputs(tilted(3.0, 1.0));
    for (const QByteArray &row : rows) {
        QVERIFY(engine->step(nullptr));
        const Sample sample = engine->sample();
        const QByteArrayList fields = row.split(',');
        QCOMPARE(size_t(fields.size()), 2 + kBallChannelCount);
        QVERIFY(fields[0].toDouble() == sample.time); // the same bits, no tolerance
        QCOMPARE(fields[1].toULongLong(), sample.step);
        for (size_t i = 0; i < kBallChannelCount; ++i) QVERIFY(fields[qsizetype(2 + i)].toDouble() == sample.values[i]);
    }
}

void TestHeadless::everySoManyStepsIsARow() {
    const QByteArrayList rows = headless("--duration 1 --csv-every 30").rows();
    QCOMPARE(rows.size(), 3);
    QVERIFY(rows[0].startsWith("0.3") && rows[2].contains(", 90,"));
}

void TestHeadless::tableWithoutARowIsTold() {
    const auto isTold = [](const QString &every) {
        return headless("--duration 1 --csv-every " + every)
            .messages.contains("\nphysics-inspector: --csv-every: the table has no row, as the run ends at step 100\n");
    };
    QVERIFY(isTold("101"));
    QVERIFY(!isTold("100"));
}

void TestHeadless::localeMakesNoDifference() {
    const QByteArray before = headless("--duration 0.2 --tilt-x 3").out;
    const QLocale locale;
    QLocale::setDefault(QLocale(QLocale::German));
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // no effect where it isn't installed; Qt's is always there
    const QByteArray after = headless("--duration 0.2 --tilt-x 3").out;
    std::setlocale(LC_ALL, "C");
    QLocale::setDefault(locale);
    QCOMPARE(after, before);
}

void TestHeadless::durationIsReachedInWholeSteps_data() {
    QTest::addColumn<double>("duration");
    QTest::addColumn<double>("dt");
    QTest::addColumn<int>("steps");
    QTest::newRow("0.3 is no whole number of 0.1 in binary") << 0.3 << 0.1 << 3;
    QTest::newRow("one step too long") << 0.01 << 1.0 << 1;
    QTest::newRow("rounded up") << 0.25 << 0.1 << 3;
    QTest::newRow("a small part of a step") << 1e-9 << 0.01 << 1;
    QTest::newRow("many steps") << 0.07 << 1e-5 << 7000;
}

void TestHeadless::durationIsReachedInWholeSteps() {
    QFETCH(double, duration);
    QFETCH(double, dt);
    QFETCH(int, steps);
    const Result result = headless(QString("--duration %1 --dt %2").arg(duration).arg(dt));
    QCOMPARE(result.status, 0);
    QCOMPARE(result.rows().size(), steps);
}

void TestHeadless::runWithoutStepsWritesNothing() {
    const QTemporaryDir folder;
    const QString table = folder.filePath("t.csv");
    const QString recording = folder.filePath("r.rec");
    for (const QString &outputs : {QString(), " --csv " + table, " --record " + recording}) {
        const Result result = headless("--duration 0" + outputs);
        QCOMPARE(result.status, 1);
        QCOMPARE(result.out, QByteArray());
        QCOMPARE(result.messages, QString("physics-inspector: no step in 0 s: nothing to write\n"));
    }
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TestHeadless::runWithoutDurationEndsOutOfTheMaze() {
    const Result result = headless("--autopilot");
    QCOMPARE(result.status, 0);
    const QByteArrayList rows = result.rows();
    QVERIFY(rows.last().split(',').last().toInt() & PHYS_OUT);
    QVERIFY(!(rows[rows.size() - 2].split(',').last().toInt() & PHYS_OUT));
    QVERIFY2(result.messages.startsWith("level 01 won in "), qPrintable(result.messages));
}

// A ball that friction holds at any tilt of the pilot: tan(8 degrees) = 0.14.
void TestHeadless::autopilotThatDoesntGetOutGivesStatus1() {
    const Result result = headless("--autopilot --rolling-friction 0.2 --csv-every 1000000");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.messages.startsWith("level 01 not won after 600.00 s"), qPrintable(result.messages));
}

void TestHeadless::startBesideTheBoardIsNoWin() {
    const QTemporaryDir folder;
    QFile maze(folder.filePath("beside.txt"));
    QVERIFY(maze.open(QIODevice::WriteOnly));
    maze.write("physics-maze 1\nunits m\nball 0.006\nstart -0.5 0 0.006\nbox -0.09 -0.09 -0.005 0.09 0.09 0\n");
    maze.close();
    const Result result = inspector::runOf({"--headless", maze.fileName()});
    QVERIFY2(result.messages.startsWith("level beside not won after 0.01 s"), qPrintable(result.messages));
    QVERIFY2(result.messages.contains("the ball starts beside the board\n"), qPrintable(result.messages));
}

void TestHeadless::allLevelsAreWonAndEachHasALine() {
    const Result result = headless("--all-levels");
    QCOMPARE(result.status, 0);
    const QByteArrayList lines = result.out.trimmed().split('\n');
    QCOMPARE(lines.size(), levelCount());
    for (int i = 0; i < levelCount(); ++i)
        QVERIFY2(lines[i].startsWith("level " + QByteArray::number(i + 1).rightJustified(2, '0') + " won in "),
                 lines[i].constData());
    QVERIFY(result.messages.isEmpty());
}

void TestHeadless::levelThatCannotBePlayedIsALineAmongTheOthers() {
    const QTemporaryDir folder;
    QVERIFY(QFile::copy(LEVELS_FOLDER "/01.txt", folder.filePath("1.txt")));
    QVERIFY(QFile::copy(LEVELS_FOLDER "/01.txt", folder.filePath("3.txt")));
    QFile broken(folder.filePath("2.txt"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("physics-maze 1\nbox 1 2\n") > 0);
    broken.close();
    const QByteArray before = qgetenv("PHYSICS_LEVELS");
    qputenv("PHYSICS_LEVELS", folder.path().toUtf8());
    const Result result = headless("--all-levels");
    qputenv("PHYSICS_LEVELS", before);
    QCOMPARE(result.status, 1);
    const QByteArrayList lines = result.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    QVERIFY2(lines[0].startsWith("level 1 won in "), lines[0].constData());
    QVERIFY2(lines[1].startsWith("level 2 failed: ") && lines[1].contains("2.txt"), lines[1].constData());
    QVERIFY2(lines[2].startsWith("level 3 won in "), lines[2].constData());
}

void TestHeadless::missingLevelGivesOneLineAndStatus2() {
    const Result result = headless("--level nowhere/none.txt");
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.contains("nowhere/none.txt"), qPrintable(result.messages));
    QCOMPARE(result.messages.count('\n'), 1);
    QVERIFY(result.out.isEmpty());
}

void TestHeadless::unwritableTableGivesOneLineAndStatus2() {
    const Result result = headless("--csv /nowhere/table.csv");
    QCOMPARE(result.status, 2);
    QVERIFY2(result.messages.contains("/nowhere/table.csv"), qPrintable(result.messages));
}

void TestHeadless::fullDiskGivesOneLineAndStatus1() {
    if (!QFile::exists("/dev/full")) QSKIP("this system has no /dev/full");
    for (const char *duration : {"10", "0.01"}) { // the latter fits into a buffer
        const Result result = headless(QString("--csv /dev/full --duration ") + duration);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.messages.contains("--csv: '/dev/full': No space left"), qPrintable(result.messages));
    }
}

void TestHeadless::timeOfWinningIsSaidWhenTheRunGoesOn() {
    const QString won = headless("--autopilot").messages.section(" s (simulated)", 0, 0);
    const Result longer = headless("--autopilot --duration 100 --csv-every 1000000");
    QCOMPARE(longer.messages.section(" s (simulated)", 0, 0), won);
    QVERIFY2(longer.messages.contains(" 10000 steps"), qPrintable(longer.messages));
}

// gnuplot separates by blanks; it then skips a row that has none.
void TestHeadless::rowThatLacksAValueHasNoBlanks() {
    Sample sample{0.5, 50, {}};
    QVERIFY(csvRow(sample).startsWith("0.5, 50, 0, 0, "));
    sample[Channel::PositionY] = std::nan("");
    QVERIFY(csvRow(sample).startsWith("0.5,50,0,,0,"));
}

// A ring of 256 samples and a run of 300 steps.
void TestHeadless::lostSamplesAreTold() {
    SampleRing samples(256);
    append(samples, 1, 200);
    QCOMPARE(spanOf(samples), QString("samples from 0.01 s to 2 s"));
    append(samples, 201, 300);
    QVERIFY2(spanOf(samples).endsWith(" s to 3 s; earlier ones aren't kept"), qPrintable(spanOf(samples)));
}

void TestHeadless::samplesOfAnEarlierRunAreNotMissed() {
    SampleRing samples(256);
    for (int run = 0; run < 3; ++run) {
        samples.clear();
        append(samples, 1, 200);
        QCOMPARE(spanOf(samples), QString("samples from 0.01 s to 2 s"));
    }
    append(samples, 201, 300);
    QVERIFY2(spanOf(samples).endsWith(" s to 3 s; earlier ones aren't kept"), qPrintable(spanOf(samples)));
}

void TestHeadless::columnsWithoutAnyValueAreLeftOut() {
    SampleRing samples(256);
    Sample sample;
    sample.values.fill(std::nan(""));
    sample[Channel::Speed] = 0.25;
    sample.time = 0.01;
    samples.append(sample);
    sample[Channel::WallGap] = 0.5;
    sample.time = 0.02;
    samples.append(sample);
    QBuffer table;
    table.open(QIODevice::WriteOnly);
    writeSamples(table, samples, 0.0, Columns::All);
    QCOMPARE(table.data(), QByteArray("time [s],step,speed [m/s],wall_gap [m]\n0.01,0,0.25,\n0.02, 0, 0.25, 0.5\n"));
}

void TestHeadless::tableOfARingHasTheSameRowsAsThatOfTheRun() {
    const QTemporaryDir folder;
    const CommandLine line = parseCommandLine({"physics-inspector", "--headless", "--duration", "0.4"});
    const auto engine = makeEngine(line.options, line.options.level, nullptr);
    SampleRing samples(256);
    play(*engine, {0.4, false}, [&](const Engine &now) {
        samples.append(now.sample());
        return true;
    });
    QString error;
    QVERIFY2(writeTable(folder.filePath("t.csv"), samples, tableShape(line.options), {}, &error), qPrintable(error));
    QFile file(folder.filePath("t.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), headless("--duration 0.4").out);
}

QTEST_GUILESS_MAIN(TestHeadless)
#include "tst_headless.moc"
