// SPDX-License-Identifier: MIT
// Maze text files: what is read, and how each kind of invalid line is refused (format: libphysics/docs/maze_format.md).
#include "support/compare.h"
#include "support/handles.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace support;

namespace {

constexpr char kGoodMaze[] = "physics-maze 1\n"
                             "units m\n"
                             "generator by hand\n"
                             "ball 0.0625\n"
                             "start 0.5 0.25 0.0625\n"
                             "box -1 -2 -0.5 3 4 0\n";

/// The good file with line `number` (from 1) replaced.
QByteArray withLine(int number, const QByteArray &line) {
    QList<QByteArray> lines = QByteArray(kGoodMaze).split('\n');
    lines[number - 1] = line;
    return lines.join('\n');
}

QByteArray without(const QByteArray &line) { return QByteArray(kGoodMaze).replace(line + "\n", ""); }

} // namespace

class TestMazeFiles : public QObject {
    Q_OBJECT

private slots:
    void goodFileIsReadAsWritten();
    void spellingsOfAGoodFileAreEqual_data();
    void spellingsOfAGoodFileAreEqual();
    void wrongLineIsRefusedWithItsNumber_data();
    void wrongLineIsRefusedWithItsNumber();
    void missingItemIsRefused_data();
    void missingItemIsRefused();
    void wrongSceneInAFileIsRefused_data();
    void wrongSceneInAFileIsRefused();
    void missingFileIsRefused();
    void directoryIsRefused();
    void pipeAndDeviceAreRefusedAtOnce();
    void whatTheSystemMakesUpIsAnEmptyFile();
    void textInMemoryGivesTheSceneOfTheFile();
    void wrongTextInMemoryIsRefusedByName();
    void longNameLeavesRoomForTheReason_data();
    void longNameLeavesRoomForTheReason();
    void binaryRubbishIsRefused();
    void everyLevelLoads_data();
    void everyLevelLoads();

private:
    /// Loads a file with this content; on failure `m_error` has the reason.
    ScenePtr load(const QByteArray &content);

    QTemporaryDir m_folder;
    QByteArray m_path;
    phys_error m_error{};
    phys_status m_status = PHYS_OK;
};

ScenePtr TestMazeFiles::load(const QByteArray &content) {
    m_path = m_folder.filePath("maze.txt").toUtf8();
    QFile file(QString::fromUtf8(m_path));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) return nullptr;
    file.close();
    phys_scene *scene = nullptr;
    m_status = phys_scene_load(m_path.constData(), &scene, &m_error);
    return ScenePtr(scene);
}

void TestMazeFiles::goodFileIsReadAsWritten() {
    const ScenePtr scene = load(kGoodMaze);
    QVERIFY2(scene, m_error.text);
    COMPARE_EXACT(phys_scene_radius(scene.get()), 0.0625);
    QCOMPARE(phys_scene_box_count(scene.get()), 1U);
    const phys_box expected{{-1, -2, -0.5}, {3, 4, 0}};
    QVERIFY(sameBits(*phys_scene_boxes(scene.get()), expected));
    phys_state start;
    QCOMPARE(phys_scene_start(scene.get(), &start), PHYS_OK);
    QVERIFY(start.position.x == 0.5 && start.position.y == 0.25 && start.position.z == 0.0625);
}

void TestMazeFiles::spellingsOfAGoodFileAreEqual_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("comments and empty lines")
        << QByteArray("# a maze\n\n") + QByteArray(kGoodMaze).replace("units m", "units m # metres");
    QTest::newRow("tabs and blanks") << QByteArray(kGoodMaze).replace(" ", " \t ");
    QTest::newRow("carriage returns") << QByteArray(kGoodMaze).replace("\n", "\r\n");
    QTest::newRow("no newline at the end") << QByteArray(kGoodMaze).chopped(1);
    QTest::newRow("exponents") << withLine(6, "box -1e0 -2 -5e-1 3 0.4E1 0");
    QTest::newRow("no zero before or behind a point") << withLine(6, "box -1. -2 -.5 3. 4 0E+1");
    QTest::newRow("items repeated") << QByteArray(kGoodMaze) + "units m\ngenerator again\n";
    QTest::newRow("any bytes in comments")
        << QByteArray(kGoodMaze) + QByteArray("# \xff\xfe\0\n", 6) + "generator \xff";
    QTest::newRow("another order") << QByteArray(
        "physics-maze 1\nbox -1 -2 -0.5 3 4 0\nstart 0.5 0.25 0.0625\nball 0.0625\nunits m\n");
    QTest::newRow("no generator") << without("generator by hand");
}

