// SPDX-License-Identifier: MIT
// The widget with real mouse events.
#include "gl/surface_format.h"
#include "gl/view/maze_view.h"
#include "mesh/mesh_builder.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <glm/geometric.hpp>

using namespace inspector::gl;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

Mesh plainBoard(double half_width) {
    const MazeBox boxes[] = {{{-half_width, -0.08, -0.005}, {half_width, 0.08, 0.0}, BoxKind::Floor}};
    return mazeFromBoxes(boxes);
}

void drag(QWidget *widget, Qt::MouseButton button, const QPoint &from, const QPoint &to) {
    QTest::mousePress(widget, button, {}, from);
    // QTest::mouseMove carries no buttons, so the moves are sent as the platform would.
    for (const QPoint &place : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button, Qt::NoModifier);
        QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, button, {}, to);
}

void turnWheelAt(QWidget *widget, const QPoint &place, int notches) {
    QWheelEvent wheel(place, widget->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
}

} // namespace

class TestMazeView : public QObject {
    Q_OBJECT

public:
    static void initMain() { QSurfaceFormat::setDefaultFormat(surfaceFormat()); }

private slots:
    void initTestCase_data() {
        QTest::addColumn<Drawing>("drawing");
        QTest::newRow("onto the screen") << Drawing::Screen;
        QTest::newRow("into a picture") << Drawing::Picture;
    }

    void init() {
        QFETCH_GLOBAL(Drawing, drawing);
        m_view = std::make_unique<MazeView>(drawing);
        m_view->resize(kWidth, kHeight);
        m_view->setMaze(plainBoard(0.1));
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        QTRY_VERIFY(m_view->lastFrameMilliseconds() > 0.0);
    }

    void cleanup() { m_view.reset(); }

    void softwareRendererDrawsIntoAPicture() {
        if (!m_view->rendererName().contains("llvmpipe")) QSKIP("not a software renderer");
        QCOMPARE(MazeView().drawing(), Drawing::Picture);
    }

    void bothWaysGiveTheSamePixels() {
        MazeView other(m_view->drawing() == Drawing::Screen ? Drawing::Picture : Drawing::Screen);
        other.resize(kWidth, kHeight);
        other.setMaze(plainBoard(0.1));
        other.show();
        QTRY_VERIFY(other.lastFrameMilliseconds() > 0.0);
        for (const Quality quality : {Quality::Low, Quality::High}) {
            for (MazeView *view : {m_view.get(), &other}) view->setQuality(quality);
            const QImage here = m_view->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
            QCOMPARE(other.grabFramebuffer().convertToFormat(QImage::Format_RGB32), here);
        }
    }

    void standingBoardIsCopied() {
        showFrame({});
        m_frame.ball.position = {0.02, 0.01, 0.006};
        const QImage drawn = m_view->grabFramebuffer();
        QCOMPARE(m_view->grabFramebuffer(), drawn); // now board and table are copies
        m_frame.ball.position = {-0.05, 0.01, 0.006};
        const QImage moved = m_view->grabFramebuffer();
        QVERIFY(moved != drawn);
        m_frame.ball.position = {0.02, 0.01, 0.006};
        QCOMPARE(m_view->grabFramebuffer(), drawn);
    }

    void softwareRendererStartsWithMediumQuality() {
        if (!m_view->rendererName().contains("llvmpipe")) QSKIP("not a software renderer");
        QCOMPARE(m_view->quality(), Quality::Medium);
    }

    void boardIsOnTheScreen() {
        const QImage image = m_view->grabFramebuffer();
        const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
        QVERIFY(middle.red() > middle.blue() + 20); // wood
    }

    void everyQualityDraws() {
        for (const Quality quality : {Quality::Low, Quality::Medium, Quality::High}) {
            m_view->setQuality(quality);
            const QImage image = m_view->grabFramebuffer();
            const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
            QVERIFY(middle.red() > middle.blue() + 20);
        }
    }

    void darkPaletteDarkensTheBackdrop() {
        QPalette palette;
        palette.setColor(QPalette::Window, QColor(40, 40, 44));
        const int light = qGray(m_view->grabFramebuffer().pixel(2, 2));
        m_view->setPalette(palette);
        QVERIFY(qGray(m_view->grabFramebuffer().pixel(2, 2)) < light / 2);
    }

    void leftDragOrbits() {
        const double azimuth = m_view->camera().azimuth();
        const glm::dvec3 target = m_view->camera().target();
        drag(m_view.get(), Qt::LeftButton, {160, 120}, {220, 120});
        QVERIFY(m_view->camera().azimuth() < azimuth);
        QVERIFY(m_view->camera().target() == target);
    }

