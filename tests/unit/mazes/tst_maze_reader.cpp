// SPDX-License-Identifier: MIT
// The library reads the text format as libphysics/docs/maze_format.md describes it, and refuses anything else in one
// line.
#include "maze_text.h"

#include <physics/physics.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace {

using OwnedScene = std::unique_ptr<phys_scene, decltype(&phys_scene_destroy)>;

struct Loaded {
    phys_status status = PHYS_OK;
    QString problem;
    OwnedScene scene{nullptr, phys_scene_destroy};
};

Loaded load(const QString &path) {
    phys_scene *scene = nullptr;
    phys_error error{};
    Loaded loaded;
    loaded.status = phys_scene_load(path.toUtf8().constData(), &scene, &error);
    loaded.scene.reset(scene);
    loaded.problem = QString::fromUtf8(error.text);
    return loaded;
}

// The name alone, in the current folder: a message with a long path would be cut.
QString write(const QTemporaryDir &folder, const QByteArray &content) {
    const QString name = QStringLiteral("wände.txt");
    QFile file(name);
    if (!QDir::setCurrent(folder.path()) || !file.open(QIODevice::WriteOnly)) return {};
    return file.write(content) == content.size() ? name : QString();
}

const QByteArray kHeader = "physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\n"; // four lines
const QByteArray kFloorBox = "box -1 -1 -0.005 1 1 0\n";

void levelPaths() {
    QTest::addColumn<QString>("path");
    for (int level = 1; level <= 10; ++level) {
        const QString name = QStringLiteral("%1").arg(level, 2, 10, QLatin1Char('0'));
        QTest::newRow(qPrintable(name)) << QStringLiteral(MAZES_FOLDER "/levels/") + name + ".txt";
    }
}

} // namespace

class TestMazeReader : public QObject {
    Q_OBJECT

private slots:
    void everyLevelIsReadAsWritten_data() { levelPaths(); }
    void everyLevelIsReadAsWritten();
    void inEveryLevelTheBallRestsOnTheFloorAmongWallsOnly_data() { levelPaths(); }
    void inEveryLevelTheBallRestsOnTheFloorAmongWallsOnly();
    void theExampleOfTheFormatIsRead();
    void commentsBlanksAndLineEndsDontMatter();
    void wrongFilesAreRefusedWithFileAndLine_data();
    void wrongFilesAreRefusedWithFileAndLine();
    void aMissingFileIsNamed();
};

void TestMazeReader::everyLevelIsReadAsWritten() {
    QFETCH(QString, path);
    const MazeText maze = readMazeText(path);
    const Loaded loaded = load(path);
    QCOMPARE(loaded.problem, QString());
    QCOMPARE(std::size_t{phys_scene_box_count(loaded.scene.get())}, maze.boxes.size());
    const phys_box *boxes = phys_scene_boxes(loaded.scene.get());
    // A whole number of nanometres over 1e9 is the double nearest to the decimal in the file: equal bits, no tolerance.
    const auto isEqual = [](const phys_vec3 &read, const std::array<Nanometres, 3> &written) {
        return read.x == static_cast<double>(written[0]) / 1e9 && read.y == static_cast<double>(written[1]) / 1e9 &&
               read.z == static_cast<double>(written[2]) / 1e9;
    };
    for (std::size_t i = 0; i < maze.boxes.size(); ++i) {
        QVERIFY2(isEqual(boxes[i].min, maze.boxes[i].min), qPrintable(QStringLiteral("box %1").arg(i)));
        QVERIFY2(isEqual(boxes[i].max, maze.boxes[i].max), qPrintable(QStringLiteral("box %1").arg(i)));
    }
    QVERIFY(phys_scene_radius(loaded.scene.get()) == static_cast<double>(maze.ballRadius) / 1e9);
}

void TestMazeReader::inEveryLevelTheBallRestsOnTheFloorAmongWallsOnly() {
    QFETCH(QString, path);
    const Loaded loaded = load(path);
    QCOMPARE(loaded.problem, QString());
    phys_error error{};
    QVERIFY2(phys_scene_check_planar(loaded.scene.get(), &error) == PHYS_OK, error.text);
}

