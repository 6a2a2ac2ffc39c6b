// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/frame.h"
#include "gl/orbit_camera.h"
#include "mesh/mesh.h"

#include <functional>
#include <memory>
#include <optional>

#include <QImage>
#include <QOpenGLWidget>
#include <QPointF>
#include <QString>
#include <QTimer>

QT_BEGIN_NAMESPACE
class QOpenGLFramebufferObject;
QT_END_NAMESPACE

namespace inspector::gl {

class MazeRenderer;

// The picture as a widget: left drag orbits, right or middle drag pans, the wheel zooms to the cursor, a double click
// shows everything again. Keys are left to the window. GUI thread only.
class MazeView : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit MazeView(QWidget *parent = nullptr);
    ~MazeView() override;

    // May be called before the widget is shown. A maze of other bounds resets the camera.
    void setMaze(const Mesh &mesh);
    // rad, in x and in y: up to there the whole board stays in the picture. 0 until told.
    void setLargestTilt(double tilt);
    void setBall(const Mesh &mesh); // radius 1 around the origin

    // Draws this frame once...
    void setFrame(const Frame &frame);
    // ...or asks `source` for one before each picture, up to 60 times a second while visible and while `isNew` says
    // that there is another one to show; null ends that.
    void setFrameSource(
        std::function<Frame()> source, std::function<bool()> isNew = [] { return true; });
    // How many pictures were drawn.
    uint64_t pictures() const { return m_pictures; }

    // Until called, the view chooses: Medium for a software renderer, High otherwise.
    void setQuality(Quality quality);
    Quality quality() const { return m_quality; }

    // Shader files here replace the embedded ones, also while running; empty: embedded only.
    void setShaderDirectory(const QString &path);

    OrbitCamera &camera() { return m_camera; }
    // Shows everything from the start direction.
    void resetCamera();

    // Time that the last picture took until it was finished, ms; 0 before the first.
    double lastFrameMilliseconds() const { return m_frame_milliseconds; }
    // What draws, for instance "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first picture.
    QString rendererName() const { return m_renderer_name; }
    // The picture as it is now, `scale` pixels for each of the device, 1 to 4; null before the first.
    QImage picture(int scale);
    // The ray under a place of this widget, in the board frame.
    Ray rayAt(const QPointF &place) const;
    // Where a point of the board (board frame, m) is drawn, in logical pixels of this widget.
    QPointF positionOf(const glm::dvec3 &board_point) const;

signals:
    // A click without a drag, as a ray in the board frame.
    void clicked(const inspector::gl::Ray &ray);
    // One line or a shader log; the view goes on with what it has.
    void problem(const QString &text);
    void shadersRebuilt();

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void releaseResources();
    void startDebugLogger();
    void uploadMeshes();
    View currentView() const;
    glm::dmat4 boardPose() const;
    void renderMultisampled(const View &view);

    OrbitCamera m_camera;
    Frame m_frame;
    std::function<Frame()> m_source;
    std::function<bool()> m_is_new;
    uint64_t m_pictures = 0;
    QTimer m_pulse;
    Mesh m_maze; // kept for the next context
    std::optional<Mesh> m_ball;
    bool m_are_meshes_stale = true;
    Bounds m_bounds;
    double m_largest_tilt = 0.0; // rad
    QString m_shader_directory;
    std::optional<Quality> m_chosen_quality;
    Quality m_quality = Quality::Medium;
    QString m_renderer_name;
    double m_frame_milliseconds = 0.0;
    QPointF m_press_position;
    QPointF m_last_position;
    bool m_is_dragging = false;
    bool m_is_camera_moved = false; // by hand; until then a resized view shows everything

    std::unique_ptr<MazeRenderer> m_renderer; // these two live and die with the context
    std::unique_ptr<QOpenGLFramebufferObject> m_multisampled;
};

} // namespace inspector::gl
