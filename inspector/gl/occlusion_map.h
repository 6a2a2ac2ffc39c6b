// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QOpenGLFunctions_3_3_Core>

namespace inspector::gl {

/// A texture of the mean height around each point of the board: where it is above a surface, that surface sees less of
/// the sky. Static, so it costs one look-up per pixel. Created and destroyed with the same context current.
class OcclusionMap {
public:
    static constexpr int kSize = 512;

    explicit OcclusionMap(QOpenGLFunctions_3_3_Core *gl);
    ~OcclusionMap();
    OcclusionMap(const OcclusionMap &) = delete;
    OcclusionMap &operator=(const OcclusionMap &) = delete;

    GLuint texture() const { return m_texture; }

    /// kSize x kSize heights scaled to 0..1; averaged over about `radiusX` and `radiusY` texels.
    void upload(std::vector<float> heights, int radiusX, int radiusY);

private:
    void store(const std::vector<float> &heights);

    QOpenGLFunctions_3_3_Core *m_gl;
    GLuint m_texture = 0;
};

} // namespace inspector::gl
