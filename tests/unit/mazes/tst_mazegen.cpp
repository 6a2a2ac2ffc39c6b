// SPDX-License-Identifier: MIT
// The command line as a user sees it: the program's output, files and exit status.
#include "generator/levels.h"
#include "support/files.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using support::contentOf;

namespace {

struct Ending {
    int status = -1;
    QString output;
    QString errors;
};

Ending runMazegen(const QString &folder, const QStringList &arguments) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(MAZEGEN), arguments);
    if (!process.waitForFinished(30'000) || process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

QStringList filesIn(const QString &folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden, QDir::Name);
}

const QStringList kMaze = {"--seed", "7", "--cells", "5x4"};

} // namespace

class TestMazegen : public QObject {
    Q_OBJECT

private slots:
    void oneRunWritesFourFilesAndSaysSoInOneLine();
    void outNamesTheFilesAndTheMaterialFileInTheMesh();
    void filesAreReplacedAndNothingElseIsLeft();
    void theGeneratorLineMakesTheSameFilesAgain();
    void levelsAndBallAreWrittenTogether();
    void wrongOptionsGiveOneLineAndNoFile_data();
    void wrongOptionsGiveOneLineAndNoFile();
    void aFileThatCannotBeWrittenIsNamedAndNothingIsLeft();
    void aFileLimitIsToldAndNothingIsLeft();
    void messagesAreOneLineWhateverIsNamed();
    void helpListsEveryOption();
    void helpTellsWhatValuesMayBe();
    void shortNamesAreTaken();
    void valueMayFollowAnEqualsSign();
    void versionIsThatOfTheProject();
    void filesOfAnotherKindAreNotReplaced();
    void linksAreNotReplaced();
    void aFileOfAnotherProgramsThatIsBeingWrittenStays();
};

void TestMazegen::oneRunWritesFourFilesAndSaysSoInOneLine() {
    QTemporaryDir folder;
    const Ending outcome = runMazegen(folder.path(), kMaze);
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.errors, QString());
    QCOMPARE(filesIn(folder.path()), (QStringList{"maze.mtl", "maze.obj", "maze.scad", "maze.txt"}));
    const QRegularExpression line(
        R"(^mazegen: maze\.txt \.obj \.mtl \.scad: 5x4 cells, \d+ boxes, way out \d+ cells, \d+\.\d ms\n$)");
    QVERIFY2(line.match(outcome.output).hasMatch(), qPrintable(outcome.output));
}

void TestMazegen::outNamesTheFilesAndTheMaterialFileInTheMesh() {
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("toys"));
    QCOMPARE(runMazegen(folder.path(), kMaze + QStringList{"--out", "toys/first.one"}).status, 0);
    QCOMPARE(filesIn(folder.filePath("toys")),
             (QStringList{"first.one.mtl", "first.one.obj", "first.one.scad", "first.one.txt"}));
    QVERIFY(contentOf(folder.filePath("toys/first.one.obj")).contains("\nmtllib first.one.mtl\n"));
}

void TestMazegen::filesAreReplacedAndNothingElseIsLeft() {
    QTemporaryDir folder;
    QCOMPARE(runMazegen(folder.path(), {"--seed", "8", "--cells", "9x9"}).status, 0);
    const QByteArray before = contentOf(folder.filePath("maze.txt"));
    QCOMPARE(runMazegen(folder.path(), kMaze).status, 0);
    QVERIFY(contentOf(folder.filePath("maze.txt")) != before);
    QCOMPARE(filesIn(folder.path()), (QStringList{"maze.mtl", "maze.obj", "maze.scad", "maze.txt"}));
}

