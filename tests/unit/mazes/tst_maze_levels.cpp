// SPDX-License-Identifier: MIT
// The files in mazes/levels, level by level.
#include "disc_flood.h"
#include "maze_text.h"
#include "support/files.h"

#include "generator/levels.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <tiny_obj_loader.h>

#include <limits>
#include <map>
#include <set>

using support::contentOf;

namespace {

constexpr Nanometres kStep = 500'000; // half a millimetre: outlines and cells' centres lie on it

QString levelFile(const QString &name) { return QStringLiteral(LEVELS_FOLDER "/") + name; }

struct Mesh {
    QString problem;
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
};

Mesh loadMesh(const QString &path) {
    Mesh mesh;
    std::string warning;
    std::string error;
    const std::string folder = LEVELS_FOLDER "/";
    const bool isLoaded = tinyobj::LoadObj(&mesh.attributes, &mesh.shapes, &mesh.materials, &warning, &error,
                                           path.toStdString().c_str(), folder.c_str());
    if (!isLoaded || !warning.empty() || !error.empty())
        mesh.problem = QString::fromStdString(path.toStdString() + ": " + warning + error);
    return mesh;
}

using Vector = std::array<double, 3>;

Vector vectorAt(const std::vector<tinyobj::real_t> &values, int index) {
    const std::size_t first = 3 * static_cast<std::size_t>(index);
    return {values[first], values[first + 1], values[first + 2]};
}

Vector difference(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Triangles whose own normal points away from one of their vertices' normals.
int insideOutTriangles(const Mesh &mesh) {
    int count = 0;
    for (const tinyobj::shape_t &shape : mesh.shapes) {
        const auto &indices = shape.mesh.indices;
        for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
            const Vector a = vectorAt(mesh.attributes.vertices, indices[first].vertex_index);
            const Vector b = vectorAt(mesh.attributes.vertices, indices[first + 1].vertex_index);
            const Vector c = vectorAt(mesh.attributes.vertices, indices[first + 2].vertex_index);
            const Vector normal = cross(difference(b, a), difference(c, a));
            for (std::size_t i = 0; i < 3; ++i)
                if (dot(normal, vectorAt(mesh.attributes.normals, indices[first + i].normal_index)) < 0) ++count;
        }
    }
    return count;
}

// Edges that aren't shared by two triangles running along them in opposite directions; vertices at one place are one.
int openEdges(const Mesh &mesh, const tinyobj::shape_t &shape) {
    std::map<std::pair<Vector, Vector>, int> balance;
    const auto &indices = shape.mesh.indices;
    for (std::size_t corner = 0; corner < indices.size(); ++corner) {
        const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
        const Vector from = vectorAt(mesh.attributes.vertices, indices[corner].vertex_index);
        const Vector to = vectorAt(mesh.attributes.vertices, indices[next].vertex_index);
        ++balance[{from, to}];
        --balance[{to, from}];
    }
    return static_cast<int>(
        std::count_if(balance.begin(), balance.end(), [](const auto &edge) { return edge.second != 0; }));
}

std::set<std::string> materialsUsed(const Mesh &mesh, const tinyobj::shape_t &shape) {
    std::set<std::string> names;
    for (const int material : shape.mesh.material_ids)
        names.insert(material < 0 ? "none" : mesh.materials[static_cast<std::size_t>(material)].name);
    return names;
}

// The name that the mesh should give a box, derived from the box's position.
std::string materialOf(const TextBox &box, const TextBox &board) {
    if (box.isWall()) return box.min[2] < 0 ? "rim" : "wall";
    const bool touchesOutline = box.min[0] == board.min[0] || box.max[0] == board.max[0] ||
                                box.min[1] == board.min[1] || box.max[1] == board.max[1];
    return touchesOutline ? "exit" : "floor";
}

// Whether the straight line between two points of the floor is free of walls.
bool isFree(const MazeText &maze, Nanometres x0, Nanometres y0, Nanometres x1, Nanometres y1) {
    return std::none_of(maze.boxes.begin(), maze.boxes.end(), [&](const TextBox &box) {
        return box.isWall() && box.max[0] > std::min(x0, x1) && box.min[0] < std::max(x0, x1) + 1 &&
               box.max[1] > std::min(y0, y1) && box.min[1] < std::max(y0, y1) + 1;
    });
}

void levelRows() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("index");
    for (int level = 1; level <= int(mazes::levelRecipes().size()); ++level) {
        const QString name = QStringLiteral("%1").arg(level, 2, 10, QLatin1Char('0'));
        QTest::newRow(qPrintable(name)) << name << level - 1;
    }
}

} // namespace