void TestMazeFiles::spellingsOfAGoodFileAreEqual() {
    QFETCH(QByteArray, content);
    const ScenePtr scene = load(content);
    QVERIFY2(scene, m_error.text);
    const phys_box expected{{-1, -2, -0.5}, {3, 4, 0}};
    QCOMPARE(phys_scene_box_count(scene.get()), 1U);
    QVERIFY(sameBits(*phys_scene_boxes(scene.get()), expected));
    COMPARE_EXACT(phys_scene_radius(scene.get()), 0.0625);
}

void TestMazeFiles::wrongLineIsRefusedWithItsNumber_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<int>("line");
    QTest::addColumn<QByteArray>("expected");
    QTest::addColumn<QByteArray>("found");
    const auto add = [](int line, const QByteArray &text, const QByteArray &expected, const QByteArray &found) {
        QTest::newRow((QByteArray::number(line) + ": " + text).constData())
            << withLine(line, text) << line << expected << found;
    };
    add(1, "maze 1", "physics-maze 1", "'maze'");
    add(1, "physics-maze 2", "version 1", "'2'");
    add(1, "physics-maze", "version 1", "''");
    add(1, "physics-maze 1 1", "end of the line", "'1'");
    add(2, "units mm", "units m", "'mm'");
    add(2, "units", "units m", "''");
    add(2, "units m m", "end of the line", "'m'");
    add(4, "ball", "1 number", "found 0");
    add(4, "ball big", "a number", "'big'");
    add(4, "ball 0,0625", "a number", "'0,0625'");
    add(4, "ball 0.0625m", "a number", "'0.0625m'");
    add(4, "ball 1e999", "a number", "'1e999'");
    add(4, "ball 1e-999", "a number", "'1e-999'");
    add(4, "ball +0.0625", "a number", "'+0.0625'");
    add(4, "ball inf", "a number", "'inf'");
    add(4, "ball 0.0625 0.0625", "end of the line", "'0.0625'");
    add(5, "start 0.5 0.25", "3 numbers", "found 2");
    add(5, "start 0.5 0.25 0.0625 0", "end of the line", "'0'");
    add(6, "box -1 -2 -0.5 3 4", "6 numbers", "found 5");
    add(6, "box -1 -2 -0.5 3 4 0 0", "end of the line", "'0'");
    add(6, "box 4 -2 -0.5 3 4 0", "x = 4", "3");
    add(6, "box -1 5 -0.5 3 4 0", "y = 5", "4");
    add(6, "box -1 -2 0.5 3 4 0", "z = 0.5", "0");
    add(6, "box nan -2 -0.5 3 4 0", "a number", "'nan'");
    add(6, "sphere 0 0 0 1", "box", "'sphere'");
    add(6, "ball 0.0625", "'ball'", "twice");
    add(6, "start 0 0 0", "'start'", "twice");
    add(3, "Units m", "units", "'Units'");
    for (const char *text : {"ball\r0.0625", "ball 0.0625\r\r", "ball 0.0625 # 6 cm\rof ball", "\rball 0.0625"})
        add(4, text + QByteArray("\r"), "\\n or \\r\\n as the end of the line", "\\r alone");
}

void TestMazeFiles::wrongLineIsRefusedWithItsNumber() {
    QFETCH(QByteArray, content);
    QFETCH(int, line);
    QFETCH(QByteArray, expected);
    QFETCH(QByteArray, found);
    QVERIFY(!load(content));
    QCOMPARE(m_status, PHYS_ERROR_SYNTAX);
    const QByteArray text = m_error.text;
    QVERIFY2(text.startsWith(m_path + ":" + QByteArray::number(line) + ": "), m_error.text);
    QVERIFY2(text.contains(expected) && text.contains(found), m_error.text);
    QVERIFY(!text.contains('\n'));
}

void TestMazeFiles::missingItemIsRefused_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("missing");
    QTest::newRow("units") << without("units m") << QByteArray("units");
    QTest::newRow("ball") << without("ball 0.0625") << QByteArray("ball");
    QTest::newRow("start") << without("start 0.5 0.25 0.0625") << QByteArray("start");
    QTest::newRow("everything") << QByteArray()
                                << QByteArray("'physics-maze 1' as the first line, found a file of size 0");
    QTest::newRow("everything but a comment")
        << QByteArray("# nothing\n") << QByteArray("'physics-maze 1' as the first line, found no more than comments");
}

