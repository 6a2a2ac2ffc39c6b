// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>

namespace inspector::gl {

/// A mesh in GPU buffers, drawn by one call. Created, used and destroyed with the same context current.
class MeshBuffer {
public:
    explicit MeshBuffer(QOpenGLFunctions_3_3_Core *gl);

    void upload(const Mesh &mesh);
    void draw();

private:
    QOpenGLFunctions_3_3_Core *m_gl;
    QOpenGLVertexArrayObject m_array;
    QOpenGLBuffer m_vertices{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer m_indices{QOpenGLBuffer::IndexBuffer};
    GLsizei m_count = 0;
};

} // namespace inspector::gl
