// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QOpenGLFunctions_3_3_Core>

namespace inspector::gl {

// Mean height of what stands around each place of the board, as a texture: where it rises above a surface, less of the
// sky is seen from there. Static, so it costs one look-up per pixel. Made and destroyed with one context current.
class OcclusionMap {
public:
    static constexpr int kSize = 512;

    explicit OcclusionMap(QOpenGLFunctions_3_3_Core *gl);
    ~OcclusionMap();
    OcclusionMap(const OcclusionMap &) = delete;
    OcclusionMap &operator=(const OcclusionMap &) = delete;

    GLuint texture() const { return m_texture; }

    // kSize x kSize heights scaled to 0..1; the mean is taken over about `radius` texels in x and y.
    void upload(std::vector<float> heights, int radiusX, int radiusY);

private:
    QOpenGLFunctions_3_3_Core *m_gl;
    GLuint m_texture = 0;
};

} // namespace inspector::gl
