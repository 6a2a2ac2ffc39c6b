// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/stroke_renderer.h"

#include <cstddef>

namespace inspector::gl {

namespace {

struct InstanceAttribute {
    GLint size;
    std::size_t offset;
};

/// In the order of the locations in stroke.vert.
constexpr InstanceAttribute kInstanceAttributes[] = {{3, offsetof(Stroke, from)},
                                                     {3, offsetof(Stroke, to)},
                                                     {4, offsetof(Stroke, fromColour)},
                                                     {4, offsetof(Stroke, toColour)},
                                                     {2, offsetof(Stroke, width)}}; // width and roundEnds
static_assert(offsetof(Stroke, roundEnds) == offsetof(Stroke, width) + sizeof(float));

} // namespace

StrokeRenderer::StrokeRenderer(QOpenGLFunctions_3_3_Core *gl)
    : m_gl(gl) {
    m_array.create();
    m_instances.create();
    m_instances.setUsagePattern(QOpenGLBuffer::StreamDraw);
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_instances.bind();
    GLuint location = 0;
    for (const InstanceAttribute &attribute : kInstanceAttributes) {
        m_gl->glEnableVertexAttribArray(location);
        m_gl->glVertexAttribPointer(
            location, attribute.size, GL_FLOAT, GL_FALSE, sizeof(Stroke),
            reinterpret_cast<const void *>(attribute.offset)); // NOLINT(performance-no-int-to-ptr): OpenGL's way
        m_gl->glVertexAttribDivisor(location, 1);
        ++location;
    }
}

void StrokeRenderer::upload(const Strokes &strokes) {
    m_instances.bind();
    m_count = static_cast<GLsizei>(strokes.all().size());
    m_instances.allocate(strokes.all().data(), static_cast<int>(strokes.all().size() * sizeof(Stroke)));
}

void StrokeRenderer::draw() {
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_gl->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, m_count);
}

} // namespace inspector::gl