void TestMazegen::theGeneratorLineMakesTheSameFilesAgain() {
    QTemporaryDir folder;
    const QStringList options = {"--seed",
                                 "18446744073709551615",
                                 "--cells",
                                 "6x3",
                                 "--algorithm",
                                 "kruskal",
                                 "--loops",
                                 "0.125",
                                 "--ball-radius",
                                 "0.004001",
                                 "--pitch",
                                 ".02",
                                 "--wall-thickness",
                                 "0.003",
                                 "--wall-height",
                                 "0.0095",
                                 "--floor-thickness",
                                 "0.0025"};
    QCOMPARE(runMazegen(folder.path(), options + QStringList{"--out", "first"}).status, 0);
    const QString text = QString::fromUtf8(contentOf(folder.filePath("first.txt")));
    const QString start = QStringLiteral("generator mazegen 1 ");
    const QStringList lines = text.split('\n').filter(QRegularExpression("^" + start));
    QCOMPARE(lines.size(), 1);
    QCOMPARE(runMazegen(folder.path(), lines[0].mid(start.size()).split(' ') + QStringList{"--out", "second"}).status,
             0);
    for (const char *suffix : {".txt", ".scad", ".mtl"})
        QCOMPARE(contentOf(folder.filePath(QString("second") + suffix)),
                 contentOf(folder.filePath(QString("first") + suffix)));
    QCOMPARE(contentOf(folder.filePath("second.obj")).replace("second.mtl", "first.mtl"),
             contentOf(folder.filePath("first.obj")));
}

void TestMazegen::levelsAndBallAreWrittenTogether() {
    QTemporaryDir folder;
    QCOMPARE(runMazegen(folder.path(), {"--levels", ".", "--ball", "."}).status, 0);
    QCOMPARE(filesIn(folder.path()).size(), 4 * int(mazes::levelRecipes().size()) + 2);
}

void TestMazegen::wrongOptionsGiveOneLineAndNoFile_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("expected");
    const auto add = [](const QStringList &options, const char *expected) {
        QTest::newRow(qPrintable(options.join(' '))) << options << QString::fromUtf8(expected);
    };
    add({}, "--seed: expected a whole number from 0 to 18446744073709551615, found nothing");
    add({"--seed", "7"}, "--cells: expected WxH with W and H from 2 to 200, found nothing");
    add({"--seed"}, "--seed: expected a value, found nothing");
    add({"--seed", "7", "--seed", "8"}, "--seed: expected once, found twice");
    add({"--sede", "7"}, "expected an option of mazegen --help, found '--sede'");
    add({"7"}, "expected an option of mazegen --help, found '7'");
    for (const char *seed : {"-1", "1.5", "seven", "18446744073709551616", ""})
        QTest::newRow(qPrintable(QStringLiteral("seed '%1'").arg(seed)))
            << QStringList{"--seed", seed, "--cells", "5x4"}
            << QStringLiteral("--seed: expected a whole number from 0 to 18446744073709551615, found '%1'").arg(seed);
    for (const char *cells : {"5", "5x", "x5", "1x5", "5x201", "5y5", "5x5x5", "-5x5", "5 x 5", ""})
        QTest::newRow(qPrintable(QStringLiteral("cells '%1'").arg(cells)))
            << QStringList{"--seed", "7", "--cells", cells}
            << QStringLiteral("--cells: expected WxH with W and H from 2 to 200, found '%1'").arg(cells);
    add(kMaze + QStringList{"--algorithm", "Wilson"},
        "--algorithm: expected backtracker or kruskal or wilson, found 'Wilson'");
    for (const char *loops : {"-0.1", "1.000001", "10%", "0.1234567", ""})
        QTest::newRow(qPrintable(QStringLiteral("loops '%1'").arg(loops)))
            << kMaze + QStringList{"--loops", loops}
            << QStringLiteral("--loops: expected a fraction from 0 to 1 with at most six decimals, found '%1'")
                   .arg(loops);
    add(kMaze + QStringList{"--ball-radius", "6"},
        "--ball-radius: expected metres from 0.0005 to 0.1 with at most six decimals, found '6'");
    add(kMaze + QStringList{"--pitch", "36mm"},
        "--pitch: expected metres from 0.002 to 1 with at most six decimals, found '36mm'");
    add(kMaze + QStringList{"--wall-thickness", "0"},
        "--wall-thickness: expected metres from 0.0005 to 0.5 with at most six decimals, found '0'");
    add(kMaze + QStringList{"--wall-height", "1e-2"},
        "--wall-height: expected metres from 0.001 to 0.5 with at most six decimals, found '1e-2'");
    add(kMaze + QStringList{"--floor-thickness", "-0.005"},
        "--floor-thickness: expected metres from 0.0005 to 0.5 with at most six decimals, found '-0.005'");
    add(kMaze + QStringList{"--pitch", "0.017"},
        "corridor (pitch less wall thickness): expected more than the ball's diameter of 0.012 m, found 0.012 m");
    add(kMaze + QStringList{"--wall-thickness", "0.04"},
        "corridor (pitch less wall thickness): expected more than the ball's diameter of 0.012 m, found -0.004 m");
    add(kMaze + QStringList{"--wall-height", "0.006"},
        "wall height: expected more than the ball's radius of 0.006 m, found 0.006 m");
    add(kMaze + QStringList{"--out", "my maze"},
        "--out: expected a path that ends in a name without white space, found 'my maze'");
    add(kMaze + QStringList{"--out", "toys/"},
        "--out: expected a path that ends in a name without white space, found 'toys/'");
    add({"--levels", "nowhere"}, "--levels: expected an existing folder, found 'nowhere'");
    add({"--levels", ".", "--ball", "nowhere"}, "--ball: expected an existing folder, found 'nowhere'");
    add({"--levels", ".", "--seed", "7"},
        "--levels and --ball: expected no option of a single maze beside them, found --seed");
}

