// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/strokes.h"

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>

namespace inspector::gl {

/// Draws strokes by OpenGL: one instanced draw call for all. Created, used and destroyed with the same context current.
class StrokeRenderer {
public:
    explicit StrokeRenderer(QOpenGLFunctions_3_3_Core *gl);

    void upload(const Strokes &strokes);
    /// The stroke program must be bound.
    void draw();

private:
    QOpenGLFunctions_3_3_Core *m_gl;
    QOpenGLVertexArrayObject m_array;
    QOpenGLBuffer m_instances{QOpenGLBuffer::VertexBuffer};
    GLsizei m_count = 0;
};

} // namespace inspector::gl
