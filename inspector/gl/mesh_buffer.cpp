// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/mesh_buffer.h"

#include <cstddef>

namespace inspector::gl {

namespace {

struct Attribute {
    GLint size;
    GLenum type;
    std::size_t offset;
};

/// In the order of the locations in maze.vert and ball.vert; bytes are normalised to 0..1.
constexpr Attribute kAttributes[] = {{3, GL_FLOAT, offsetof(Vertex, position)},
                                     {3, GL_FLOAT, offsetof(Vertex, normal)},
                                     {2, GL_FLOAT, offsetof(Vertex, grain)},
                                     {4, GL_UNSIGNED_BYTE, offsetof(Vertex, albedo)},
                                     {4, GL_UNSIGNED_BYTE, offsetof(Vertex, surface)}};

} // namespace

MeshBuffer::MeshBuffer(QOpenGLFunctions_3_3_Core *gl)
    : m_gl(gl) {
    m_array.create();
    m_vertices.create();
    m_indices.create();
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_vertices.bind();
    m_indices.bind();
    GLuint location = 0;
    for (const Attribute &attribute : kAttributes) {
        m_gl->glEnableVertexAttribArray(location);
        m_gl->glVertexAttribPointer(
            location, attribute.size, attribute.type, GL_TRUE, sizeof(Vertex),
            reinterpret_cast<const void *>(attribute.offset)); // NOLINT(performance-no-int-to-ptr): OpenGL's way
        ++location;
    }
}

void MeshBuffer::upload(const Mesh &mesh) {
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_vertices.bind();
    m_vertices.allocate(mesh.vertices.data(), static_cast<int>(mesh.vertices.size() * sizeof(Vertex)));
    m_indices.allocate(mesh.indices.data(), static_cast<int>(mesh.indices.size() * sizeof(std::uint32_t)));
    m_count = static_cast<GLsizei>(mesh.indices.size());
}

void MeshBuffer::draw() {
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_gl->glDrawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
}

} // namespace inspector::gl
