// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/maze_view.h"

#include "gl/board_pose.h"
#include "gl/surface_format.h"
#include "gl/view/flat_canvas.h"
#include "gl/view/gl_canvas.h"
#include "gl/view/image_canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyleHints>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <glm/common.hpp>

namespace inspector::gl {

namespace {

constexpr int kPulseMilliseconds = 16;
constexpr double kLeastBall = 3.0;           ///< minimum radius of a ball in the picture, logical pixels
constexpr double kFollowShare = 0.4;         ///< share of the distance that shows everything
constexpr double kWheelUnitsPerStep = 120.0; ///< QWheelEvent: eighths of a degree, 15 degrees a notch

glm::dvec2 toGlm(const QPointF &point) { return {point.x(), point.y()}; }

glm::vec3 toGlm(const QColor &colour) {
    return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()), static_cast<float>(colour.blueF())};
}

Backdrop backdropOf(const QPalette &palette) {
    // The table takes the window's colour; the horizon is lighter in a light theme and darker in a dark one.
    const QColor window = palette.color(QPalette::Window);
    const glm::vec3 table = toGlm(window);
    const bool isDark = window.lightnessF() < 0.5;
    return {isDark ? table * 1.15F : table * 0.97F, isDark ? table * 0.55F : glm::mix(table, glm::vec3(1.0F), 0.5F)};
}

} // namespace

MazeView::MazeView(Drawing drawing, QWidget *parent)
    : QWidget(parent) {
    setMinimumSize(160, 70);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    makeCanvas(drawing);
    m_pulse.setTimerType(Qt::PreciseTimer);
    m_pulse.setInterval(kPulseMilliseconds);
    connect(&m_pulse, &QTimer::timeout, this, [this] {
        if (isVisible() && m_isNew()) update();
    });
}

MazeView::~MazeView() { delete m_canvas; } ///< before the host's other members

void MazeView::makeCanvas(Drawing drawing) {
    delete std::exchange(m_canvas, nullptr);
    m_drawing = drawing != Drawing::Solid ? drawing : isDrawnBySoftware() ? Drawing::Picture : Drawing::Screen;
    if (m_drawing == Drawing::Flat) m_canvas = new FlatCanvas(*this, this);
    if (m_drawing == Drawing::Picture) m_canvas = new ImageCanvas(*this, this);
    if (m_drawing == Drawing::Screen) m_canvas = new GlCanvas(*this, this);
    m_canvas->widget().setAttribute(Qt::WA_TransparentForMouseEvents); // mouse events are handled by the view
    layout()->addWidget(&m_canvas->widget());
    m_canvas->setMaze(m_maze);
    if (m_ball) m_canvas->setBall(*m_ball);
    if (!m_shaderDirectory.isEmpty()) m_canvas->setShaderDirectory(m_shaderDirectory);
    resetCamera();
}

/// Queued, so that no function of the old canvas is on the call stack.
void MazeView::noteUnusable(const QString &reason) {
    emit problem(tr("%1; the board is drawn from above instead").arg(reason));
    QMetaObject::invokeMethod(
        this, [this] { makeCanvas(Drawing::Flat); }, Qt::QueuedConnection);
}

void MazeView::update() { m_canvas->widget().update(); }

void MazeView::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) update(); // the table uses the window's colour
}

void MazeView::setMaze(const Mesh &mesh) {
    const Bounds bounds = mesh.bounds();
    const bool isSameSize = bounds.minimum == m_bounds.minimum && bounds.maximum == m_bounds.maximum;
    m_bounds = bounds;
    m_maze = mesh;
    m_canvas->setMaze(mesh);
    m_camera.setBounds(bounds, m_largestTilt);
    if (!isSameSize) resetCamera();
    update();
}

void MazeView::setLargestTilt(double tilt) {
    m_largestTilt = tilt;
    m_camera.setBounds(m_bounds, tilt);
    if (!m_isCameraMoved) m_camera.fit();
    update();
}

void MazeView::setBall(const Mesh &mesh) {
    m_ball = mesh;
    m_canvas->setBall(mesh);
}

void MazeView::setFrameSource(std::function<Frame()> source, std::function<bool()> isNew) {
    m_source = std::move(source);
    m_isNew = std::move(isNew);
    if (m_source) {
        m_pulse.start();
    } else {
        m_pulse.stop();
    }
}

void MazeView::setQuality(std::optional<Quality> quality) { m_canvas->setQuality(quality); }