void TestMazeFiles::missingItemIsRefused() {
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, missing);
    QVERIFY(!load(content));
    QCOMPARE(m_status, PHYS_ERROR_SYNTAX);
    QVERIFY2(QByteArray(m_error.text).startsWith(m_path), m_error.text);
    QVERIFY2(QByteArray(m_error.text).contains(missing), m_error.text);
}

void TestMazeFiles::wrongSceneInAFileIsRefused_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("radius 0") << withLine(4, "ball 0") << QByteArray(":4: radius is 0 m; allowed is");
    QTest::newRow("radius below 0") << withLine(4, "ball -1") << QByteArray("radius");
    QTest::newRow("start too far away") << withLine(5, "start 2e9 0 0") << QByteArray(":5: start is (2e+09, 0, 0)");
    QTest::newRow("box too far away") << withLine(6, "box -1 -2 -0.5 3 4e9 0")
                                      << QByteArray(":6: box 0: max.y is 4e+09 m; expected a number within +-1e+09 m");
    QTest::newRow("box just too far away")
        << withLine(6, "box -1 -2 -0.5 3 1.0000000001e9 0")
        << QByteArray(":6: box 0: max.y is 1000000000.1 m; expected a number within +-1e+09 m");
    QTest::newRow("radius just too large")
        << withLine(4, "ball 1.0000000001e6") << QByteArray("radius is 1000000.0001 m;");
    QTest::newRow("radius too small beside a coordinate")
        << withLine(4, "ball 1e-9").replace("box -1", "box -1e9") << QByteArray("maze.txt: radius is 1e-09 m beside");
}

void TestMazeFiles::wrongSceneInAFileIsRefused() {
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, reason);
    QVERIFY(!load(content));
    QCOMPARE(m_status, PHYS_ERROR_SCENE);
    QVERIFY2(QByteArray(m_error.text).startsWith(m_path), m_error.text);
    QVERIFY2(QByteArray(m_error.text).contains(reason), m_error.text);
}

void TestMazeFiles::missingFileIsRefused() {
    phys_scene *scene = nullptr;
    phys_error error;
    QCOMPARE(phys_scene_load("no/such/maze.txt", &scene, &error), PHYS_ERROR_FILE);
    QVERIFY(!scene);
    QVERIFY2(QByteArray(error.text).startsWith("no/such/maze.txt: "), error.text);
    QCOMPARE(phys_scene_load("", &scene, &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "path is empty; expected a file's name");
}

void TestMazeFiles::directoryIsRefused() {
    const QByteArray path = m_folder.path().toUtf8();
    phys_scene *scene = nullptr;
    phys_error error;
    QCOMPARE(phys_scene_load(path.constData(), &scene, &error), PHYS_ERROR_FILE);
    QVERIFY(!scene);
    QVERIFY2(QByteArray(error.text).startsWith(path), error.text);
}

void TestMazeFiles::pipeAndDeviceAreRefusedAtOnce() {
    const QByteArray pipe = QFile::encodeName(m_folder.filePath("pipe"));
    QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
    for (const QByteArray &path : {pipe, QByteArray("/dev/zero"), QByteArray("/dev/tty"), QByteArray(".")}) {
        phys_scene *scene = nullptr;
        phys_error error{};
        QCOMPARE(phys_scene_load(path.constData(), &scene, &error), PHYS_ERROR_FILE);
        QCOMPARE(QByteArray(error.text), path + ": not a regular file");
    }
}

void TestMazeFiles::whatTheSystemMakesUpIsAnEmptyFile() {
    QFile empty(m_folder.filePath("empty"));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    phys_scene *scene = nullptr;
    phys_error error{};
    const phys_status status = phys_scene_load(QFile::encodeName(empty.fileName()).constData(), &scene, &error);
    QVERIFY(status != PHYS_OK);
    for (const char *path : {"/proc/kmsg", "/proc/version"}) QCOMPARE(phys_scene_load(path, &scene, &error), status);
}

void TestMazeFiles::textInMemoryGivesTheSceneOfTheFile() {
    const ScenePtr file = load(kGoodMaze);
    QVERIFY2(file, m_error.text);
    phys_scene *parsed = nullptr;
    QCOMPARE(phys_scene_parse(kGoodMaze, sizeof kGoodMaze - 1, nullptr, &parsed, nullptr), PHYS_OK);
    const ScenePtr scene(parsed);
    QCOMPARE(phys_scene_radius(scene.get()), phys_scene_radius(file.get()));
    QCOMPARE(phys_scene_box_count(scene.get()), phys_scene_box_count(file.get()));
    QVERIFY(sameBits(*phys_scene_boxes(scene.get()), *phys_scene_boxes(file.get())));
    phys_state start, expected;
    phys_scene_start(scene.get(), &start);
    phys_scene_start(file.get(), &expected);
    QVERIFY(sameBits(start, expected));
}

void TestMazeFiles::wrongTextInMemoryIsRefusedByName() {
    phys_scene *scene = nullptr;
    phys_error error{};
    const QByteArray wrong = withLine(4, "ball big");
    QCOMPARE(phys_scene_parse(wrong.constData(), wrong.size(), "editor", &scene, &error), PHYS_ERROR_SYNTAX);
    QCOMPARE(QString(error.text), QString("editor:4: ball: expected a number in m, found 'big'"));
    QCOMPARE(phys_scene_parse(nullptr, 0, nullptr, &scene, &error), PHYS_ERROR_SYNTAX);
    QVERIFY(QByteArray(error.text).startsWith("text:"));
    QVERIFY(!scene);
}

void TestMazeFiles::longNameLeavesRoomForTheReason_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("plain") << QByteArray(5000, 'a') + ".txt";
    QTest::newRow("just too long") << QByteArray(205, 'a') + ".txt";
    for (int bytes = 0; bytes < 4; ++bytes) // so that the cut falls on each byte of a character
        QTest::addRow("of 4 bytes, +%d", bytes) << QByteArray("𝄞").repeated(100) + QByteArray(bytes, 'a') + ".txt";
    QTest::newRow("invisible") << QByteArray(300, '\x1b') + ".txt";
}

