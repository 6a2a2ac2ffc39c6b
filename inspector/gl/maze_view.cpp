// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/maze_view.h"

#include "gl/board_pose.h"
#include "gl/maze_renderer.h"

#include <cmath>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QOpenGLDebugLogger>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QStyleHints>
#include <QWheelEvent>

#include <glm/common.hpp>

namespace inspector::gl {

namespace {

constexpr int kPulseMilliseconds = 16;
constexpr int kSamples = 4;
constexpr double kWheelUnitsPerStep = 120.0; // QWheelEvent: eighths of a degree, 15 degrees a notch

glm::dvec2 toGlm(const QPointF &point) { return {point.x(), point.y()}; }

glm::vec3 toGlm(const QColor &colour) {
    return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()), static_cast<float>(colour.blueF())};
}

Backdrop backdropOf(const QPalette &palette) {
    // The table takes the window's colour; the horizon is lighter in a light theme and darker in a dark one.
    const QColor window = palette.color(QPalette::Window);
    const glm::vec3 table = toGlm(window);
    const bool is_dark = window.lightnessF() < 0.5;
    return {is_dark ? table * 1.15F : table * 0.97F, is_dark ? table * 0.55F : glm::mix(table, glm::vec3(1.0F), 0.5F)};
}

} // namespace

MazeView::MazeView(QWidget *parent)
    : QOpenGLWidget(parent) {
    setMinimumSize(160, 120);
    m_pulse.setTimerType(Qt::PreciseTimer);
    m_pulse.setInterval(kPulseMilliseconds);
    connect(&m_pulse, &QTimer::timeout, this, [this] {
        if (isVisible() && m_is_new()) update();
    });
}

MazeView::~MazeView() {
    // The base class destroys the context, when this is no MazeView any more.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseResources();
}

void MazeView::releaseResources() {
    if (!m_renderer) return;
    makeCurrent();
    m_multisampled.reset();
    m_renderer.reset();
    doneCurrent();
}

void MazeView::setMaze(const Mesh &mesh) {
    const Bounds bounds = mesh.bounds();
    const bool is_same_size = bounds.minimum == m_bounds.minimum && bounds.maximum == m_bounds.maximum;
    m_bounds = bounds;
    m_maze = mesh;
    m_are_meshes_stale = true;
    m_camera.setBounds(bounds, m_largest_tilt);
    if (!is_same_size) resetCamera();
    update();
}

void MazeView::setLargestTilt(double tilt) {
    m_largest_tilt = tilt;
    m_camera.setBounds(m_bounds, tilt);
    if (!m_is_camera_moved) m_camera.fit();
    update();
}

void MazeView::setBall(const Mesh &mesh) {
    m_ball = mesh;
    m_are_meshes_stale = true;
    update();
}

void MazeView::setFrame(const Frame &frame) {
    m_frame = frame;
    update();
}

void MazeView::setFrameSource(std::function<Frame()> source, std::function<bool()> isNew) {
    m_source = std::move(source);
    m_is_new = std::move(isNew);
    if (m_source) {
        m_pulse.start();
    } else {
        m_pulse.stop();
    }
}

void MazeView::setQuality(Quality quality) {
    m_chosen_quality = quality;
    m_quality = quality;
    update();
}

void MazeView::setShaderDirectory(const QString &path) {
    m_shader_directory = path;
    if (m_renderer) m_renderer->shaders().setDirectory(path);
    update();
}

void MazeView::resetCamera() {
    m_is_camera_moved = false;
    m_camera.reset();
    update();
}

QPointF MazeView::positionOf(const glm::dvec3 &board_point) const {
    const glm::dvec2 pixel = m_camera.project(glm::dvec3(boardPose() * glm::dvec4(board_point, 1.0)));
    return {pixel.x, pixel.y};
}

Ray MazeView::rayAt(const QPointF &place) const { return m_camera.pickRay(toGlm(place), boardPose()); }

glm::dmat4 MazeView::boardPose() const { return boardToWorld(m_frame.tilt_x, m_frame.tilt_y, boardPivot(m_bounds)); }

void MazeView::initializeGL() {
    // Moving the widget to another window replaces its context; what belongs to the old one goes with it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &MazeView::releaseResources, Qt::UniqueConnection);
    startDebugLogger();
    QString error;
    m_renderer = MazeRenderer::create(&error);
    if (!m_renderer) {
        emit problem(error);
        return;
    }
    m_are_meshes_stale = true;
    m_renderer_name =
        QString::fromLatin1(reinterpret_cast<const char *>(context()->functions()->glGetString(GL_RENDERER)));
    const bool is_software =
        m_renderer_name.contains(QLatin1String("llvmpipe")) || m_renderer_name.contains(QLatin1String("softpipe"));
    m_quality = m_chosen_quality.value_or(is_software ? Quality::Medium : Quality::High);
    ShaderLibrary &shaders = m_renderer->shaders();
    connect(&shaders, &ShaderLibrary::changed, this, qOverload<>(&QWidget::update));
    connect(&shaders, &ShaderLibrary::failed, this, &MazeView::problem);
    connect(&shaders, &ShaderLibrary::rebuilt, this, &MazeView::shadersRebuilt);
    if (!m_shader_directory.isEmpty()) shaders.setDirectory(m_shader_directory);
}

