// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/gl_canvas.h"

#include "gl/maze_renderer.h"
#include "gl/surface_format.h"

#include <QElapsedTimer>
#include <QOpenGLDebugLogger>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

namespace inspector::gl {

namespace {

constexpr int kSamples = 4;

QOpenGLFramebufferObjectFormat multisampled() {
    QOpenGLFramebufferObjectFormat format;
    format.setSamples(kSamples);
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    return format;
}

} // namespace

GlCanvas::GlCanvas(CanvasHost &host, QWidget *parent)
    : QOpenGLWidget(parent)
    , m_host(host) {}

GlCanvas::~GlCanvas() {
    // The base class destroys the context, when this is no GlCanvas any more.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseResources();
}

void GlCanvas::releaseResources() {
    if (!m_renderer) return;
    makeCurrent();
    m_multisampled.reset();
    m_renderer.reset();
    doneCurrent();
}

void GlCanvas::setMaze(const Mesh &mesh) {
    m_maze = mesh;
    m_are_meshes_stale = true;
    update();
}

void GlCanvas::setBall(const Mesh &mesh) {
    m_ball = mesh;
    m_are_meshes_stale = true;
    update();
}

void GlCanvas::setQuality(Quality quality) {
    m_chosen_quality = quality;
    m_quality = quality;
    update();
}

void GlCanvas::setShaderDirectory(const QString &path) {
    m_shader_directory = path;
    if (m_renderer) m_renderer->shaders().setDirectory(path);
    update();
}

void GlCanvas::initializeGL() {
    // Moving the widget to another window replaces its context; what belongs to the old one goes with it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::releaseResources, Qt::UniqueConnection);
    startDebugLogger();
    QString error;
    m_renderer = MazeRenderer::create(&error);
    if (!m_renderer) {
        m_host.noteUnusable(error);
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
    connect(&shaders, &ShaderLibrary::failed, this, [this](const QString &text) { m_host.noteProblem(text); });
    connect(&shaders, &ShaderLibrary::rebuilt, this, [this] { m_host.noteRebuilt(); });
    if (!m_shader_directory.isEmpty()) shaders.setDirectory(m_shader_directory);
}

void GlCanvas::startDebugLogger() {
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

void GlCanvas::uploadMeshes() {
    if (!m_are_meshes_stale) return;
    m_are_meshes_stale = false;
    m_renderer->setMaze(m_maze);
    if (m_ball) m_renderer->setBall(*m_ball);
}

void GlCanvas::paintGL() {
    if (!m_renderer) return;
    QElapsedTimer timer;
    timer.start();
    const Frame &frame = m_host.nextFrame();
    uploadMeshes();
    View view = m_host.view();
    view.quality = m_quality;
    if (m_quality == Quality::High) {
        renderMultisampled(frame, view);
    } else {
        m_multisampled.reset();
        m_renderer->render(frame, view);
    }
    context()->functions()->glFinish(); // drivers queue; the figure is for the finished picture
    m_host.noteDrawn(1e-6 * static_cast<double>(timer.nsecsElapsed()));
}

// Into a framebuffer of our own, so that the quality can be switched while running; the widget's can't.
void GlCanvas::renderMultisampled(const Frame &frame, const View &view) {
    const QSize size(view.pixels.x, view.pixels.y);
    if (!m_multisampled || m_multisampled->size() != size)
        m_multisampled = std::make_unique<QOpenGLFramebufferObject>(size, multisampled());
    m_multisampled->bind();
    m_renderer->render(frame, view);
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, m_multisampled.get());
    context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

// Drawn once more, into a framebuffer of its own, with as many samples as there are.
QImage GlCanvas::picture(const Frame &frame, int scale) {
    if (!m_renderer) return {};
    makeCurrent();
    View view = m_host.view();
    view.quality = m_quality;
    view.pixel_ratio *= scale;
    view.pixels *= scale;
    QOpenGLFramebufferObject target(QSize(view.pixels.x, view.pixels.y), multisampled());
    target.bind();
    m_renderer->render(frame, view);
    const QImage picture = target.toImage();
    target.release();
    doneCurrent();
    return picture.convertToFormat(QImage::Format_RGB32);
}

} // namespace inspector::gl
