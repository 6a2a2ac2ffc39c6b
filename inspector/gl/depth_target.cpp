// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/depth_target.h"

namespace inspector::gl {

DepthTarget::DepthTarget(QOpenGLFunctions_3_3_Core *gl, int size)
    : m_gl(gl)
    , m_size(size) {
    m_gl->glGenTextures(1, &m_texture);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    // 16 bits over a board's size resolve a few micrometres, at half the bandwidth of 24.
    m_gl->glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT,
                       nullptr);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    // Everything visible fits with a margin, and nothing beyond the map casts a shadow.
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

    GLint previous = 0;
    m_gl->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &previous);
    m_gl->glGenFramebuffers(1, &m_framebuffer);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_texture, 0);
    m_gl->glDrawBuffer(GL_NONE);
    m_gl->glReadBuffer(GL_NONE);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous));
}

DepthTarget::~DepthTarget() {
    m_gl->glDeleteFramebuffers(1, &m_framebuffer);
    m_gl->glDeleteTextures(1, &m_texture);
}

DepthTarget::Previous DepthTarget::begin() {
    Previous previous{};
    m_gl->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &previous.framebuffer);
    m_gl->glGetIntegerv(GL_VIEWPORT, previous.viewport);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl->glViewport(0, 0, m_size, m_size);
    m_gl->glClear(GL_DEPTH_BUFFER_BIT);
    return previous;
}

void DepthTarget::end(const Previous &previous) {
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous.framebuffer));
    m_gl->glViewport(previous.viewport[0], previous.viewport[1], previous.viewport[2], previous.viewport[3]);
}

std::vector<float> DepthTarget::read() {
    std::vector<float> depths(static_cast<std::size_t>(m_size) * m_size);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl->glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return depths;
}

} // namespace inspector::gl