void MazeView::startDebugLogger() {
    if (!context()->format().testOption(QSurfaceFormat::DebugContext)) return;
    auto *logger = new QOpenGLDebugLogger(context());
    if (!logger->initialize()) return;
    connect(logger, &QOpenGLDebugLogger::messageLogged, this, [](const QOpenGLDebugMessage &message) {
        const bool is_serious =
            message.severity() & (QOpenGLDebugMessage::HighSeverity | QOpenGLDebugMessage::MediumSeverity);
        if (is_serious && message.type() != QOpenGLDebugMessage::PerformanceType)
            qWarning("OpenGL: %s", qPrintable(message.message().trimmed()));
    });
    logger->startLogging();
}

void MazeView::uploadMeshes() {
    if (!m_are_meshes_stale) return;
    m_are_meshes_stale = false;
    m_renderer->setMaze(m_maze);
    if (m_ball) m_renderer->setBall(*m_ball);
}

void MazeView::resizeGL(int width, int height) {
    m_camera.setViewport({width, height});
    if (!m_is_camera_moved) m_camera.fit();
}

View MazeView::currentView() const {
    View view;
    view.view = m_camera.view();
    view.projection = m_camera.projection();
    // The one place where logical pixels become those of the device.
    view.pixel_ratio = devicePixelRatioF();
    view.pixels = {std::lround(width() * view.pixel_ratio), std::lround(height() * view.pixel_ratio)};
    view.quality = m_quality;
    view.backdrop = backdropOf(palette());
    return view;
}

void MazeView::paintGL() {
    if (!m_renderer) return;
    QElapsedTimer timer;
    timer.start();
    ++m_pictures;
    if (m_source) m_frame = m_source();
    uploadMeshes();
    const View view = currentView();
    if (m_quality == Quality::High) {
        renderMultisampled(view);
    } else {
        m_multisampled.reset();
        m_renderer->render(m_frame, view);
    }
    context()->functions()->glFinish(); // drivers queue; the figure is for the finished picture
    m_frame_milliseconds = 1e-6 * static_cast<double>(timer.nsecsElapsed());
}

// Into a framebuffer of our own, so that the quality can be switched while running; the widget's can't.
void MazeView::renderMultisampled(const View &view) {
    const QSize size(view.pixels.x, view.pixels.y);
    if (!m_multisampled || m_multisampled->size() != size) {
        QOpenGLFramebufferObjectFormat format;
        format.setSamples(kSamples);
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        m_multisampled = std::make_unique<QOpenGLFramebufferObject>(size, format);
    }
    m_multisampled->bind();
    m_renderer->render(m_frame, view);
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, m_multisampled.get());
    context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

// Drawn once more, into a framebuffer of its own, with as many samples as there are.
QImage MazeView::picture(int scale) {
    if (!m_renderer) return {};
    makeCurrent();
    View view = currentView();
    view.pixel_ratio *= scale;
    view.pixels *= scale;
    const QSize size(view.pixels.x, view.pixels.y);
    QOpenGLFramebufferObjectFormat format;
    format.setSamples(kSamples);
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    QOpenGLFramebufferObject target(size, format);
    target.bind();
    m_renderer->render(m_frame, view);
    const QImage picture = target.toImage();
    target.release();
    doneCurrent();
    return picture.convertToFormat(QImage::Format_RGB32);
}

void MazeView::mousePressEvent(QMouseEvent *event) {
    m_press_position = event->position();
    m_last_position = event->position();
    m_is_dragging = false;
}

void MazeView::mouseMoveEvent(QMouseEvent *event) {
    if (event->buttons() == Qt::NoButton) return;
    const double moved = (event->position() - m_press_position).manhattanLength();
    m_is_dragging = m_is_dragging || moved >= QGuiApplication::styleHints()->startDragDistance();
    if (!m_is_dragging) return;
    m_is_camera_moved = true;
    const glm::dvec2 drag = toGlm(event->position() - m_last_position);
    m_last_position = event->position();
    if (event->buttons() & Qt::LeftButton) {
        m_camera.orbit(drag);
    } else {
        m_camera.pan(drag);
    }
    update();
}

void MazeView::mouseReleaseEvent(QMouseEvent *event) {
    if (m_is_dragging || event->button() != Qt::LeftButton) return;
    emit clicked(rayAt(event->position()));
}

void MazeView::mouseDoubleClickEvent(QMouseEvent *event) {
    m_is_dragging = true; // its release is no click
    event->accept();
    resetCamera();
}

void MazeView::wheelEvent(QWheelEvent *event) {
    m_is_camera_moved = true;
    m_camera.zoom(event->angleDelta().y() / kWheelUnitsPerStep, toGlm(event->position()));
    event->accept();
    update();
}

} // namespace inspector::gl