class TestMazeLevels : public QObject {
    Q_OBJECT

private slots:
    void aLevelIsFourFilesAndTheBallTwo();
    void regeneratedByteForByte_data();
    void regeneratedByteForByte();
    void boxesAreTheBoundsOfTheMeshes_data() { levelRows(); }
    void boxesAreTheBoundsOfTheMeshes();
    void meshesAreClosedAndFaceOutwards_data() { levelRows(); }
    void meshesAreClosedAndFaceOutwards();
    void everyCellIsReachableByTheBall_data() { levelRows(); }
    void everyCellIsReachableByTheBall();
    void thereIsExactlyOneWayOut_data() { levelRows(); }
    void thereIsExactlyOneWayOut();
    void passagesAreOneLessThanCellsUnlessThereAreLoops_data() { levelRows(); }
    void passagesAreOneLessThanCellsUnlessThereAreLoops();
    void eachLevelsWayOutIsLongerThanTheLast();
    void theReadmesTableHasEachLevel_data() { levelRows(); }
    void theReadmesTableHasEachLevel();
    void scadIsOneSolidOfTheBoardsSizeInMillimetres_data() { levelRows(); }
    void scadIsOneSolidOfTheBoardsSizeInMillimetres();
    void ballIsAUnitSphereOfThreeColours();
    void ballLooksDifferentAfterAQuarterTurnAboutAnyAxis();
};

void TestMazeLevels::aLevelIsFourFilesAndTheBallTwo() {
    QCOMPARE(mazes::levelFiles(LEVELS_FOLDER).size(), 4 * mazes::levelRecipes().size());
    QCOMPARE(mazes::ballFiles(LEVELS_FOLDER).size(), std::size_t{2});
}

void TestMazeLevels::regeneratedByteForByte_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("content");
    std::vector<mazes::OutputFile> files = mazes::levelFiles(LEVELS_FOLDER);
    for (mazes::OutputFile &file : mazes::ballFiles(LEVELS_FOLDER)) files.push_back(std::move(file));
    for (const mazes::OutputFile &file : files)
        QTest::newRow(file.path.filename().string().c_str())
            << QString::fromStdString(file.path.string()) << QByteArray::fromStdString(file.content);
}

void TestMazeLevels::regeneratedByteForByte() {
    QFETCH(QString, path);
    QFETCH(QByteArray, content);
    QVERIFY(QFileInfo::exists(path));
    QVERIFY2(contentOf(path) == content, "made anew it differs: run mazegen --levels and --ball, look at git diff");
}

void TestMazeLevels::boxesAreTheBoundsOfTheMeshes() {
    QFETCH(QString, name);
    const MazeText maze = readMazeText(levelFile(name + ".txt"));
    QCOMPARE(maze.problem, QString());
    const Mesh mesh = loadMesh(levelFile(name + ".obj"));
    QCOMPARE(mesh.problem, QString());
    QCOMPARE(mesh.shapes.size(), maze.boxes.size());
    for (std::size_t i = 0; i < maze.boxes.size(); ++i) {
        const double unset = std::numeric_limits<double>::infinity();
        Vector min{unset, unset, unset};
        Vector max{-unset, -unset, -unset};
        for (const tinyobj::index_t &index : mesh.shapes[i].mesh.indices) {
            const Vector position = vectorAt(mesh.attributes.vertices, index.vertex_index);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                min[axis] = std::min(min[axis], position[axis]);
                max[axis] = std::max(max[axis], position[axis]);
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // The loader keeps floats: 0.3 m is right to 15 nm, and lengths are whole micrometres or halves of them.
            QCOMPARE(qRound64(min[axis] * 1e7), qRound64(static_cast<double>(maze.boxes[i].min[axis]) / 100));
            QCOMPARE(qRound64(max[axis] * 1e7), qRound64(static_cast<double>(maze.boxes[i].max[axis]) / 100));
        }
        QCOMPARE(materialsUsed(mesh, mesh.shapes[i]), std::set<std::string>{materialOf(maze.boxes[i], maze.bounds())});
    }
}

