// SPDX-License-Identifier: MIT
// The window without OpenGL: the board from above, drawn by QPainter, with all features.
#include "inspector/camera_elevation.h"
#include "support/compare.h"
#include "ui/parts/message_bar.h"
#include "window_fixture.h"

#include <QDockWidget>
#include <QFile>

#include <set>

using namespace window_test;

class TestWindowFlat : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void ballIsDrawnWhereItIs();
    void wallIsDarkerThanTheFloor();
    void boardTiltsInThePicture();
    void levelIsPlayedByArrowKeys();
    void draggedBallIsWhereTheMouseIs();
    void dragTurnsTheBoardAndStaysAbove();
    void ghostAndTrailsAreDrawn();
    void everyDockOpens();
    void pictureIsSavedAtAnySize();
    void themeIsTheTables();
    void lowQualityLeavesEdgesJagged();

private:
    inspector::gl::MazeView &view() { return m_fixture->window().view(); }
    phys_state ball() { return m_fixture->simulation().latest().current; }
    QPoint pixelOf(const phys_vec3 &point) { return view().positionOf({point.x, point.y, point.z}).toPoint(); }
    QColor colourAt(const QPoint &pixel) { return view().grabFramebuffer().pixelColor(pixel); }
};

void TestWindowFlat::init() {
    QVERIFY(open(3));
    QCOMPARE(view().rendererName(), QString("QPainter, from above"));
}

// Red or grey rather than the colour of wood: a red spot is as likely as the grey between.
void TestWindowFlat::ballIsDrawnWhereItIs() {
    const auto isWood = [this](const QPoint &pixel) {
        const QColor colour = colourAt(pixel);
        return colour.red() > colour.green() && colour.green() > colour.blue() + 20;
    };
    const phys_vec3 start = ball().position;
    QVERIFY(!isWood(pixelOf(start)));
    QVERIFY(isWood(pixelOf({start.x, start.y + 0.02, 0.0})));
    m_fixture->parameters().set({{"tilt_y", 8.0}});
    m_fixture->makeSteps(40);
    QVERIFY(ball().position.y > start.y + 0.02);
    m_fixture->parameters().set({{"tilt_y", 0.0}}); // a level board, so that both are compared under the same light
    QTRY_VERIFY(!isWood(pixelOf(ball().position)));
}

void TestWindowFlat::wallIsDarkerThanTheFloor() {
    const phys_box *boxes = phys_scene_boxes(m_fixture->session().scene().get());
    const uint32_t count = phys_scene_box_count(m_fixture->session().scene().get());
    uint32_t wall = 0;
    while (wall < count && boxes[wall].max.z < 0.01) ++wall;
    QVERIFY(wall < count);
    const phys_box &box = boxes[wall];
    const phys_vec3 top{0.5 * (box.min.x + box.max.x), 0.5 * (box.min.y + box.max.y), box.max.z};
    const phys_vec3 start = ball().position;
    QVERIFY(colourAt(pixelOf(top)).lightness() < colourAt(pixelOf({start.x, start.y + 0.02, 0.0})).lightness());
}

void TestWindowFlat::boardTiltsInThePicture() {
    const phys_vec3 edge{0.08, 0.0, 0.0};
    const QPoint level = pixelOf(edge);
    m_fixture->parameters().set({{"tilt_x", 8.0}});
    m_fixture->trigger("step");
    QTRY_VERIFY(pixelOf(edge) != level);
}

void TestWindowFlat::levelIsPlayedByArrowKeys() {
    m_fixture->press(Qt::Key_Return);
    QTest::keyPress(&m_fixture->window(), Qt::Key_Up);
    const phys_vec3 start = ball().position;
    QTRY_VERIFY(ball().position.y > start.y + 0.001); // up is away from the viewer
    QTest::keyRelease(&m_fixture->window(), Qt::Key_Up);
}

void TestWindowFlat::draggedBallIsWhereTheMouseIs() {
    const phys_vec3 from = ball().position;
    drag(&view(), pixelOf(from), pixelOf({from.x + 0.01, from.y, from.z}));
    QTRY_VERIFY(std::abs(ball().position.x - from.x - 0.01) < 0.001); // a pixel is some 0.3 mm
}

void TestWindowFlat::dragTurnsTheBoardAndStaysAbove() {
    const double azimuth = view().camera().azimuth();
    drag(&view(), {20, 20}, {120, 90});
    QVERIFY(view().camera().azimuth() != azimuth);
    COMPARE_WITHIN(support::elevationOf(view().camera()), inspector::gl::OrbitCamera::kMaxElevation,
                   support::kElevationRounding);
}

void TestWindowFlat::ghostAndTrailsAreDrawn() {
    m_fixture->parameters().set({{"tilt_x", 3.0}, {"tilt_y", 4.0}});
    m_fixture->makeSteps(60);
    const QImage without = view().grabFramebuffer();
    m_fixture->session().comparison().start({"explicit-euler", 1});
    m_fixture->makeSteps(60);
    const auto now = m_fixture->simulation().latest();
    QVERIFY(now.ghost);
    const QPoint ghost = pixelOf(now.ghost->current.position);
    QVERIFY(view().grabFramebuffer().pixelColor(ghost) != without.pixelColor(ghost));
}

void TestWindowFlat::everyDockOpens() {
    for (QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>()) {
        if (dock->isHidden()) m_fixture->trigger("show_" + dock->objectName());
        QTRY_VERIFY2(!dock->isHidden(), qPrintable(dock->objectName()));
    }
    m_fixture->makeSteps(3);
}

void TestWindowFlat::pictureIsSavedAtAnySize() {
    const QImage picture = view().picture(2);
    QCOMPARE(picture.size(), 2 * view().size() * view().devicePixelRatio());
    QVERIFY(picture.pixelColor(picture.rect().center()) != QColor(Qt::black));
}

void TestWindowFlat::themeIsTheTables() {
    const int light = colourAt({3, 3}).lightness();
    m_fixture->trigger("theme_2");
    QTRY_VERIFY(colourAt({3, 3}).lightness() < light / 2);
    m_fixture->trigger("theme_1");
}

// Smooth edges have colours between those of both sides.
void TestWindowFlat::lowQualityLeavesEdgesJagged() {
    const auto colours = [this](inspector::gl::Quality quality) {
        view().setQuality(quality);
        const QImage picture = view().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
        std::set<QRgb> found;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) found.insert(picture.pixel(x, y));
        return found.size();
    };
    QVERIFY(colours(inspector::gl::Quality::Low) < colours(inspector::gl::Quality::Medium));
}

QTEST_MAIN(TestWindowFlat)
#include "tst_window_flat.moc"
