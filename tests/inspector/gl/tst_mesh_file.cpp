// SPDX-License-Identifier: MIT
// Mesh files: what is read from valid ones, and the messages for invalid ones; no screen needed.
#include "mesh/mesh_builder.h"
#include "mesh/mesh_file.h"
#include "support/files.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <glm/geometric.hpp>

using namespace inspector::gl;
using support::write;

namespace {

constexpr char kMaterials[] = "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 30\nnewmtl green\nKd 0 1 0\nKe 0 0.5 0\n";
constexpr char kCorners[] = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n"; // lines 1 to 6

} // namespace

class TestMeshFile : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        write(m_folder->filePath("m.mtl"), kMaterials);
    }

    void squareBecomesTwoTrianglesWithItsMaterial() {
        write(m_folder->filePath("a.obj"), QByteArray(kCorners) + "o square\nusemtl red\nf 1//1 2//1 3//1 4//1\n");
        QString error;
        const auto mesh = loadMesh(m_folder->filePath("a.obj"), &error);
        QVERIFY2(mesh, qPrintable(error));
        QCOMPARE(mesh->indices.size(), std::size_t(6));
        for (const Vertex &vertex : mesh->vertices) {
            QVERIFY(vertex.normal == glm::vec3(0, 0, 1));
            QCOMPARE(int(vertex.surface.x), 10); // Ks 0.5 is 4 % of 255
            QVERIFY(vertex.albedo.r > 200 && vertex.albedo.g == 0 && vertex.albedo.b == 0);
        }
        QVERIFY(mesh->bounds().minimum == glm::dvec3(0, 0, 0));
        QVERIFY(mesh->bounds().maximum == glm::dvec3(1, 1, 0));
    }

    void eachObjectKeepsItsOwnMaterial() {
        write(m_folder->filePath("a.obj"),
              QByteArray(kCorners) + "o one\nusemtl red\nf 1 2 3\no two\nusemtl green\nf 1 3 4\n");
        QString error;
        const auto mesh = loadMesh(m_folder->filePath("a.obj"), &error);
        QVERIFY2(mesh, qPrintable(error));
        const Vertex &first = mesh->vertices[mesh->indices.front()];
        const Vertex &last = mesh->vertices[mesh->indices.back()];
        QVERIFY(first.albedo.r > first.albedo.g);
        QVERIFY(last.albedo.g > last.albedo.r);
        QCOMPARE(int(first.surface.w), 0);
        QCOMPARE(int(last.surface.w), 128); // Ke is half of Kd
    }

    void withoutNormalsFacesAreFlat() {
        write(m_folder->filePath("a.obj"), QByteArray(kCorners) + "f 1 2 3\n");
        QString error;
        const auto mesh = loadMesh(m_folder->filePath("a.obj"), &error);
        QVERIFY2(mesh, qPrintable(error));
        QVERIFY(mesh->vertices[0].normal == glm::vec3(0, 0, 1)); // counter-clockwise seen from +z
    }

    void badFileGivesOneLine_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("message"); // after the path
        const QByteArray corners = kCorners;
        QTest::newRow("empty") << QByteArray() << ": expected at least one face, found none";
        QTest::newRow("no faces") << corners << ": expected at least one face, found none";
        QTest::newRow("word for a number") << corners + "v 1 abc 2\n"
                                           << ":7: expected 3 finite numbers, found 'v 1 abc 2'";
        QTest::newRow("not a number") << corners + "v 1 nan 2\n"
                                      << ":7: expected 3 finite numbers, found 'v 1 nan 2'";
        QTest::newRow("two numbers") << corners + "vn 1 0\n"
                                     << ":7: expected 3 finite numbers, found 'vn 1 0'";
        QTest::newRow("face of two") << corners + "f 1 2\n"
                                     << ":7: expected a face of three or more corners, found 2";
        QTest::newRow("missing vertex") << corners + "f 1 2 5\n"
                                        << ":7: expected indices of the 4 vertices and 1 normals above, found '5'";
        QTest::newRow("missing normal") << corners + "f 1//1 2//2 3//1\n"
                                        << ":7: expected indices of the 4 vertices and 1 normals above, found '2//2'";
        QTest::newRow("index 0") << corners + "f 0 1 2\n"
                                 << ":7: expected indices of the 4 vertices and 1 normals above, found '0'";
        QTest::newRow("carriage return in a comment")
            << QByteArray("# x\rv 0 0 0\rf 1 2 3\n")
            << ":3: expected indices of the 1 vertices and 0 normals above, found '2'";
        QTest::newRow("too large") << corners + "v 1e30 0 0\n"
                                   << ":7: expected numbers up to 1e+06, found '1e30'";
        QTest::newRow("index beyond int")
            << corners + "f 1 2 99999999999\n"
            << ":7: expected indices of the 4 vertices and 1 normals above, found '99999999999'";
        QTest::newRow("no area") << corners + "f 1 1 1\n"
                                 << ": expected a face with an area, found none";
    }

    void badFileGivesOneLine() {
        QFETCH(QByteArray, content);
        QFETCH(QString, message);
        const QString path = m_folder->filePath("a.obj");
        write(path, content);
        QString error;
        QVERIFY(!loadMesh(path, &error));
        QCOMPARE(error, path + message);
    }

    void missingFileIsNamed() {
        QString error;
        QVERIFY(!loadMesh(m_folder->filePath("none.obj"), &error));
        QCOMPARE(error, "'" + m_folder->filePath("none.obj") + "': No such file or directory");
    }

    // The mesh is drawn without its colours, and this is reported.
    void whatIsLeftOutIsSaid_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("note"); // after the path; FOLDER is the mesh's
        const QByteArray corners = kCorners;
        QTest::newRow("material file missing") << "mtllib gone.mtl\n" + corners + "f 1 2 3\n"
                                               << ":1: material file 'FOLDER/gone.mtl': No such file or directory";
        QTest::newRow("one of several missing") << "mtllib m.mtl gone.mtl\n" + corners + "usemtl red\nf 1 2 3\n"
                                                << ":1: material file 'FOLDER/gone.mtl': No such file or directory";
        QTest::newRow("folder as material file") << "mtllib .\n" + corners + "f 1 2 3\n"
                                                 << ":1: material file 'FOLDER/.': expected a file, found a folder";
        QTest::newRow("unknown material") << corners + "usemtl blue\nf 1 2 3\n"
                                          << ":7: expected a material of the .mtl file, found 'blue'";
        QTest::newRow("triangle without area") << corners + "f 1 2 3\nf 1 2 2\n"
                                               << ": 1 triangles have no area";
    }

    void whatIsLeftOutIsSaid() {
        QFETCH(QByteArray, content);
        QFETCH(QString, note);
        const QString path = m_folder->filePath("a.obj");
        write(path, content);
        QString problem;
        QVERIFY(loadMesh(path, &problem));
        QCOMPARE(problem, path + QString(note).replace("FOLDER", m_folder->path()));
    }

    void whatToolsWriteIsRead_data() {
        QTest::addColumn<QByteArray>("content");
        const QByteArray corners = kCorners;
        QTest::newRow("byte order mark") << "\xef\xbb\xbf" + corners + "usemtl red\nf 1 2 3\n";
        QTest::newRow("DOS line ends") << QByteArray(corners + "usemtl red\nf 1 2 3\n").replace("\n", "\r\n");
        QTest::newRow("line ends of old Macs") << QByteArray(corners + "usemtl red\nf 1 2 3\n").replace("\n", "\r");
        QTest::newRow("continued lines") << corners + "usemtl red\nf 1 \\\n2 \\\n3\n";
        QTest::newRow("comments behind") << corners + "usemtl red # wood\nf 1 2 3 # first\n";
        QTest::newRow("tabs and spaces") << corners + "usemtl\tred\n  f  1\t2   3  \n";
        QTest::newRow("last line without end") << corners + "usemtl red\nf 1 2 3";
        QTest::newRow("colours behind corners, as Blender") << corners + "v 2 2 0 0.5 0.5 0.5\nusemtl red\nf 1 2 3\n";
        QTest::newRow("texture coordinates") << corners + "vt 0 0\nusemtl red\nf 1/1/1 2/1/1 3/1/1\n";
        QTest::newRow("texture coordinates alone") << corners + "vt 0 0\nusemtl red\nf 1/1 2/1 3/1\n";
        QTest::newRow("counted backwards") << corners + "usemtl red\nf -4//-1 -3//-1 -2//-1\n";
        QTest::newRow("groups, smoothing, lines, points")
            << corners + "g a b\ns off\nl 1 2\np 1\nusemtl red\nf 1 2 3\n";
        QTest::newRow("normal of no length") << corners + "vn 0 0 0\nusemtl red\nf 1//2 2//2 3//2\n";
        QTest::newRow("several material files") << "mtllib m.mtl m2.mtl\n" + corners + "usemtl red\nf 1 2 3\n";
        QTest::newRow("material file with spaces") << "mtllib my maze.mtl\n" + corners + "usemtl red\nf 1 2 3\n";
        QTest::newRow("small triangle") << QByteArray(
            "mtllib m.mtl\nv 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nusemtl red\nf 1 2 3\n");
    }

    void whatToolsWriteIsRead() {
        QFETCH(QByteArray, content);
        write(m_folder->filePath("m2.mtl"), "newmtl other\nKd 0 0 1\n");
        write(m_folder->filePath("my maze.mtl"), kMaterials);
        const QString path = m_folder->filePath("a.obj");
        write(path, content);
        QString problem;
        const auto mesh = loadMesh(path, &problem);
        QVERIFY2(mesh && problem.isEmpty(), qPrintable(problem));
        QCOMPARE(mesh->indices.size(), std::size_t(3));
        for (const Vertex &vertex : mesh->vertices) {
            QVERIFY(vertex.albedo.r > 200 && vertex.albedo.g == 0);
            QVERIFY(std::abs(glm::length(vertex.normal) - 1.0F) < 1e-5F);
        }
    }

    // No index of a mesh may be out of range, whatever the file contains.
    void everyCutOfAMeshIsReadOrRefusedInOneLine() {
        const QByteArray text =
            "\xef\xbb\xbf"
            "mtllib m.mtl\r# c\rv 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nvn 0 0 1\nf 1//1 2//1 \\\n3//1 4\nf -1 -2 -3\n";
        const MaterialSource none = [](const QString &, QString *error) {
            *error = "none";
            return std::optional<QByteArray>();
        };
        for (qsizetype cut = 0; cut < text.size(); ++cut) {
            for (const char byte : {'\0', '\r', '\n', '-', '9', '/', '\xff'}) {
                QByteArray damaged = text;
                damaged[cut] = byte;
                QString problem;
                const auto mesh = parseMesh(damaged, none, &problem);
                QVERIFY(mesh || !problem.isEmpty());
                QVERIFY(!problem.contains('\n') && !problem.contains('\r'));
                if (!mesh) continue;
                for (const std::uint32_t index : mesh->indices) QVERIFY(index < mesh->vertices.size());
            }
        }
    }

    void levelsAndBallCanBeRead_data() {
        QTest::addColumn<QString>("path");
        for (const QFileInfo &file : QDir(LEVELS_FOLDER).entryInfoList({"*.obj"}))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }

    void levelsAndBallCanBeRead() {
        QFETCH(QString, path);
        QString error;
        const auto mesh = loadMesh(path, &error);
        QVERIFY2(mesh, qPrintable(error));
        for (const Vertex &vertex : mesh->vertices)
            QVERIFY(std::abs(glm::length(vertex.normal) - 1.0F) < 1e-5F); // floats, three products
    }

    void plainBallIsClosedAndOfRadiusOne() {
        const Mesh mesh = patternedBall();
        double volume = 0.0; // six times; positive when the triangles face outwards
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = mesh.vertices[mesh.indices[i]].position;
            const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].position;
            const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].position;
            volume += glm::dot(a, glm::cross(b, c));
            QVERIFY(std::abs(glm::length(a) - 1.0) < 1e-6);
        }
        // 4/3 pi less what 32 x 48 flat faces cut off: below 1.5 %.
        const double sphere = 8.0 * 3.14159265358979;
        QVERIFY(volume < sphere && volume > 0.985 * sphere);
    }

    void boxesKeepTheirBounds() {
        const MazeBox boxes[] = {{{-0.1, -0.1, -0.005}, {0.1, 0.1, 0.0}, BoxKind::Floor},
                                 {{-0.1, -0.1, 0.0}, {0.1, -0.095, 0.014}, BoxKind::Wall}};
        const Bounds bounds = mazeFromBoxes(boxes).bounds();
        // Vertices are floats.
        QVERIFY(glm::distance(bounds.minimum, glm::dvec3(-0.1, -0.1, -0.005)) < 1e-8);
        QVERIFY(glm::distance(bounds.maximum, glm::dvec3(0.1, 0.1, 0.014)) < 1e-8);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestMeshFile)
#include "tst_mesh_file.moc"
