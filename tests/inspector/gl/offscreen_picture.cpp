// SPDX-License-Identifier: MIT
#include "offscreen_picture.h"

#include "gl/surface_format.h"
#include "mesh/mesh_builder.h"

using namespace inspector::gl;

namespace {

Mesh smallMaze() {
    const MazeBox boxes[] = {{{-0.095, -0.075, -0.005}, {0.095, 0.075, 0.0}, BoxKind::Floor},
                             {{-0.100, -0.080, -0.005}, {0.100, -0.075, 0.014}, BoxKind::Rim},
                             {{-0.100, 0.075, -0.005}, {0.100, 0.080, 0.014}, BoxKind::Rim},
                             {{-0.100, -0.075, -0.005}, {-0.095, 0.075, 0.014}, BoxKind::Rim},
                             {{0.095, -0.075, -0.005}, {0.100, 0.075, 0.014}, BoxKind::Rim},
                             {{-0.0025, -0.050, 0.0}, {0.0025, 0.050, 0.014}, BoxKind::Wall}};
    return mazeFromBoxes(boxes);
}

} // namespace

OffscreenPicture::OffscreenPicture() {
    m_surface.setFormat(surfaceFormat());
    m_surface.create();
    m_context.setFormat(surfaceFormat());
    if (!m_context.create() || !m_context.makeCurrent(&m_surface)) {
        m_problem = QStringLiteral("no OpenGL context on this platform");
        return;
    }
    m_renderer = MazeRenderer::create(&m_problem);
    if (!m_renderer) return;
    m_target = std::make_unique<QOpenGLFramebufferObject>(kWidth, kHeight, QOpenGLFramebufferObject::Depth);
    const Mesh maze = smallMaze();
    m_renderer->setMaze(maze);
    m_camera.setViewport({kWidth, kHeight});
    m_camera.setBounds(maze.bounds(), 0.0);
    m_camera.reset();
}

OffscreenPicture::~OffscreenPicture() {
    if (QOpenGLContext::currentContext() != &m_context) m_context.makeCurrent(&m_surface);
    m_renderer.reset();
    m_target.reset();
}

View OffscreenPicture::viewOf(Quality quality) const {
    return {m_camera.view(), m_camera.projection(), {kWidth, kHeight}, 1.0, quality, Backdrop{}};
}

QImage OffscreenPicture::draw(const Frame &frame, Quality quality) {
    m_target->bind();
    m_renderer->render(frame, viewOf(quality));
    return m_target->toImage().convertToFormat(QImage::Format_RGB32);
}

QImage OffscreenPicture::drawInParts(const Frame &frame, Quality quality) {
    m_target->bind();
    m_renderer->renderStatic(frame, viewOf(quality));
    m_renderer->renderMoving(frame, viewOf(quality));
    return m_target->toImage().convertToFormat(QImage::Format_RGB32);
}

MazeRenderer::StaticScene OffscreenPicture::staticSceneOf(const Frame &frame, Quality quality) {
    return m_renderer->staticSceneOf(frame, viewOf(quality));
}

QPoint OffscreenPicture::pixelOf(const glm::dvec3 &place) const {
    const glm::dvec2 pixel = m_camera.project(place);
    return {static_cast<int>(pixel.x), static_cast<int>(pixel.y)};
}
