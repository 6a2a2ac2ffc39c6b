// SPDX-License-Identifier: MIT
// The camera's arithmetic and the board's pose, without a screen.
#include "gl/board_pose.h"
#include "gl/orbit_camera.h"
#include "inspector/camera_elevation.h"
#include "support/compare.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace inspector::gl;

namespace {

// Doubles through a dozen products of size 1: some units in the last place.
constexpr double kRounding = 1e-12;
// The same for pixels, which are a thousand times as large.
constexpr double kPixelRounding = 1e-8;

const Bounds kBoard{{-0.10, -0.08, -0.005}, {0.10, 0.08, 0.014}};

OrbitCamera boardCamera() {
    OrbitCamera camera;
    camera.setViewport({800.0, 600.0});
    camera.setBounds(kBoard, 0.0);
    camera.reset();
    return camera;
}

constexpr double kLargestTilt = 0.15; // rad

std::vector<glm::dvec3> corners() {
    std::vector<glm::dvec3> result;
    result.reserve(8);
    for (int i = 0; i < 8; ++i)
        result.emplace_back(i & 1 ? kBoard.maximum.x : kBoard.minimum.x, i & 2 ? kBoard.maximum.y : kBoard.minimum.y,
                            i & 4 ? kBoard.maximum.z : kBoard.minimum.z);
    return result;
}

// How far a board of this tilt reaches from the middle of the picture: 1 is the edge, in width or height.
double filledShare(const OrbitCamera &camera, const glm::dvec2 &viewport, double tiltX, double tiltY) {
    const glm::dmat4 pose = boardToWorld(tiltX, tiltY, boardPivot(kBoard));
    double share = 0.0;
    for (const glm::dvec3 &corner : corners()) {
        const glm::dvec2 pixel = camera.project(glm::dvec3(pose * glm::dvec4(corner, 1.0)));
        const glm::dvec2 reach = glm::abs(2.0 * pixel / viewport - 1.0);
        share = std::max({share, reach.x, reach.y});
    }
    return share;
}

// Where the ray meets the plane z = 0.
glm::dvec3 onFloor(const Ray &ray) { return ray.origin - ray.direction * (ray.origin.z / ray.direction.z); }

bool isNear(const glm::dvec3 &a, const glm::dvec3 &b, double tolerance) { return glm::distance(a, b) <= tolerance; }
bool isNear(const glm::dvec2 &a, const glm::dvec2 &b, double tolerance) { return glm::distance(a, b) <= tolerance; }

} // namespace

class TestOrbitCamera : public QObject {
    Q_OBJECT

private slots:
    void targetIsDrawnInTheMiddle() {
        const OrbitCamera camera = boardCamera();
        QVERIFY(isNear(camera.project(camera.target()), {400.0, 300.0}, kPixelRounding));
    }