void TestMazegen::wrongOptionsGiveOneLineAndNoFile() {
    QFETCH(QStringList, options);
    QFETCH(QString, expected);
    QTemporaryDir folder;
    const Ending outcome = runMazegen(folder.path(), options);
    QCOMPARE(outcome.errors, "mazegen: " + expected + "\n");
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.output, QString());
    QCOMPARE(filesIn(folder.path()), QStringList());
}

void TestMazegen::aFileThatCannotBeWrittenIsNamedAndNothingIsLeft() {
    QTemporaryDir folder;
    const Ending missing = runMazegen(folder.path(), kMaze + QStringList{"--out", "nowhere/maze"});
    QCOMPARE(missing.errors, QString("mazegen: nowhere/maze.obj: cannot write: No such file or directory\n"));
    QCOMPARE(missing.status, 1);
    QCOMPARE(missing.output, QString());
    QCOMPARE(filesIn(folder.path()), QStringList());

    QVERIFY(QDir(folder.path()).mkpath("maze.obj/full"));
    const Ending taken = runMazegen(folder.path(), kMaze);
    QCOMPARE(taken.errors, QString("mazegen: maze.obj: cannot replace: Is a directory\n"));
    QCOMPARE(taken.status, 1);
    QCOMPARE(filesIn(folder.path()), QStringList{"maze.obj"});
}

void TestMazegen::aFileLimitIsToldAndNothingIsLeft() {
    QTemporaryDir folder;
    QProcess process;
    process.setWorkingDirectory(folder.path());
    process.start("/bin/sh", {"-c", "ulimit -f 1; exec \"$0\" --seed 7 --cells 20x20", MAZEGEN});
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(process.readAllStandardError(), QByteArray("mazegen: maze.obj: cannot write: File too large\n"));
    QCOMPARE(filesIn(folder.path()), QStringList());
}

void TestMazegen::messagesAreOneLineWhateverIsNamed() {
    QTemporaryDir folder;
    QCOMPARE(runMazegen(folder.path(), {"a\nb\x1b[31m"}).errors,
             QString("mazegen: expected an option of mazegen --help, found 'a\\x0ab\\x1b[31m'\n"));
    const Ending nowhere = runMazegen(folder.path(), kMaze + QStringList{"--out", "a\x1b/b"});
    QCOMPARE(nowhere.errors, QString("mazegen: a\\x1b/b.obj: cannot write: No such file or directory\n"));
    const Ending written = runMazegen(folder.path(), kMaze + QStringList{"--out", "a\x1b"});
    QCOMPARE(written.status, 0);
    QVERIFY2(written.output.startsWith("mazegen: a\\x1b.txt .obj"), qPrintable(written.output));
}

