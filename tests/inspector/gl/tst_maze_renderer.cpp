// SPDX-License-Identifier: MIT
// Pixels of a small maze: requirements that don't depend on the choice of colours.
#include "offscreen_picture.h"

#include "mesh/mesh_builder.h"

#include <cmath>

#include <QTest>

using namespace inspector::gl;

namespace {

Frame frameWithBallAt(double x, double y) {
    Frame frame;
    frame.ball.position = {x, y, frame.ball.radius};
    return frame;
}

// Far away: a picture without the ball.
Frame frameWithoutBall() { return frameWithBallAt(0.0, 50.0); }

int difference(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

// More than dithering and the wood's grain can account for.
constexpr int kVisible = 24;

int changedPixels(const QImage &a, const QImage &b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) count += difference(a.pixel(x, y), b.pixel(x, y)) > kVisible;
    }
    return count;
}

// Mean brightness of 3 x 3 pixels, which averages the grain out.
double brightness(const QImage &image, const QPoint &centre) {
    int sum = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) sum += qGray(image.pixel(centre + QPoint(dx, dy)));
    }
    return sum / 9.0;
}

} // namespace

class TestMazeRenderer : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_picture = std::make_unique<OffscreenPicture>();
        if (!m_picture->isReady()) QSKIP(qPrintable(m_picture->problem()));
    }

    void cleanup() { m_picture.reset(); }

    void boardStandsOutFromTheBackdrop_data() { qualityRows(); }
    void boardStandsOutFromTheBackdrop() {
        QFETCH(Quality, quality);
        const QImage image = m_picture->draw(frameWithoutBall(), quality);
        const QRgb floor = image.pixel(m_picture->pixelOf({0.05, 0.0, 0.0}));
        QVERIFY(difference(floor, image.pixel(2, 2)) > kVisible);
        QVERIFY(qRed(floor) > qBlue(floor) + kVisible); // wood is warm
    }

    // The table is brightest below the middle of the picture.
    void mazeWithoutBoxesCastsNoShadow() {
        m_picture->renderer().setMaze({});
        const QImage image = m_picture->draw(frameWithoutBall(), Quality::Medium);
        const QPoint middle = m_picture->pixelOf({0.0, 0.0, 0.0});
        QVERIFY(brightness(image, middle) >= brightness(image, {middle.x(), image.height() - 3}));
    }

    void sameFrameGivesTheSamePixels_data() { qualityRows(); }
    void sameFrameGivesTheSamePixels() {
        QFETCH(Quality, quality);
        const QImage first = m_picture->draw(frameWithBallAt(0.04, 0.02), quality);
        m_picture->draw(frameWithBallAt(-0.04, 0.01), quality);
        QCOMPARE(m_picture->draw(frameWithBallAt(0.04, 0.02), quality), first);
    }

    // The static part is cached, and what moves is drawn over it.
    void partsMakeTheWholePicture_data() {
        QTest::addColumn<Quality>("quality");
        QTest::addColumn<glm::dvec3>("ball");
        QTest::addColumn<double>("tilt");
        for (const auto &[name, quality] :
             {std::pair("low", Quality::Low), {"medium", Quality::Medium}, {"high", Quality::High}}) {
            QTest::addRow("%s, on the floor", name) << quality << glm::dvec3(0.04, 0.02, 0.006) << 0.0;
            QTest::addRow("%s, at a wall", name) << quality << glm::dvec3(0.0087, 0.02, 0.006) << 0.1;
            QTest::addRow("%s, in a corner", name) << quality << glm::dvec3(0.089, -0.069, 0.006) << -0.1;
            QTest::addRow("%s, in the air", name) << quality << glm::dvec3(0.02, 0.0, 0.09) << 0.1;
            QTest::addRow("%s, far away", name) << quality << glm::dvec3(0.0, 50.0, 0.0) << 0.0;
            QTest::addRow("%s, on a steep board", name) << quality << glm::dvec3(0.04, 0.02, 0.006) << 1.2;
        }
    }

    void partsMakeTheWholePicture() {
        QFETCH(Quality, quality);
        QFETCH(glm::dvec3, ball);
        QFETCH(double, tilt);
        Frame frame;
        frame.ball.position = ball;
        frame.tiltX = tilt;
        frame.ghosts.push_back({{{0.02, -0.03, 0.006}}, Colour(0.2F, 0.5F, 1.0F, 0.5F)});
        frame.trails.push_back({{{-0.05, 0.0, 0.006}, {0.0, 0.06, 0.006}, ball}, Colour(1.0F, 0.5F, 0.0F, 0.9F), 3.0F});
        const QImage whole = m_picture->draw(frame, quality);
        QCOMPARE(m_picture->drawInParts(frame, quality), whole);
    }

    void otherBallStandsStillOtherTiltDoesNot() {
        const MazeRenderer::StaticScene staticScene =
            m_picture->staticSceneOf(frameWithBallAt(0.04, 0.02), Quality::Low);
        QVERIFY(m_picture->staticSceneOf(frameWithBallAt(-0.04, 0.01), Quality::Low) == staticScene);
        QVERIFY(m_picture->staticSceneOf(frameWithBallAt(0.04, 0.02), Quality::Medium) != staticScene);
        Frame tilted = frameWithBallAt(0.04, 0.02);
        tilted.tiltY = 1e-6;
        QVERIFY(m_picture->staticSceneOf(tilted, Quality::Low) != staticScene);
    }

    void ballIsDrawnWhereTheCameraProjectsIt_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("near right") << 0.06 << -0.05;
        QTest::newRow("far left") << -0.07 << 0.04;
    }

    void ballIsDrawnWhereTheCameraProjectsIt() {
        QFETCH(double, x);
        QFETCH(double, y);
        const QImage empty = m_picture->draw(frameWithoutBall(), Quality::Low);
        const Frame frame = frameWithBallAt(x, y);
        const QImage image = m_picture->draw(frame, Quality::Low);
        const glm::dvec3 centre = frame.ball.position;
        const QPoint middle = m_picture->pixelOf(centre);
        QVERIFY(difference(image.pixel(middle), empty.pixel(middle)) > kVisible);
        // Towards the light, where there is no shadow: pixels inside the radius change, those outside don't.
        const QPoint inside = m_picture->pixelOf(centre + glm::dvec3(-0.7 * frame.ball.radius, 0.0, 0.0));
        const QPoint outside = m_picture->pixelOf(centre + glm::dvec3(-2.0 * frame.ball.radius, 0.0, 0.0));
        QVERIFY(difference(image.pixel(inside), empty.pixel(inside)) > kVisible);
        QVERIFY(difference(image.pixel(outside), empty.pixel(outside)) <= kVisible);
    }

    void turningTheBallChangesItsPixelsAndNoOthers() {
        Frame frame = frameWithBallAt(0.05, -0.02);
        const QImage before = m_picture->draw(frame);
        frame.ball.orientation = {0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5)}; // a quarter turn about y
        const QImage after = m_picture->draw(frame);
        QVERIFY(changedPixels(before, after) > 10);
        const QPoint middle = m_picture->pixelOf(frame.ball.position);
        const int reach =
            2 + middle.x() - m_picture->pixelOf(frame.ball.position - glm::dvec3(frame.ball.radius, 0, 0)).x();
        for (int y = 0; y < before.height(); ++y) {
            for (int x = 0; x < before.width(); ++x) {
                if (std::hypot(x - middle.x(), y - middle.y()) > reach) QCOMPARE(after.pixel(x, y), before.pixel(x, y));
            }
        }
    }

    void wallThrowsAShadow_data() {
        QTest::addColumn<Quality>("quality");
        QTest::newRow("medium") << Quality::Medium;
        QTest::newRow("high") << Quality::High;
    }

    // The light comes from -x: 6 mm behind the 14 mm high wall it is dark, 6 mm before it isn't.
    void wallThrowsAShadow() {
        QFETCH(Quality, quality);
        const QImage image = m_picture->draw(frameWithoutBall(), quality);
        const double shaded = brightness(image, m_picture->pixelOf({0.0025 + 0.006, 0.0, 0.0}));
        const double lit = brightness(image, m_picture->pixelOf({-0.0025 - 0.006, 0.0, 0.0}));
        QVERIFY2(shaded < 0.75 * lit, qPrintable(QStringLiteral("shaded %1, lit %2").arg(shaded).arg(lit)));
    }

    void lowQualityDrawsNoShadowOfTheWall() {
        const QImage image = m_picture->draw(frameWithoutBall(), Quality::Low);
        const double behind = brightness(image, m_picture->pixelOf({0.0025 + 0.009, 0.0, 0.0}));
        const double before = brightness(image, m_picture->pixelOf({-0.0025 - 0.009, 0.0, 0.0}));
        QVERIFY(std::abs(behind - before) < 0.15 * before);
    }

    void ballThrowsAShadow() {
        const Frame frame = frameWithBallAt(0.05, 0.0);
        const QImage empty = m_picture->draw(frameWithoutBall());
        const QImage image = m_picture->draw(frame);
        // Away from the light (-0.52, 0.34, 0.78) by the shadow of the ball's centre.
        const glm::dvec3 shadow(0.05 + 0.006 * 0.52 / 0.78, -0.006 * 0.34 / 0.78, 0.0);
        const glm::dvec3 edge = shadow + glm::dvec3(0.006, -0.004, 0.0);
        QVERIFY(brightness(image, m_picture->pixelOf(edge)) < 0.85 * brightness(empty, m_picture->pixelOf(edge)));
    }

    void tiltMovesThePicture() {
        Frame frame = frameWithoutBall();
        const QImage level = m_picture->draw(frame);
        frame.tiltX = 0.15;
        QVERIFY(changedPixels(level, m_picture->draw(frame)) >
                OffscreenPicture::kWidth * OffscreenPicture::kHeight / 20);
    }

    void tiltedBoardSinksWhereTheBallRunsTo() {
        // Seen level with the board, the +x rim goes down and the -x rim up, so that rim becomes backdrop and vice
        // versa.
        Frame frame = frameWithoutBall();
        m_picture->camera().orbit({0.0, -1e6});
        const QPoint right = m_picture->pixelOf({0.0975, -0.08, 0.004});
        const QPoint below = m_picture->pixelOf({0.0975, -0.08, -0.012});
        const QRgb rim = m_picture->draw(frame, Quality::Low).pixel(right);
        frame.tiltX = 0.16; // 16 mm at the rim
        const QImage tilted = m_picture->draw(frame, Quality::Low);
        QVERIFY(difference(tilted.pixel(below), rim) < difference(tilted.pixel(right), rim));
    }

    void ghostIsTranslucent() {
        Frame frame = frameWithoutBall();
        const QImage empty = m_picture->draw(frame);
        const Frame solid = frameWithBallAt(0.05, 0.0);
        const QImage opaque = m_picture->draw(solid);
        frame.ghosts.push_back({solid.ball, {0.2F, 0.4F, 1.0F, 0.5F}});
        const QImage image = m_picture->draw(frame);
        const QPoint middle = m_picture->pixelOf(solid.ball.position);
        QVERIFY(difference(image.pixel(middle), empty.pixel(middle)) > kVisible);
        QVERIFY(difference(image.pixel(middle), opaque.pixel(middle)) > kVisible);
    }

    void trailIsDrawnInItsColourAndFadesTowardsItsOldEnd() {
        Frame frame = frameWithoutBall();
        const QImage empty = m_picture->draw(frame);
        Trail trail;
        trail.colour = {0.0F, 0.0F, 1.0F, 1.0F};
        trail.width = 4.0F;
        for (int i = 0; i <= 100; ++i) trail.points.emplace_back(0.02 + 0.0006 * i, 0.0, 0.0);
        frame.trails.push_back(trail);
        const QImage image = m_picture->draw(frame);
        const QPoint newest = m_picture->pixelOf(trail.points[97]);
        const QPoint oldest = m_picture->pixelOf(trail.points[3]);
        QVERIFY(qBlue(image.pixel(newest)) > 230 && qRed(image.pixel(newest)) < 40);
        QVERIFY(difference(image.pixel(oldest), empty.pixel(oldest)) <
                difference(image.pixel(newest), empty.pixel(newest)) / 4);
    }

    void pointIsADiscOfItsDiameter() {
        Frame frame = frameWithoutBall();
        const QImage empty = m_picture->draw(frame);
        frame.strokes.point({0.05, 0.0, 0.0}, {1.0F, 0.0F, 0.0F, 1.0F}, 20.0F);
        // pi 10^2, and a ring of half-covered pixels around it
        const int count = changedPixels(empty, m_picture->draw(frame));
        QVERIFY2(count > 300 && count < 380, qPrintable(QString::number(count)));
    }

    void strokeBehindAWallShinesThroughFaintly() {
        Frame frame = frameWithoutBall();
        const QImage empty = m_picture->draw(frame);
        const glm::dvec3 hidden(0.05, -0.0745, -0.003); // inside the near rim
        frame.strokes.point(hidden, {0.0F, 1.0F, 0.0F, 1.0F}, 12.0F);
        const QImage image = m_picture->draw(frame);
        const QPoint pixel = m_picture->pixelOf(hidden);
        QVERIFY(difference(image.pixel(pixel), empty.pixel(pixel)) > kVisible);
        QVERIFY(qGreen(image.pixel(pixel)) < 200);
    }

    void exitGlowsOnTheFloorAroundIt() {
        const MazeBox boxes[] = {{{-0.1, -0.08, -0.005}, {0.1, 0.08, 0.0}, BoxKind::Floor},
                                 {{0.1, -0.02, -0.005}, {0.105, 0.02, 0.0}, BoxKind::Exit}};
        m_picture->renderer().setMaze(mazeFromBoxes(std::span(boxes, 1)));
        const QColor plain =
            m_picture->draw(frameWithoutBall(), Quality::Low).pixelColor(m_picture->pixelOf({0.09, 0, 0}));
        m_picture->renderer().setMaze(mazeFromBoxes(boxes));
        const QColor glowing =
            m_picture->draw(frameWithoutBall(), Quality::Low).pixelColor(m_picture->pixelOf({0.09, 0, 0}));
        QVERIFY(glowing.green() - plain.green() > glowing.red() - plain.red() + 5);
    }

    void emptyMazeDrawsTheBackdrop() {
        m_picture->renderer().setMaze({});
        const QImage image = m_picture->draw(frameWithoutBall());
        QVERIFY(qGray(image.pixel(2, 2)) > 100);
    }

private:
    static void qualityRows() {
        QTest::addColumn<Quality>("quality");
        QTest::newRow("low") << Quality::Low;
        QTest::newRow("medium") << Quality::Medium;
        QTest::newRow("high") << Quality::High;
    }

    std::unique_ptr<OffscreenPicture> m_picture;
};

QTEST_MAIN(TestMazeRenderer)
#include "tst_maze_renderer.moc"