void TestMazeFiles::longNameLeavesRoomForTheReason() {
    QFETCH(QByteArray, name);
    phys_scene *scene = nullptr;
    phys_error error{};
    const QByteArray wrong = withLine(4, "ball big");
    QCOMPARE(phys_scene_parse(wrong.constData(), wrong.size(), name.constData(), &scene, &error), PHYS_ERROR_SYNTAX);
    const QByteArray text = error.text;
    QVERIFY2(text.startsWith("...") && text.endsWith(".txt:4: ball: expected a number in m, found 'big'"), error.text);
    QVERIFY(text.size() >= qsizetype(sizeof error.text) - 5); // no room is wasted, but for part of a character
    QCOMPARE(QString::fromUtf8(text).toUtf8(), text);
}

void TestMazeFiles::binaryRubbishIsRefused() {
    QByteArray rubbish(100'000, '\0');
    for (unsigned i = 0; i < unsigned(rubbish.size()); ++i) rubbish[i] = static_cast<char>(i * i * 31 + i * 7);
    rubbish.replace('\n', 'x');
    QVERIFY(!load(rubbish));
    QCOMPARE(m_status, PHYS_ERROR_SYNTAX);
    QVERIFY(!load(QByteArray(kGoodMaze) + rubbish));
    QCOMPARE(m_status, PHYS_ERROR_SYNTAX);
}

void TestMazeFiles::everyLevelLoads_data() {
    QTest::addColumn<QByteArray>("path");
    const QDir folder(LEVELS_FOLDER);
    for (const QString &name : folder.entryList({"??.txt"}))
        QTest::newRow(qPrintable(name)) << folder.filePath(name).toUtf8();
}

void TestMazeFiles::everyLevelLoads() {
    QFETCH(QByteArray, path);
    phys_scene *raw = nullptr;
    const phys_status status = phys_scene_load(path.constData(), &raw, &m_error);
    const ScenePtr scene(raw);
    QVERIFY2(status == PHYS_OK, m_error.text);
    QFile file(QString::fromUtf8(path));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(static_cast<qsizetype>(phys_scene_box_count(scene.get())), file.readAll().count("\nbox "));
    QVERIFY2(phys_scene_check_planar(scene.get(), &m_error) == PHYS_OK, m_error.text);
}

QTEST_GUILESS_MAIN(TestMazeFiles)
#include "tst_maze_files.moc"
