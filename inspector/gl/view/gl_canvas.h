// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/view/frame_painter.h"

#include <QOpenGLWidget>

namespace inspector::gl {

/// Draws by OpenGL directly onto the screen; Qt then composes the whole window by OpenGL, which is cheap on a graphics
/// card. GUI thread only.
class GlCanvas : public QOpenGLWidget, public Canvas {
    Q_OBJECT

public:
    /// host must outlive the canvas.
    GlCanvas(CanvasHost &host, QWidget *parent);
    ~GlCanvas() override;

    QWidget &widget() override { return *this; }
    void setMaze(const Mesh &mesh) override { m_painter.setMaze(mesh); }
    void setBall(const Mesh &mesh) override { m_painter.setBall(mesh); }
    QImage picture(const Frame &frame, int scale) override;
    QImage shown() override { return grabFramebuffer(); }
    QString name() const override { return m_painter.name(); }
    void setQuality(std::optional<Quality> quality) override { m_painter.setQuality(quality); }
    Quality quality() const override { return m_painter.quality(); }
    void setShaderDirectory(const QString &path) override { m_painter.setShaderDirectory(path); }

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseResources();

    FramePainter m_painter;
};

} // namespace inspector::gl
