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

constexpr int kSamples = 4; ///< of saved pictures

QOpenGLExtraFunctions &functions() { return *QOpenGLContext::currentContext()->extraFunctions(); }

/// The format of a widget's own framebuffer, so that depth can be copied between them.
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
    m_areMeshesStale = true;
    emit changed();
}

void FramePainter::setBall(const Mesh &mesh) {
    m_ball = mesh;
    m_areMeshesStale = true;
    emit changed();
}

void FramePainter::setQuality(std::optional<Quality> quality) {
    m_setQuality = quality;
    emit changed();
}

void FramePainter::setShaderDirectory(const QString &path) {
    m_shaderDirectory = path;
    if (m_renderer) m_renderer->shaders().setDirectory(path);
    emit changed();
}

void FramePainter::begin() {
    startDebugLogger();
    QString error;
    m_renderer = MazeRenderer::create(&error);
    if (!m_renderer) return m_host.noteUnusable(error);
    m_areMeshesStale = true;
    m_name = rendererName();
    m_chooser = QualityChooser(isSoftwareRenderer(m_name) ? Quality::Medium : Quality::High);
    ShaderLibrary &shaders = m_renderer->shaders();
    connect(&shaders, &ShaderLibrary::changed, this, &FramePainter::changed);
    connect(&shaders, &ShaderLibrary::failed, this, [this](const QString &text) { m_host.noteProblem(text); });
    connect(&shaders, &ShaderLibrary::rebuilt, this, [this] { m_host.noteRebuilt(); });
    if (!m_shaderDirectory.isEmpty()) shaders.setDirectory(m_shaderDirectory);
}

void FramePainter::end() {
    m_unsmoothed.reset();
    m_staticPicture.reset();
    m_renderer.reset();
}

void FramePainter::startDebugLogger() {
    QOpenGLContext *context = QOpenGLContext::currentContext();
    if (!context->format().testOption(QSurfaceFormat::DebugContext)) return;
    auto *logger = new QOpenGLDebugLogger(context);
    if (!logger->initialize()) return;
    connect(logger, &QOpenGLDebugLogger::messageLogged, this, [](const QOpenGLDebugMessage &message) {
        const bool isSerious =
            message.severity() & (QOpenGLDebugMessage::HighSeverity | QOpenGLDebugMessage::MediumSeverity);
        if (isSerious && message.type() != QOpenGLDebugMessage::PerformanceType)
            qWarning("OpenGL: %s", qPrintable(message.message().trimmed()));
    });
    logger->startLogging();
}

void FramePainter::uploadMeshes() {
    if (!m_areMeshesStale) return;
    m_areMeshesStale = false;
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
    const bool isSmoothed = view.quality == Quality::High;
    const bool isWhole = render(frame, view, isSmoothed ? unsmoothed(view) : framebuffer);
    functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (isSmoothed) m_renderer->smooth(m_unsmoothed->texture(), view);
    functions().glFinish(); // drivers queue commands; measure until the picture is finished
    const double milliseconds = 1e-6 * static_cast<double>(timer.nsecsElapsed());
    if (isWhole && !m_setQuality) m_chooser.note(milliseconds);
    m_host.noteDrawn(milliseconds);
}

unsigned FramePainter::unsmoothed(const View &view) {
    if (!m_unsmoothed || m_unsmoothed->size() != sizeOf(view))
        m_unsmoothed = std::make_unique<QOpenGLFramebufferObject>(sizeOf(view), formatOf(0));
    return m_unsmoothed->handle();
}

/// When board and table don't change, they are drawn once without the ball and copied afterwards. Returns true if
/// everything was drawn anew.
bool FramePainter::render(const Frame &frame, const View &view, unsigned framebuffer) {
    const MazeRenderer::StaticScene staticScene = m_renderer->staticSceneOf(frame, view);
    if (staticScene != std::exchange(m_staticScene, staticScene)) {
        m_staticPicture.reset();
        functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        m_renderer->render(frame, view);
        return true;
    }
    if (!m_staticPicture) makeStaticPicture(frame, view);
    copy(m_staticPicture->handle(), framebuffer, view, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    functions().glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_renderer->renderMoving(frame, view);
    return false;
}

void FramePainter::makeStaticPicture(const Frame &frame, const View &view) {
    m_staticPicture = std::make_unique<QOpenGLFramebufferObject>(sizeOf(view), formatOf(0));
    m_staticPicture->bind();
    m_renderer->renderStatic(frame, view);
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
    view.pixelRatio *= scale;
    view.pixels *= scale;
    QOpenGLFramebufferObject target(sizeOf(view), formatOf(kSamples));
    target.bind();
    m_renderer->render(frame, view);
    const QImage picture = target.toImage();
    target.release();
    return picture.convertToFormat(QImage::Format_RGB32);
}

} // namespace inspector::gl
