// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/gl_canvas.h"

#include <QOpenGLContext>

namespace inspector::gl {

GlCanvas::GlCanvas(CanvasHost &host, QWidget *parent)
    : QOpenGLWidget(parent)
    , m_painter(host) {
    connect(&m_painter, &FramePainter::changed, this, qOverload<>(&QWidget::update));
}

GlCanvas::~GlCanvas() {
    // The base class destroys the context after this part of the object has been destroyed.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseResources();
}

void GlCanvas::releaseResources() {
    if (!context()) return;
    makeCurrent();
    m_painter.end();
    doneCurrent();
}

void GlCanvas::initializeGL() {
    // Moving the widget to another window replaces its context and all objects in it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::releaseResources, Qt::UniqueConnection);
    m_painter.begin();
}

void GlCanvas::paintGL() { m_painter.paint(defaultFramebufferObject()); }

QImage GlCanvas::picture(const Frame &frame, int scale) {
    if (!context()) return {};
    makeCurrent();
    QImage picture = m_painter.picture(frame, scale);
    doneCurrent();
    return picture;
}

} // namespace inspector::gl
