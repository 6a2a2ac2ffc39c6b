// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/maze_renderer.h"
#include "gl/view/canvas.h"
#include "gl/view/quality_chooser.h"

#include <functional>
#include <memory>
#include <optional>

#include <QObject>

QT_BEGIN_NAMESPACE
class QOpenGLFramebufferObject;
QT_END_NAMESPACE

namespace inspector::gl {

/// Common parts of the OpenGL canvases: meshes, quality, and drawing a frame into a framebuffer. GUI thread only; some
/// functions need the canvas's context current.
class FramePainter : public QObject {
    Q_OBJECT

public:
    /// host must outlive the painter.
    explicit FramePainter(CanvasHost &host);
    ~FramePainter() override;

    void setMaze(const Mesh &mesh);
    void setBall(const Mesh &mesh);
    /// Empty (as initially): chosen automatically, starting with Medium for a software renderer and High otherwise.
    void setQuality(std::optional<Quality> quality);
    Quality quality() const { return m_setQuality.value_or(m_chooser.quality()); }
    void setShaderDirectory(const QString &path);
    /// The renderer's name; empty before the first picture.
    QString name() const { return m_name; }

    /// Call once for each new context, while it is current; reports to the host if it is unusable.
    void begin();
    /// Call before that context is destroyed, while it is current.
    void end();

    /// Draws the host's next frame and waits until it is finished; the context must be current. framebuffer: of the
    /// size of the host's view, with depth and stencil.
    void paint(unsigned framebuffer);
    /// Draws into a multisampled framebuffer of its own, `scale` pixels per device pixel; the context must be current.
    QImage picture(const Frame &frame, int scale);

signals:
    void changed(); ///< a redraw is needed

private:
    void startDebugLogger();
    void uploadMeshes();
    bool render(const Frame &frame, const View &view, unsigned framebuffer);
    void copy(unsigned from, unsigned to, const View &view, unsigned buffers);
    unsigned unsmoothed(const View &view); ///< framebuffer whose picture is antialiased afterwards
    void makeStaticPicture(const Frame &frame, const View &view);

    CanvasHost &m_host;
    Mesh m_maze; ///< kept for the next context
    std::optional<Mesh> m_ball;
    bool m_areMeshesStale = true;
    QString m_shaderDirectory;
    std::optional<Quality> m_setQuality;
    QualityChooser m_chooser{Quality::Medium};
    QString m_name;

    std::unique_ptr<MazeRenderer> m_renderer; ///< these three belong to the context
    std::unique_ptr<QOpenGLFramebufferObject> m_unsmoothed;
    std::unique_ptr<QOpenGLFramebufferObject>
        m_staticPicture;                     ///< cached board and table, made when two frames in a row share them
    MazeRenderer::StaticScene m_staticScene; ///< of the last frame
};

} // namespace inspector::gl