    void otherDragPans_data() {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::newRow("right") << Qt::RightButton;
        QTest::newRow("middle") << Qt::MiddleButton;
    }

    void otherDragPans() {
        QFETCH(Qt::MouseButton, button);
        const double azimuth = m_view->camera().azimuth();
        const QPointF before = m_view->positionOf({0.0, 0.0, 0.0});
        drag(m_view.get(), button, {160, 120}, {180, 135});
        QCOMPARE(m_view->camera().azimuth(), azimuth);
        const QPointF moved = m_view->positionOf({0.0, 0.0, 0.0}) - before;
        // The floor's middle lies near the target's plane, so that it follows the hand to a pixel.
        QVERIFY((moved - QPointF(20.0, 15.0)).manhattanLength() < 1.0);
    }

    void wheelZooms() {
        const double distance = m_view->camera().distance();
        turnWheelAt(m_view.get(), {160, 120}, 1);
        QVERIFY(m_view->camera().distance() < distance);
        turnWheelAt(m_view.get(), {160, 120}, -1);
        QCOMPARE(m_view->camera().distance(), distance);
    }

    void doubleClickShowsEverythingAgain() {
        const glm::dvec3 eye = m_view->camera().eye();
        drag(m_view.get(), Qt::LeftButton, {160, 120}, {220, 180});
        turnWheelAt(m_view.get(), {100, 60}, 3);
        QVERIFY(glm::distance(m_view->camera().eye(), eye) > 0.01);
        QTest::mouseDClick(m_view.get(), Qt::LeftButton);
        QVERIFY(glm::distance(m_view->camera().eye(), eye) < 1e-12);
    }

    void clickGivesTheRayThroughTheBoardPoint() {
        Frame frame;
        frame.tiltX = 0.1;
        showFrame(frame);
        m_view->grabFramebuffer();
        const glm::dvec3 place(0.04, -0.03, 0.0);
        const QPoint pixel = m_view->positionOf(place).toPoint();
        QSignalSpy clicked(m_view.get(), &MazeView::clicked);
        QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, pixel);
        QCOMPARE(clicked.size(), 1);
        const Ray ray = clicked[0][0].value<Ray>();
        const glm::dvec3 hit = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
        QVERIFY(glm::distance(hit, place) < 0.002); // half a pixel is less than a millimetre here
    }

    void dragIsNoClick() {
        QSignalSpy clicked(m_view.get(), &MazeView::clicked);
        drag(m_view.get(), Qt::LeftButton, {160, 120}, {220, 120});
        QVERIFY(clicked.isEmpty());
    }

    void keysAreLeftToTheWindow() {
        QKeyEvent key(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier);
        QApplication::sendEvent(m_view.get(), &key);
        QVERIFY(!key.isAccepted());
    }

    void frameSourceIsAskedForEachPicture() {
        int asked = 0;
        m_view->setFrameSource([&asked] { return ++asked, Frame{}; });
        QTRY_VERIFY(asked >= 3);
        m_view->setFrameSource(nullptr);
    }

    void resizedViewShowsEverythingUntilTheCameraIsMoved() {
        const double start = m_view->camera().distance();
        m_view->resize(kWidth / 2, kHeight);
        QTRY_VERIFY(m_view->camera().distance() > 1.5 * start); // half as wide: about twice as far
        m_view->resize(kWidth, kHeight);
        QTRY_COMPARE(m_view->camera().distance(), start);
        turnWheelAt(m_view.get(), {160, 120}, 2);
        const double chosen = m_view->camera().distance();
        m_view->resize(kWidth / 2, kHeight);
        QTRY_COMPARE(m_view->grabFramebuffer().width(), kWidth / 2);
        QCOMPARE(m_view->camera().distance(), chosen);
    }

    void otherMazeIsShownWhole() {
        const double distance = m_view->camera().distance();
        m_view->setMaze(plainBoard(0.3));
        QVERIFY(m_view->camera().distance() > 2.0 * distance);
    }

    void survivesBeingMovedToAnotherWindow() {
        QWidget window;
        window.resize(kWidth, kHeight);
        m_view->setParent(&window);
        m_view->show();
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QImage image = m_view->grabFramebuffer();
        const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
        QVERIFY(middle.red() > middle.blue() + 20);
        m_view->setParent(nullptr);
    }

private:
    // Every later picture shows m_frame.
    void showFrame(const Frame &frame) {
        m_frame = frame;
        m_view->setFrameSource([this] { return m_frame; }, [] { return false; });
    }

    std::unique_ptr<MazeView> m_view;
    Frame m_frame;
};

QTEST_MAIN(TestMazeView)
#include "tst_maze_view.moc"