void TestMazeLevels::meshesAreClosedAndFaceOutwards() {
    QFETCH(QString, name);
    const Mesh mesh = loadMesh(levelFile(name + ".obj"));
    QCOMPARE(mesh.problem, QString());
    QCOMPARE(insideOutTriangles(mesh), 0);
    for (const tinyobj::shape_t &shape : mesh.shapes) QCOMPARE(openEdges(mesh, shape), 0);
}

void TestMazeLevels::everyCellIsReachableByTheBall() {
    QFETCH(QString, name);
    QFETCH(int, index);
    const mazes::Recipe recipe = mazes::levelRecipes()[static_cast<std::size_t>(index)];
    const MazeText maze = readMazeText(levelFile(name + ".txt"));
    const DiscFlood flood(maze, maze.ballRadius, kStep);
    const Nanometres pitch = recipe.dimensions.pitch;
    for (int y = 0; y < recipe.height; ++y)
        for (int x = 0; x < recipe.width; ++x)
            QVERIFY2(flood.reaches((2 * x + 1 - recipe.width) * pitch / 2, (2 * y + 1 - recipe.height) * pitch / 2),
                     qPrintable(QStringLiteral("cell %1, %2").arg(x).arg(y)));
}

void TestMazeLevels::thereIsExactlyOneWayOut() {
    QFETCH(QString, name);
    const MazeText maze = readMazeText(levelFile(name + ".txt"));
    QCOMPARE(DiscFlood(maze, maze.ballRadius, kStep).waysOut(), 1);
    QCOMPARE(DiscFlood(maze, 0, kStep).waysOut(), 1);
}

void TestMazeLevels::passagesAreOneLessThanCellsUnlessThereAreLoops() {
    QFETCH(QString, name);
    QFETCH(int, index);
    const mazes::Recipe recipe = mazes::levelRecipes()[static_cast<std::size_t>(index)];
    const MazeText maze = readMazeText(levelFile(name + ".txt"));
    const Nanometres pitch = recipe.dimensions.pitch;
    int passages = 0;
    for (int y = 0; y < recipe.height; ++y) {
        for (int x = 0; x < recipe.width; ++x) {
            const Nanometres centreX = (2 * x + 1 - recipe.width) * pitch / 2;
            const Nanometres centreY = (2 * y + 1 - recipe.height) * pitch / 2;
            if (x + 1 < recipe.width && isFree(maze, centreX, centreY, centreX + pitch, centreY)) ++passages;
            if (y + 1 < recipe.height && isFree(maze, centreX, centreY, centreX, centreY + pitch)) ++passages;
        }
    }
    const int perfect = recipe.width * recipe.height - 1;
    if (recipe.loopMillionths == 0)
        QCOMPARE(passages, perfect);
    else
        QVERIFY(passages > perfect);
}

void TestMazeLevels::eachLevelsWayOutIsLongerThanTheLast() {
    int last = 0;
    for (const mazes::Recipe &recipe : mazes::levelRecipes()) {
        const int length = mazes::wayLength(mazes::makeMaze(recipe));
        QVERIFY2(length > last, qPrintable(QString("%1 cells after %2").arg(length).arg(last)));
        last = length;
    }
}

