// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/image_canvas.h"

#include "gl/surface_format.h"

#include <QOpenGLFramebufferObject>
#include <QPainter>

namespace inspector::gl {

ImageCanvas::ImageCanvas(CanvasHost &host, QWidget *parent)
    : QWidget(parent)
    , m_host(host)
    , m_painter(host) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&m_painter, &FramePainter::changed, this, qOverload<>(&QWidget::update));
}

ImageCanvas::~ImageCanvas() {
    if (!makeCurrent()) return;
    m_target.reset();
    m_painter.end();
    m_context->doneCurrent();
}

bool ImageCanvas::makeCurrent() { return m_context && m_context->makeCurrent(&m_surface); }

void ImageCanvas::makeContext() {
    m_surface.setFormat(QSurfaceFormat::defaultFormat());
    m_surface.create();
    m_context = std::make_unique<QOpenGLContext>();
    m_context->create();
    if (makeCurrent()) return m_painter.begin();
    m_host.noteUnusable(contextProblem(nullptr));
}

QImage ImageCanvas::draw() {
    if (!m_context) makeContext();
    if (!makeCurrent()) return {};
    const View view = m_host.view();
    const QSize size(view.pixels.x, view.pixels.y);
    if (!m_target || m_target->size() != size)
        m_target = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
    m_painter.paint(m_target->handle());
    QImage image = m_target->toImage();
    m_context->doneCurrent();
    image.reinterpretAsFormat(QImage::Format_RGB32); // the picture is opaque
    image.setDevicePixelRatio(view.pixelRatio);
    return image;
}

void ImageCanvas::paintEvent(QPaintEvent *) {
    const QImage image = draw();
    QPainter(this).drawImage(0, 0, image);
}

QImage ImageCanvas::shown() { return draw(); }

QImage ImageCanvas::picture(const Frame &frame, int scale) {
    if (!makeCurrent()) return {};
    QImage picture = m_painter.picture(frame, scale);
    m_context->doneCurrent();
    return picture;
}

} // namespace inspector::gl
