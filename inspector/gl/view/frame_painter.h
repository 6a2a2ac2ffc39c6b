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

// What canvases that draw by OpenGL have in common: meshes, quality, and how a frame gets into a framebuffer. GUI
// thread only; what says so needs the canvas's context current.
class FramePainter : public QObject {
    Q_OBJECT

public:
    // host: outlives the painter.
    explicit FramePainter(CanvasHost &host);
    ~FramePainter() override;

    void setMaze(const Mesh &mesh);
    void setBall(const Mesh &mesh);
    // Until called chosen, from Medium on for a software renderer, from High otherwise.
    void setQuality(std::optional<Quality> quality);
    Quality quality() const { return m_setQuality.value_or(m_chooser.quality()); }
    void setShaderDirectory(const QString &path);
    // What draws; empty before the first picture.
    QString name() const { return m_name; }

    // For the context that is current, once for each; tells the host if it can't be used.
    void begin();
    // Before that context goes; it is current.
    void end();

    // Draws the host's next frame and waits until it is finished; the context is current. framebuffer: with depths and
    // stencil, of as many pixels as the host's view.
    void paint(unsigned framebuffer);
    // Into a framebuffer of its own, with as many samples as there are, `scale` pixels for each of the device; the
    // context is current.
    QImage picture(const Frame &frame, int scale);

signals:
    void changed(); // a new picture is due

private:
    void startDebugLogger();
    void uploadMeshes();
    bool render(const Frame &frame, const View &view, unsigned framebuffer);
    void copy(unsigned from, unsigned to, const View &view, unsigned buffers);
    unsigned unsmoothed(const View &view); // to draw into what is smoothed then
    void makeStaticPicture(const Frame &frame, const View &view);

    CanvasHost &m_host;
    Mesh m_maze; // kept for the next context
    std::optional<Mesh> m_ball;
    bool m_areMeshesStale = true;
    QString m_shaderDirectory;
    std::optional<Quality> m_setQuality;
    QualityChooser m_chooser{Quality::Medium};
    QString m_name;

    std::unique_ptr<MazeRenderer> m_renderer; // these three live and die with the context
    std::unique_ptr<QOpenGLFramebufferObject> m_unsmoothed;
    std::unique_ptr<QOpenGLFramebufferObject> m_staticPicture; // of board and table, once two frames had them alike
    MazeRenderer::StaticScene m_staticScene;                   // of the last frame
};

} // namespace inspector::gl
