// SPDX-License-Identifier: MIT
#pragma once

#include "gl/frame.h"
#include "gl/maze_renderer.h"
#include "gl/orbit_camera.h"

#include <memory>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

// A small maze, drawn without a window: a floor of 20 x 16 cm with a rim, and one wall along y at x = 0.
class OffscreenPicture {
public:
    static constexpr int kWidth = 320;
    static constexpr int kHeight = 240;

    // isReady() says whether there is usable OpenGL; `problem` says why there is none.
    OffscreenPicture();
    ~OffscreenPicture();
    bool isReady() const { return m_renderer != nullptr; }
    QString problem() const { return m_problem; }

    inspector::gl::MazeRenderer &renderer() { return *m_renderer; }
    inspector::gl::OrbitCamera &camera() { return m_camera; }

    QImage draw(const inspector::gl::Frame &frame, inspector::gl::Quality quality = inspector::gl::Quality::Medium);
    // The same in two passes: first what stands still, then what moves.
    QImage drawInParts(const inspector::gl::Frame &frame, inspector::gl::Quality quality);
    inspector::gl::MazeRenderer::StaticScene staticSceneOf(const inspector::gl::Frame &frame,
                                                           inspector::gl::Quality quality);

    // The pixel where a point of a level board is drawn.
    QPoint pixelOf(const glm::dvec3 &place) const;

private:
    inspector::gl::View viewOf(inspector::gl::Quality quality) const;

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<QOpenGLFramebufferObject> m_target;
    std::unique_ptr<inspector::gl::MazeRenderer> m_renderer;
    inspector::gl::OrbitCamera m_camera;
    QString m_problem;
};