void TestMazegen::helpListsEveryOption() {
    QTemporaryDir folder;
    const Ending outcome = runMazegen(folder.path(), {"--help"});
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.errors, QString());
    for (const char *option :
         {"--seed N", "--cells WxH", "--algorithm NAME", "--loops FRACTION", "--ball-radius METRES", "--pitch METRES",
          "--wall-thickness METRES", "--wall-height METRES", "--floor-thickness METRES", "--out PREFIX",
          "--levels FOLDER", "--ball FOLDER"})
        QVERIFY2(outcome.output.contains(option), option);
    QVERIFY(outcome.output.contains("default 0.036"));
    QCOMPARE(filesIn(folder.path()), QStringList());
}

/// What only refusals told.
void TestMazegen::helpTellsWhatValuesMayBe() {
    QTemporaryDir folder;
    const QString help = runMazegen(folder.path(), {"--help"}).output;
    for (const char *rule : {"at most six decimals", "no exponent", "without white space", "more than the radius",
                             "more than a ball and a wall"})
        QVERIFY2(help.contains(rule), rule);
}

void TestMazegen::shortNamesAreTaken() {
    QTemporaryDir folder;
    QCOMPARE(runMazegen(folder.path(), {"-h"}).output, runMazegen(folder.path(), {"--help"}).output);
    QCOMPARE(runMazegen(folder.path(), {"-v"}).output, runMazegen(folder.path(), {"--version"}).output);
}

void TestMazegen::valueMayFollowAnEqualsSign() {
    QTemporaryDir folder;
    QCOMPARE(runMazegen(folder.path(), {"--seed", "7", "--cells", "5x4", "--out", "a"}).status, 0);
    QCOMPARE(runMazegen(folder.path(), {"--seed=7", "--cells=5x4", "--out=b=c"}).status, 0);
    QCOMPARE(contentOf(folder.filePath("b=c.txt")), contentOf(folder.filePath("a.txt")));
}

void TestMazegen::versionIsThatOfTheProject() {
    QTemporaryDir folder;
    const Ending outcome = runMazegen(folder.path(), {"--version"});
    QCOMPARE(outcome.status, 0);
    QVERIFY(QRegularExpression("^mazegen [0-9]+\\.[0-9]+\\.[0-9]+\n$").match(outcome.output).hasMatch());
}

void TestMazegen::filesOfAnotherKindAreNotReplaced() {
    QTemporaryDir folder;
    support::write(folder.filePath("notes.scad"), "cube(1);");
    const Ending outcome = runMazegen(folder.path(), QStringList(kMaze) << "--out"
                                                                        << "notes");
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.errors, QString("mazegen: notes.scad: there is another file of this name already\n"));
    QCOMPARE(filesIn(folder.path()), QStringList{"notes.scad"});
    QCOMPARE(contentOf(folder.filePath("notes.scad")), QByteArray("cube(1);"));
}

/// Nor pipes and devices, which the same line of the program finds.
void TestMazegen::linksAreNotReplaced() {
    QTemporaryDir folder;
    QVERIFY(QFile::link("elsewhere.txt", folder.filePath("link.txt")));
    const Ending outcome = runMazegen(folder.path(), QStringList(kMaze) << "--out"
                                                                        << "link");
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.errors, QString("mazegen: link.txt: there is another file of this name already\n"));
    QVERIFY(QFileInfo(folder.filePath("link.txt")).isSymLink());
}

/// Until a file is moved to its place, its bytes are in a file of another name.
void TestMazegen::aFileOfAnotherProgramsThatIsBeingWrittenStays() {
    QTemporaryDir folder;
    support::write(folder.filePath("maze.mtl.part"), "half");
    const Ending outcome = runMazegen(folder.path(), kMaze);
    QCOMPARE(outcome.errors, QString("mazegen: maze.mtl.part: there is a file of this name already\n"));
    QCOMPARE(outcome.status, 1);
    QCOMPARE(filesIn(folder.path()), QStringList{"maze.mtl.part"});
    QCOMPARE(contentOf(folder.filePath("maze.mtl.part")), QByteArray("half"));
}

QTEST_APPLESS_MAIN(TestMazegen)
#include "tst_mazegen.moc"