void MazeView::setShaderDirectory(const QString &path) {
    m_shaderDirectory = path;
    m_canvas->setShaderDirectory(path);
}

void MazeView::resetCamera() {
    setFollowing(false);
    m_isCameraMoved = false;
    if (m_drawing == Drawing::Flat) return lookFromAbove();
    m_camera.reset();
    update();
}

void MazeView::lookFromAbove() {
    setFollowing(false);
    m_camera.reset();
    m_camera.orbit({0.0, 1e4}); // up to the limit
    m_camera.fit();
    update();
}

void MazeView::orbit(const QPointF &drag) {
    m_isCameraMoved = true;
    m_camera.orbit({drag.x(), m_drawing == Drawing::Flat ? 0.0 : drag.y()});
    update();
}

void MazeView::zoom(double steps, const QPointF &place) {
    m_isCameraMoved = true;
    m_camera.zoom(steps, toGlm(place));
    update();
}

void MazeView::setFollowing(bool isOn) {
    if (isOn == m_isFollowing) return;
    m_isFollowing = isOn;
    if (isOn) m_camera.approach(kFollowShare);
    if (!isOn) m_camera.fit();
    emit followingChanged(isOn);
    update();
}

QPointF MazeView::positionOf(const glm::dvec3 &boardPoint) const {
    const glm::dvec2 pixel = m_camera.project(glm::dvec3(boardPose() * glm::dvec4(boardPoint, 1.0)));
    return {pixel.x, pixel.y};
}

Ray MazeView::rayAt(const QPointF &place) const { return m_camera.pickRay(toGlm(place), boardPose()); }

glm::dmat4 MazeView::boardPose() const { return boardToWorld(m_frame.tiltX, m_frame.tiltY, boardPivot(m_bounds)); }

void MazeView::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    m_camera.setViewport({width(), height()});
    if (!m_isCameraMoved && !m_isFollowing) m_camera.fit();
}

View MazeView::view() const {
    View view;
    view.view = m_camera.view();
    view.projection = m_camera.projection();
    // This is the only place that converts logical to device pixels.
    view.pixelRatio = devicePixelRatioF();
    view.pixels = {std::lround(width() * view.pixelRatio), std::lround(height() * view.pixelRatio)};
    view.backdrop = backdropOf(palette());
    return view;
}

/// In a large maze shown as a whole, a ball of its true size would be an invisible dot.
void MazeView::keepVisible(Ball &ball) const {
    const QPointF reach = positionOf(ball.position + glm::dvec3(ball.radius, 0.0, 0.0)) - positionOf(ball.position);
    const double radius = std::hypot(reach.x(), reach.y());
    if (radius < kLeastBall) ball.radius *= kLeastBall / std::max(radius, 1e-3);
}

const Frame &MazeView::nextFrame() {
    ++m_pictures;
    if (m_source) m_frame = m_source();
    if (m_isFollowing) m_camera.lookAt(glm::dvec3(boardPose() * glm::dvec4(m_frame.ball.position, 1.0)));
    keepVisible(m_frame.ball);
    for (GhostBall &ghost : m_frame.ghosts) keepVisible(ghost.ball);
    return m_frame;
}

void MazeView::mousePressEvent(QMouseEvent *event) {
    m_pressPosition = event->position();
    m_lastPosition = event->position();
    m_isDragging = false;
}

void MazeView::mouseMoveEvent(QMouseEvent *event) {
    if (event->buttons() == Qt::NoButton) return;
    const double moved = (event->position() - m_pressPosition).manhattanLength();
    m_isDragging = m_isDragging || moved >= QGuiApplication::styleHints()->startDragDistance();
    if (!m_isDragging) return;
    const QPointF drag = event->position() - m_lastPosition;
    m_lastPosition = event->position();
    if (event->buttons() & Qt::LeftButton) return orbit(drag);
    m_isCameraMoved = true;
    m_camera.pan(toGlm(drag));
    update();
}

void MazeView::mouseReleaseEvent(QMouseEvent *event) {
    if (m_isDragging || event->button() != Qt::LeftButton) return;
    emit clicked(rayAt(event->position()));
}

void MazeView::mouseDoubleClickEvent(QMouseEvent *event) {
    m_isDragging = true; // the release isn't a click then
    event->accept();
    resetCamera();
}

void MazeView::wheelEvent(QWheelEvent *event) {
    zoom(event->angleDelta().y() / kWheelUnitsPerStep, event->position());
    event->accept();
}

} // namespace inspector::gl