    void viewIsARigidMotion() {
        const glm::dmat3 rotation(boardCamera().view());
        const glm::dmat3 product = rotation * glm::transpose(rotation);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) QVERIFY(std::abs(product[i][j] - (i == j)) <= kRounding);
        }
        QVERIFY(std::abs(glm::determinant(rotation) - 1.0) <= kRounding);
    }

    void startHasXToTheRightAndYUp() {
        const OrbitCamera camera = boardCamera();
        const glm::dvec2 origin = camera.project({0.0, 0.0, 0.0});
        QVERIFY(camera.project({0.01, 0.0, 0.0}).x > origin.x + 1.0);
        QVERIFY(camera.project({0.0, 0.01, 0.0}).y < origin.y - 1.0);
    }

    void rayAndProjectionAreInverse() {
        const OrbitCamera camera = boardCamera();
        for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(123, 456), glm::dvec2(799, 599)})
            QVERIFY(isNear(camera.project(onFloor(camera.ray(pixel))), pixel, kPixelRounding));
    }

    void pickRayIsInTheFrameOfTheTiltedBoard() {
        const OrbitCamera camera = boardCamera();
        const glm::dmat4 pose = boardToWorld(0.2, -0.1, kBoard.centre());
        const glm::dvec3 place(0.03, -0.02, 0.0); // on the floor
        const glm::dvec2 pixel = camera.project(glm::dvec3(pose * glm::dvec4(place, 1.0)));
        QVERIFY(isNear(onFloor(camera.pickRay(pixel, pose)), place, kRounding));
    }

    void resetShowsAllOfTheBounds_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::newRow("wide") << 1600.0 << 400.0;
        QTest::newRow("tall") << 300.0 << 900.0;
        QTest::newRow("usual") << 1280.0 << 800.0;
    }

    void resetShowsAllOfTheBounds() {
        QFETCH(double, width);
        QFETCH(double, height);
        OrbitCamera camera;
        camera.setViewport({width, height});
        camera.setBounds(kBoard, 0.0);
        camera.reset();
        QVERIFY(std::abs(filledShare(camera, {width, height}, 0.0, 0.0) - 0.95) <= kRounding);
    }

    void tiltedBoardStaysInThePicture_data() { resetShowsAllOfTheBounds_data(); }

    // Any tilt within the largest one leaves hardly less margin than the tilts that the camera considers (a corner may
    // be farthest out just before full tilt, where its path turns), and the camera is no farther away than needed.
    void tiltedBoardStaysInThePicture() {
        QFETCH(double, width);
        QFETCH(double, height);
        OrbitCamera camera;
        camera.setViewport({width, height});
        camera.setBounds(kBoard, kLargestTilt);
        camera.reset();
        double most = 0.0;
        for (int i = -8; i <= 8; ++i) {
            for (int j = -8; j <= 8; ++j) {
                const double share = filledShare(camera, {width, height}, kLargestTilt * i / 8, kLargestTilt * j / 8);
                most = std::max(most, share);
            }
        }
        QVERIFY2(most >= 0.95 - kRounding && most < 0.96, qPrintable(QString::number(most, 'g', 17)));
    }

    void zoomKeepsThePointUnderTheCursor() {
        OrbitCamera camera = boardCamera();
        const glm::dvec2 cursor(520.0, 350.0);
        // The plane that is zoomed is the one through the target perpendicular to the view.
        const auto under_cursor = [&] {
            const Ray ray = camera.ray(cursor);
            const glm::dvec3 back = glm::normalize(camera.eye() - camera.target());
            return ray.origin +
                   ray.direction * (glm::dot(camera.target() - ray.origin, back) / glm::dot(ray.direction, back));
        };
        const glm::dvec3 before = under_cursor();
        const double distance = camera.distance();
        camera.zoom(2.0, cursor);
        QVERIFY(camera.distance() < distance);
        QVERIFY(isNear(under_cursor(), before, kRounding));
    }

    void zoomBackUndoesZoom() {
        OrbitCamera camera = boardCamera();
        const glm::dvec3 eye = camera.eye();
        camera.zoom(1.5, {100.0, 50.0});
        camera.zoom(-1.5, {100.0, 50.0});
        QVERIFY(isNear(camera.eye(), eye, kRounding));
    }

    void panMovesThePictureWithTheHand() {
        OrbitCamera camera = boardCamera();
        const glm::dvec3 grabbed = camera.target();
        camera.pan({60.0, -25.0});
        QVERIFY(isNear(camera.project(grabbed), {460.0, 275.0}, kPixelRounding));
    }

    void orbitTurnsAboutTheTarget() {
        OrbitCamera camera = boardCamera();
        const glm::dvec3 target = camera.target();
        const double distance = camera.distance();
        camera.orbit({70.0, 20.0});
        QCOMPARE(camera.distance(), distance);
        QVERIFY(isNear(camera.target(), target, 0.0));
        QVERIFY(support::elevationOf(camera) > OrbitCamera::kStartElevation);
        QVERIFY(camera.azimuth() < OrbitCamera::kStartAzimuth);
    }

    void elevationStaysBetweenItsLimits() {
        OrbitCamera camera = boardCamera();
        camera.orbit({0.0, 1e6});
        COMPARE_WITHIN(support::elevationOf(camera), OrbitCamera::kMaxElevation, support::kElevationRounding);
        camera.orbit({0.0, -1e6});
        COMPARE_WITHIN(support::elevationOf(camera), OrbitCamera::kMinElevation, support::kElevationRounding);
    }

    void straightFromAboveIsAGoodView() {
        OrbitCamera camera = boardCamera();
        camera.orbit({0.0, 1e6});
        const glm::dvec2 origin = camera.project({0.0, 0.0, 0.0});
        const glm::dvec2 along_x = camera.project({0.01, 0.0, 0.0}) - origin;
        const glm::dvec2 along_y = camera.project({0.0, 0.01, 0.0}) - origin;
        QVERIFY(std::abs(along_x.y) <= kPixelRounding && std::abs(along_y.x) <= kPixelRounding);
        QVERIFY(std::abs(along_x.x + along_y.y) <= kPixelRounding); // a square stays one
    }

    void distanceStaysBetweenItsLimits() {
        OrbitCamera camera = boardCamera();
        const double radius = 0.5 * glm::length(kBoard.size());
        camera.zoom(1e3, {400.0, 300.0});
        QCOMPARE(camera.distance(), 0.15 * radius);
        camera.zoom(-1e3, {400.0, 300.0});
        QCOMPARE(camera.distance(), 12.0 * radius);
    }

    void whateverIsDoneTheTargetStaysNearTheBoard() {
        OrbitCamera camera = boardCamera();
        for (int i = 0; i < 100; ++i) camera.pan({500.0, 300.0});
        const glm::dvec3 offset = glm::abs(camera.target() - kBoard.centre());
        const double reach = 0.5 * glm::length(kBoard.size());
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(offset[axis] <= 0.5 * kBoard.size()[axis] + 0.5 * reach + kRounding);
    }

    void boundsLieBetweenNearAndFarPlane() {
        OrbitCamera camera = boardCamera();
        for (const double steps : {-8.0, 4.0, 4.0, 4.0}) {
            camera.zoom(steps, {400.0, 300.0});
            const glm::dvec4 clip = camera.projection() * camera.view() * glm::dvec4(camera.target(), 1.0);
            QVERIFY(std::abs(clip.z) < clip.w);
        }
    }

    void downIsWhereGravityPullsOnATiltedBoard() {
        const double tiltX = 0.15;
        const double tiltY = -0.09;
        const glm::dmat3 turn(boardToWorld(tiltX, tiltY, {0.01, 0.02, 0.0}));
        const glm::dvec3 down = glm::transpose(turn) * glm::dvec3(0.0, 0.0, -1.0);
        QVERIFY(isNear(down, glm::normalize(glm::dvec3(std::tan(tiltX), std::tan(tiltY), -1.0)), kRounding));
    }

    void pivotOfATiltedBoardStaysInPlace() {
        const glm::dvec3 pivot(0.01, 0.02, 0.0);
        QVERIFY(isNear(glm::dvec3(boardToWorld(0.2, 0.1, pivot) * glm::dvec4(pivot, 1.0)), pivot, kRounding));
    }
};

QTEST_GUILESS_MAIN(TestOrbitCamera)
#include "tst_orbit_camera.moc"
