// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QOpenGLFunctions_3_3_Core>

namespace inspector::gl {

/// A square depth texture as a render target that is sampled with comparison: a shadow map, or heights seen from above.
/// Created, used and destroyed with the same context current.
class DepthTarget {
public:
    DepthTarget(QOpenGLFunctions_3_3_Core *gl, int size);
    ~DepthTarget();
    DepthTarget(const DepthTarget &) = delete;
    DepthTarget &operator=(const DepthTarget &) = delete;

    int size() const { return m_size; }
    GLuint texture() const { return m_texture; }

    /// Runs `draw` with this target bound and cleared; restores framebuffer and viewport.
    template<typename Draw>
    void drawInto(Draw draw) {
        const Previous previous = begin();
        draw();
        end(previous);
    }

    /// Depths 0..1, row by row from y = -1.
    std::vector<float> read();

private:
    struct Previous {
        GLint framebuffer;
        GLint viewport[4];
    };
    Previous begin();
    void end(const Previous &previous);

    QOpenGLFunctions_3_3_Core *m_gl;
    int m_size;
    GLuint m_texture = 0;
    GLuint m_framebuffer = 0;
};

} // namespace inspector::gl
