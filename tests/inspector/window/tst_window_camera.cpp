// SPDX-License-Identifier: MIT
// The camera by keys and behind the ball, the ruler, the minimum size of a ball in the picture, and the exit of a
// user's own maze.
#include "mesh/mesh_builder.h"
#include "ui/window/board_picture.h"
#include "window_fixture.h"

#include <QLabel>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace window_test;

class TestWindowCamera : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void fKeepsTheBallInTheMiddle();
    void showingEverythingEndsFollowing();
    void followedBallIsNearerBy();
    void shiftDragMeasures();
    void escTakesTheRulerAway();
    void plainDragMeasuresNothing();
    void smallBallIsDrawnLargeEnough();
    void ownMazeShowsItsExit();
    void keysMoveTheCamera_data();
    void keysMoveTheCamera();

private:
    inspector::gl::MazeView &view() { return m_fixture->window().view(); }
    phys_state ball() { return m_fixture->simulation().latest().current; }
    QPointF pixelOf(double x, double y, double z) { return view().positionOf({x, y, z}); }
    void openMaze(const QByteArray &text);
};

void TestWindowCamera::init() { QVERIFY(open(3, inspector::gl::Drawing::Solid)); }

void TestWindowCamera::openMaze(const QByteArray &text) {
    QFile file(m_fixture->path("own.txt"));
    const QByteArray whole = "physics-maze 1\nunits m\nball 0.006\nstart 0 0 0.006\n" + text;
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(whole) == whole.size());
    file.close();
    QVERIFY(m_fixture->session().openLevel(inspector::levelOfFile(file.fileName())));
}

void TestWindowCamera::fKeepsTheBallInTheMiddle() {
    m_fixture->press(Qt::Key_F);
    m_fixture->parameters().set({{"tilt_y", 5.0}});
    const double start = ball().position.y;
    m_fixture->makeSteps(40);
    QVERIFY(ball().position.y > start + 0.01);
    const auto isInTheMiddle = [this] {
        view().grabFramebuffer();
        const phys_vec3 place = ball().position;
        const QPointF off = pixelOf(place.x, place.y, place.z) - QRectF(view().rect()).center();
        return off.manhattanLength() < 2.0;
    };
    QTRY_VERIFY(isInTheMiddle());
}

void TestWindowCamera::showingEverythingEndsFollowing() {
    const double all = view().camera().distance();
    m_fixture->press(Qt::Key_F);
    QVERIFY(m_fixture->find<QAction>("camera_follow")->isChecked());
    QTest::mouseDClick(&view(), Qt::LeftButton, {}, QPoint(10, 10));
    QVERIFY(!m_fixture->find<QAction>("camera_follow")->isChecked());
    QCOMPARE(view().camera().distance(), all);
}

void TestWindowCamera::followedBallIsNearerBy() {
    const double all = view().camera().distance();
    m_fixture->press(Qt::Key_F);
    QVERIFY(view().camera().distance() < 0.5 * all);
    m_fixture->press(Qt::Key_F);
    QCOMPARE(view().camera().distance(), all);
}

// 30 mm along x and 40 mm along y.
void TestWindowCamera::shiftDragMeasures() {
    drag(&view(), pixelOf(-0.02, -0.02, 0.0).toPoint(), pixelOf(0.01, 0.02, 0.0).toPoint(), Qt::ShiftModifier);
    const auto *text = m_fixture->find<QLabel>("ruler");
    QVERIFY(text->isVisible());
    const QStringList words = text->text().split(' ');
    QCOMPARE(words.at(1), QString("mm"));
    QVERIFY2(std::abs(words.at(0).toDouble() - 50.0) < 1.0, qPrintable(text->text())); // a pixel is some 0.4 mm
    const double angle = QString(words.at(3)).remove(QChar(0xb0)).toDouble();
    QVERIFY2(std::abs(angle - 53.13) < 1.0, qPrintable(text->text()));
}

void TestWindowCamera::escTakesTheRulerAway() {
    drag(&view(), {200, 200}, {260, 220}, Qt::ShiftModifier);
    auto *text = m_fixture->find<QLabel>("ruler");
    QVERIFY(text->isVisible());
    m_fixture->press(Qt::Key_Escape);
    QVERIFY(!text->isVisible());
}

void TestWindowCamera::plainDragMeasuresNothing() {
    const double azimuth = view().camera().azimuth();
    drag(&view(), {200, 40}, {260, 60}, Qt::ShiftModifier);
    QCOMPARE(view().camera().azimuth(), azimuth); // the camera stays
    drag(&view(), {200, 40}, {260, 60});
    QVERIFY(view().camera().azimuth() != azimuth);
    QVERIFY(!m_fixture->find<QLabel>("ruler")->isVisible());
}

// A board of 6 m: the ball's own size is about a pixel.
void TestWindowCamera::smallBallIsDrawnLargeEnough() {
    openMaze("box -3 -3 -0.01 3 3 0\n");
    QTRY_COMPARE(ball().position.x, 0.0);
    const QImage with = view().grabFramebuffer();
    const QPoint middle = pixelOf(0.0, 0.0, ball().position.z).toPoint();
    const QColor floor = with.pixelColor(middle + QPoint(30, 0));
    int wide = 0;
    for (int x = -10; x <= 10; ++x) {
        const QColor colour = with.pixelColor(middle + QPoint(x, 0));
        const int off = std::abs(colour.red() - floor.red()) + std::abs(colour.green() - floor.green()) +
                        std::abs(colour.blue() - floor.blue());
        if (off > 60) ++wide;
    }
    QVERIFY2(wide >= 4 && wide <= 10, qPrintable(QString::number(wide)));
}

void TestWindowCamera::ownMazeShowsItsExit() {
    openMaze(
        "box -0.05 -0.05 -0.01 0.05 0.05 0\nbox -0.05 -0.05 0 -0.045 0.05 0.02\nbox -0.05 -0.05 0 0.05 -0.045 0.02\n"
        "box -0.05 0.045 0 0.05 0.05 0.02\n");
    const inspector::gl::Mesh mesh = inspector::ui::mazeMesh(m_fixture->session(), nullptr);
    const auto shines = [](const inspector::gl::Vertex &vertex) { return vertex.surface.a > 0; };
    QVERIFY(std::any_of(mesh.vertices.begin(), mesh.vertices.end(), shines));
    for (const inspector::gl::Vertex &vertex : mesh.vertices)
        if (shines(vertex)) QVERIFY(vertex.position.x > 0.03F); // at the open side
}

void TestWindowCamera::keysMoveTheCamera_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("back");
    QTest::newRow("right, left") << int(Qt::Key_Right) << int(Qt::Key_Left);
    QTest::newRow("lower, higher") << int(Qt::Key_Down) << int(Qt::Key_Up);
    QTest::newRow("nearer, farther") << int(Qt::Key_Plus) << int(Qt::Key_Minus);
}

void TestWindowCamera::keysMoveTheCamera() {
    QFETCH(int, key);
    QFETCH(int, back);
    const inspector::gl::OrbitCamera &camera = view().camera();
    const glm::dvec3 start = camera.eye();
    m_fixture->key(Qt::Key(key), Qt::AltModifier);
    const double moved = glm::length(camera.eye() - start);
    QVERIFY(moved > 0.01 * camera.distance());
    m_fixture->key(Qt::Key(back), Qt::AltModifier);
    QVERIFY(glm::length(camera.eye() - start) < 1e-9 * moved);
    QVERIFY(!m_fixture->session().isTiltedByKeys());
}

QTEST_MAIN(TestWindowCamera)
#include "tst_window_camera.moc"
