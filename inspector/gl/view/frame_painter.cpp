// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/frame_painter.h"

#include "gl/surface_format.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLDebugLogger>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>

#include <utility>

namespace inspector::gl {

namespace {

constexpr int kSamples = 4; // of saved pictures

QOpenGLExtraFunctions &functions() { return *QOpenGLContext::currentContext()->extraFunctions(); }

// As a widget's own one, so that depths can be copied between them.
QOpenGLFramebufferObjectFormat formatOf(int samples) {
    QOpenGLFramebufferObjectFormat format;
    format.setSamples(samples);
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    return format;
}

QSize sizeOf(const View &view) { return {view.pixels.x, view.pixels.y}; }

} // namespace

FramePainter::FramePainter(CanvasHost &host)
    : m_host(host) {}

FramePainter::~FramePainter() = default;

void FramePainter::setMaze(const Mesh &mesh) {
    m_maze = mesh;
    m_are_meshes_stale = true;
    emit changed();
}

void FramePainter::setBall(const Mesh &mesh) {
    m_ball = mesh;
    m_are_meshes_stale = true;
    emit changed();
}

void FramePainter::setQuality(std::optional<Quality> quality) {
    m_set_quality = quality;
    emit changed();
}

void FramePainter::setShaderDirectory(const QString &path) {
    m_shader_directory = path;
    if (m_renderer) m_renderer->shaders().setDirectory(path);
    emit changed();
}

void FramePainter::begin() {
    startDebugLogger();
    QString error;
    m_renderer = MazeRenderer::create(&error);
    if (!m_renderer) return m_host.noteUnusable(error);
    m_are_meshes_stale = true;
    m_name = rendererName();
    m_chooser = QualityChooser(isSoftwareRenderer(m_name) ? Quality::Medium : Quality::High);
    ShaderLibrary &shaders = m_renderer->shaders();
    connect(&shaders, &ShaderLibrary::changed, this, &FramePainter::changed);
    connect(&shaders, &ShaderLibrary::failed, this, [this](const QString &text) { m_host.noteProblem(text); });
    connect(&shaders, &ShaderLibrary::rebuilt, this, [this] { m_host.noteRebuilt(); });
    if (!m_shader_directory.isEmpty()) shaders.setDirectory(m_shader_directory);
}

void FramePainter::end() {
    m_unsmoothed.reset();
    m_still_picture.reset();
    m_renderer.reset();
}

void FramePainter::startDebugLogger() {
    QOpenGLContext *context = QOpenGLContext::currentContext();
    if (!context->format().testOption(QSurfaceFormat::DebugContext)) return;
    auto *logger = new QOpenGLDebugLogger(context);
    if (!logger->initialize()) return;
    connect(logger, &QOpenGLDebugLogger::messageLogged, this, [](const QOpenGLDebugMessage &message) {
        const bool is_serious =
            message.severity() & (QOpenGLDebugMessage::HighSeverity | QOpenGLDebugMessage::MediumSeverity);
        if (is_serious && message.type() != QOpenGLDebugMessage::PerformanceType)
            qWarning("OpenGL: %s", qPrintable(message.message().trimmed()));
    });
    logger->startLogging();
}

void FramePainter::uploadMeshes() {
    if (!m_are_meshes_stale) return;
    m_are_meshes_stale = false;
    m_renderer->setMaze(m_maze);
    if (m_ball) m_renderer->setBall(*m_ball);
}

void FramePainter::paint(unsigned framebuffer) {
    if (!m_renderer) return;
    QElapsedTimer timer;
    timer.start();
    const Frame &frame = m_host.nextFrame();
    uploadMeshes();
    View view = m_host.view();
    view.quality = quality();
    const bool is_smoothed = view.quality == Quality::High;
    const bool is_whole = render(frame, view, is_smoothed ? unsmoothed(view) : framebuffer);
    functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (is_smoothed) m_renderer->smooth(m_unsmoothed->texture(), view);
    functions().glFinish(); // drivers queue; the figure is for the finished picture
    const double milliseconds = 1e-6 * static_cast<double>(timer.nsecsElapsed());
    if (is_whole && !m_set_quality) m_chooser.note(milliseconds);
    m_host.noteDrawn(milliseconds);
}

unsigned FramePainter::unsmoothed(const View &view) {
    if (!m_unsmoothed || m_unsmoothed->size() != sizeOf(view))
        m_unsmoothed = std::make_unique<QOpenGLFramebufferObject>(sizeOf(view), formatOf(0));
    return m_unsmoothed->handle();
}

// Once board and table stand still they are drawn once more without the ball, and copied from then on. True if all of
// the picture was drawn.
bool FramePainter::render(const Frame &frame, const View &view, unsigned framebuffer) {
    const MazeRenderer::Still still = m_renderer->stillOf(frame, view);
    if (still != std::exchange(m_still, still)) {
        m_still_picture.reset();
        functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        m_renderer->render(frame, view);
        return true;
    }
    if (!m_still_picture) makeStill(frame, view);
    copy(m_still_picture->handle(), framebuffer, view, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_renderer->renderMoving(frame, view);
    return false;
}

void FramePainter::makeStill(const Frame &frame, const View &view) {
    m_still_picture = std::make_unique<QOpenGLFramebufferObject>(sizeOf(view), formatOf(0));
    m_still_picture->bind();
    m_renderer->renderStill(frame, view);
}

void FramePainter::copy(unsigned from, unsigned to, const View &view, unsigned buffers) {
    const auto [width, height] = std::pair(view.pixels.x, view.pixels.y);
    functions().glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    functions().glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    functions().glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, buffers, GL_NEAREST);
}

QImage FramePainter::picture(const Frame &frame, int scale) {
    if (!m_renderer) return {};
    View view = m_host.view();
    view.quality = quality();
    view.pixel_ratio *= scale;
    view.pixels *= scale;
    QOpenGLFramebufferObject target(sizeOf(view), formatOf(kSamples));
    target.bind();
    m_renderer->render(frame, view);
    const QImage picture = target.toImage();
    target.release();
    return picture.convertToFormat(QImage::Format_RGB32);
}

} // namespace inspector::gl