void TestMazeLevels::theReadmesTableHasEachLevel() {
    QFETCH(QString, name);
    QFETCH(int, index);
    const mazes::Recipe recipe = mazes::levelRecipes()[static_cast<std::size_t>(index)];
    const QString loops = recipe.loopMillionths ? QString(" %1 %").arg(recipe.loopMillionths / 10'000) : QString();
    const QString row = QString("| %1 | %2 x %3 | %4 |%5 | %6 |\n")
                            .arg(name)
                            .arg(recipe.width)
                            .arg(recipe.height)
                            .arg(QString::fromStdString(std::string(mazes::algorithmName(recipe.algorithm))), loops)
                            .arg(mazes::wayLength(mazes::makeMaze(recipe)));
    QVERIFY2(contentOf(MAZES_FOLDER "/README.md").contains(row.toUtf8()), qPrintable("it lacks " + row));
}

void TestMazeLevels::scadIsOneSolidOfTheBoardsSizeInMillimetres() {
    QFETCH(QString, name);
    const QString openscad = QStandardPaths::findExecutable("openscad");
    if (openscad.isEmpty()) QSKIP("openscad isn't installed");
    QTemporaryDir folder;
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(openscad, {"-o", folder.filePath("board.stl"), levelFile(name + ".scad")});
    QVERIFY(process.waitForFinished(60'000));
    const QByteArray output = process.readAll();
    QVERIFY2(process.exitCode() == 0, output);
    QVERIFY2(QRegularExpression("Simple: +yes").match(output).hasMatch(), output);

    const TextBox board = readMazeText(levelFile(name + ".txt")).bounds();
    const QRegularExpression vertex("vertex (\\S+) (\\S+) (\\S+)");
    auto vertices = vertex.globalMatch(QString::fromUtf8(contentOf(folder.filePath("board.stl"))));
    QVERIFY(vertices.hasNext());
    Vector min{1e9, 1e9, 1e9};
    Vector max{-1e9, -1e9, -1e9};
    while (vertices.hasNext()) {
        const QRegularExpressionMatch match = vertices.next();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double coordinate = match.captured(static_cast<int>(axis) + 1).toDouble();
            min[axis] = std::min(min[axis], coordinate);
            max[axis] = std::max(max[axis], coordinate);
        }
    }
    // The levels' coordinates are halves of millimetres: exact in the .stl file.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QCOMPARE(min[axis], static_cast<double>(board.min[axis]) / 1e6);
        QCOMPARE(max[axis], static_cast<double>(board.max[axis]) / 1e6);
    }
}

void TestMazeLevels::ballIsAUnitSphereOfThreeColours() {
    const Mesh mesh = loadMesh(levelFile("ball.obj"));
    QCOMPARE(mesh.problem, QString());
    QCOMPARE(mesh.shapes.size(), std::size_t{1});
    QCOMPARE(materialsUsed(mesh, mesh.shapes[0]), (std::set<std::string>{"ball_dark", "ball_dot", "ball_light"}));
    QCOMPARE(insideOutTriangles(mesh), 0);
    QCOMPARE(openEdges(mesh, mesh.shapes[0]), 0);
    for (const tinyobj::index_t &index : mesh.shapes[0].mesh.indices) {
        const Vector position = vectorAt(mesh.attributes.vertices, index.vertex_index);
        QCOMPARE(vectorAt(mesh.attributes.normals, index.normal_index), position);
        QVERIFY(std::abs(dot(position, position) - 1) < 3e-6); // three coordinates, each rounded to six decimals
    }
}

void TestMazeLevels::ballLooksDifferentAfterAQuarterTurnAboutAnyAxis() {
    const Mesh mesh = loadMesh(levelFile("ball.obj"));
    QCOMPARE(mesh.problem, QString());
    std::map<std::array<qint64, 3>, int> materialAt; // by the sum of a triangle's corners, in millionths
    const auto &shape = mesh.shapes[0].mesh;
    const auto sumOf = [&](std::size_t triangle) {
        std::array<qint64, 3> sum{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector corner = vectorAt(mesh.attributes.vertices, shape.indices[3 * triangle + i].vertex_index);
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += qRound64(corner[axis] * 1e6);
        }
        return sum;
    };
    for (std::size_t triangle = 0; triangle < shape.material_ids.size(); ++triangle)
        materialAt[sumOf(triangle)] = shape.material_ids[triangle];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::size_t found = 0;
        std::size_t changed = 0;
        for (std::size_t triangle = 0; triangle < shape.material_ids.size(); ++triangle) {
            std::array<qint64, 3> turned = sumOf(triangle);
            std::swap(turned[(axis + 1) % 3], turned[(axis + 2) % 3]);
            turned[(axis + 1) % 3] = -turned[(axis + 1) % 3];
            const auto there = materialAt.find(turned);
            if (there == materialAt.end()) continue;
            ++found;
            if (there->second != shape.material_ids[triangle]) ++changed;
        }
        QVERIFY(found >
                shape.material_ids.size() / 4); // quads are cut along one diagonal: not every triangle has a twin
        QVERIFY2(changed > found / 2, "most of the ball must change colour");
    }
}

QTEST_APPLESS_MAIN(TestMazeLevels)
#include "tst_maze_levels.moc"
