// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/canvas.h"

#include <memory>
#include <optional>

#include <QOpenGLWidget>

QT_BEGIN_NAMESPACE
class QOpenGLFramebufferObject;
QT_END_NAMESPACE

namespace inspector::gl {

class MazeRenderer;

// Draws by OpenGL. GUI thread only.
class GlCanvas : public QOpenGLWidget, public Canvas {
    Q_OBJECT

public:
    // host: outlives the canvas.
    GlCanvas(CanvasHost &host, QWidget *parent);
    ~GlCanvas() override;

    QWidget &widget() override { return *this; }
    void setMaze(const Mesh &mesh) override;
    void setBall(const Mesh &mesh) override;
    QImage picture(const Frame &frame, int scale) override;
    QImage shown() override { return grabFramebuffer(); }
    QString name() const override { return m_renderer_name; }
    // Until called: Medium for a software renderer, High otherwise.
    void setQuality(Quality quality) override;
    Quality quality() const override { return m_quality; }
    void setShaderDirectory(const QString &path) override;

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseResources();
    void startDebugLogger();
    void uploadMeshes();
    void renderMultisampled(const Frame &frame, const View &view);

    CanvasHost &m_host;
    Mesh m_maze; // kept for the next context
    std::optional<Mesh> m_ball;
    bool m_are_meshes_stale = true;
    QString m_shader_directory;
    std::optional<Quality> m_chosen_quality;
    Quality m_quality = Quality::Medium;
    QString m_renderer_name;

    std::unique_ptr<MazeRenderer> m_renderer; // these two live and die with the context
    std::unique_ptr<QOpenGLFramebufferObject> m_multisampled;
};

} // namespace inspector::gl