void TestMazeReader::theExampleOfTheFormatIsRead() {
    QFile page(QStringLiteral(MAZES_FOLDER "/../libphysics/docs/maze_format.md"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QByteArray text = page.readAll();
    const qsizetype begin = text.indexOf("physics-maze 1");
    const qsizetype end = text.indexOf("```", begin);
    QVERIFY(begin >= 0 && end > begin);
    QTemporaryDir folder;
    const Loaded loaded = load(write(folder, text.mid(begin, end - begin)));
    QCOMPARE(loaded.problem, QString());
    QCOMPARE(phys_scene_box_count(loaded.scene.get()), 1U);
    QCOMPARE(phys_scene_radius(loaded.scene.get()), 0.006);
}

void TestMazeReader::commentsBlanksAndLineEndsDontMatter() {
    QTemporaryDir folder;
    const QByteArray content = "# a maze\r\n\r\n  physics-maze\t1 # version\r\nbox -1 -1 -1 1 1 0\r\n\tstart 0 0 .5\r\n"
                               "units m\r\nball 5e-1#radius\r\n#box 9";
    const Loaded loaded = load(write(folder, content));
    QCOMPARE(loaded.problem, QString());
    QCOMPARE(phys_scene_box_count(loaded.scene.get()), 1U);
    QCOMPARE(phys_scene_radius(loaded.scene.get()), 0.5);
}

void TestMazeReader::wrongFilesAreRefusedWithFileAndLine_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("expected"); // after the file's name
    const auto add = [](const char *tag, const QByteArray &content, const char *expected) {
        QTest::newRow(tag) << content << QString::fromUtf8(expected);
    };
    add("empty", "", ":1: expected 'physics-maze 1' as the first line, found a file of size 0");
    add("another kind of file", "# board\no floor_0\n", ":2: expected 'physics-maze 1', found 'o'");
    add("a later version", "physics-maze 2\n", ":1: expected version 1, found '2'");
    add("no version", "physics-maze\n", ":1: expected version 1, found ''");
    add("another unit", "physics-maze 1\nunits mm\n", ":2: expected 'units m', found 'mm'");
    add("no unit", "physics-maze 1\nball 1\nstart 0 0 1\n", ":3: 'units m' is missing");
    add("no ball", "physics-maze 1\nunits m\nstart 0 0 1\n", ":3: 'ball RADIUS' is missing");
    add("no start", "physics-maze 1\nunits m\nball 1\n", ":3: 'start X Y Z' is missing");
    add("two balls", kHeader + "ball 0.006\n", ":5: 'ball' is given twice");
    add("unknown word", kHeader + kFloorBox + "sphere 1\n",
        ":6: expected units, generator, ball, start or box, found 'sphere'");
    add("number missing", kHeader + "box 0 0 0 1 1\n", ":5: box: expected 6 numbers in m, found 5");
    add("number too many", kHeader + "box 0 0 0 1 1 1 1\n", ":5: expected the end of the line, found '1'");
    add("no radius", "physics-maze 1\nball\n", ":2: ball: expected 1 number in m, found 0");
    add("byte order mark", "\xef\xbb\xbfphysics-maze 1\n",
        ":1: expected 'physics-maze 1', found a byte order mark (BOM) before it; save the file without");
    for (const auto &[tag, text] : {std::pair("UTF-16", QByteArray("\xff\xfep\0h\0\r\0\n\0", 10)),
                                    std::pair("UTF-16, big-endian", QByteArray("\xfe\xff\0p\0h\0\r\0\n", 10))})
        add(tag, text, ":1: expected 'physics-maze 1', found UTF-16; save the file as UTF-8");
    add("NUL", QByteArray("physics-maze 1\nunits\0 m\n", 24),
        ":2: expected units, generator, ball, start or box, found 'units\\x00'");
    add("blank of another kind", "physics-maze 1\nball\u00a00.006\n",
        ":2: expected units, generator, ball, start or box, found 'ball\\xc2\\xa00.006'");
    add("carriage returns alone", "physics-maze 1\runits m\r",
        ":1: expected \\n or \\r\\n as the end of the line, found \\r alone");
    add("no number", kHeader + "box 0 0 0 1 1 1mm\n", ":5: box: expected a number in m, found '1mm'");
    add("comma", kHeader + "box 0 0 0 1 1 0,5\n", ":5: box: expected a number in m, found '0,5'");
    add("beyond double", kHeader + "box 0 0 0 1 1 1e999\n",
        ":5: box: expected a number in m, found '1e999', which is beyond what a number can hold");
    add("corners swapped", kHeader + kFloorBox + "box 0 1 0 1 0 1\n",
        ":6: box: the lower corner's y = 1 is above the upper one's 0");
}

void TestMazeReader::wrongFilesAreRefusedWithFileAndLine() {
    QFETCH(QByteArray, content);
    QFETCH(QString, expected);
    QTemporaryDir folder;
    const QString path = write(folder, content);
    const Loaded loaded = load(path);
    QCOMPARE(loaded.problem, path + expected);
    QCOMPARE(loaded.status, PHYS_ERROR_SYNTAX);
    QVERIFY(!loaded.scene);
}

void TestMazeReader::aMissingFileIsNamed() {
    const Loaded loaded = load(QStringLiteral("nowhere/maze.txt"));
    QCOMPARE(loaded.problem, QString("nowhere/maze.txt: No such file or directory"));
    QCOMPARE(loaded.status, PHYS_ERROR_FILE);
    QVERIFY(!loaded.scene);
}

QTEST_APPLESS_MAIN(TestMazeReader)
#include "tst_maze_reader.moc"
