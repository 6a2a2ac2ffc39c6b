// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/view/frame_painter.h"

#include <memory>

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace inspector::gl {

/// Draws by OpenGL into an image, which Qt paints like any other widget: cheap with a software renderer, which would
/// have to compose the whole window for each picture otherwise. GUI thread only.
class ImageCanvas : public QWidget, public Canvas {
    Q_OBJECT

public:
    /// host must outlive the canvas.
    ImageCanvas(CanvasHost &host, QWidget *parent);
    ~ImageCanvas() override;

    QWidget &widget() override { return *this; }
    void setMaze(const Mesh &mesh) override { m_painter.setMaze(mesh); }
    void setBall(const Mesh &mesh) override { m_painter.setBall(mesh); }
    QImage picture(const Frame &frame, int scale) override;
    QImage shown() override;
    QString name() const override { return m_painter.name(); }
    void setQuality(std::optional<Quality> quality) override { m_painter.setQuality(quality); }
    Quality quality() const override { return m_painter.quality(); }
    void setShaderDirectory(const QString &path) override { m_painter.setShaderDirectory(path); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    bool makeCurrent();
    void makeContext();
    QImage draw();

    CanvasHost &m_host;
    FramePainter m_painter;
    QOffscreenSurface m_surface;
    std::unique_ptr<QOpenGLContext> m_context; ///< created with the first picture
    std::unique_ptr<QOpenGLFramebufferObject> m_target;
};

} // namespace inspector::gl
