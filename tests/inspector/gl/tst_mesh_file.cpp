// SPDX-License-Identifier: MIT
// Mesh files: what is read from good ones, what is said about bad ones; no screen needed.
#include "gl/mesh_builder.h"
#include "gl/mesh_file.h"
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
                                           << ":7: expected three finite numbers, found 'v 1 abc 2'";
        QTest::newRow("not a number") << corners + "v 1 nan 2\n"
                                      << ":7: expected three finite numbers, found 'v 1 nan 2'";
        QTest::newRow("two numbers") << corners + "vn 1 0\n"
                                     << ":7: expected three finite numbers, found 'vn 1 0'";
        QTest::newRow("face of two") << corners + "f 1 2\n"
                                     << ":7: expected a face of three or more corners, found 2";
        QTest::newRow("missing vertex") << corners + "f 1 2 5\n"
                                        << ":7: expected indices of the 4 vertices and 1 normals above, found '5'";
        QTest::newRow("missing normal") << corners + "f 1//1 2//2 3//1\n"
                                        << ":7: expected indices of the 4 vertices and 1 normals above, found '2//2'";
        QTest::newRow("index 0") << corners + "f 0 1 2\n"
                                 << ":7: expected indices of the 4 vertices and 1 normals above, found '0'";
        QTest::newRow("unknown material") << corners + "usemtl blue\nf 1 2 3\n"
                                          << ":7: expected a material of the .mtl file, found 'blue'";
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
        QCOMPARE(error, m_folder->filePath("none.obj") + ": No such file or directory");
    }

    void missingMaterialFileIsNamed() {
        const QString path = m_folder->filePath("a.obj");
        write(path, "mtllib gone.mtl\n");
        QString error;
        QVERIFY(!loadMesh(path, &error));
        QCOMPARE(error, path + ":1: material file '" + m_folder->filePath("gone.mtl") + "': No such file or directory");
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
