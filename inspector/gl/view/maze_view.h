// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/view/canvas.h"

#include <functional>
#include <memory>
#include <optional>

#include <QPointF>
#include <QTimer>

namespace inspector::gl {

enum class Drawing {
    Solid,   ///< by OpenGL, the cheaper of Screen and Picture
    Screen,  ///< directly onto the screen
    Picture, ///< into an image
    Flat,    ///< without OpenGL, from above
};

/// The board as a widget. Left drag orbits, right or middle drag pans, the wheel zooms to the cursor, a double click
/// resets the camera to show everything. Keys are left to the window. GUI thread only.
class MazeView : public QWidget, private CanvasHost {
    Q_OBJECT

public:
    explicit MazeView(Drawing drawing = Drawing::Solid, QWidget *parent = nullptr);
    ~MazeView() override;

    Drawing drawing() const { return m_drawing; } ///< never Solid
    /// Requests a redraw.
    void update();

    /// May be called before the widget is shown. A maze with other bounds resets the camera.
    void setMaze(const Mesh &mesh);
    /// Largest tilt in x and in y, rad, at which the whole board stays in the picture. Initially 0.
    void setLargestTilt(double tilt);
    void setBall(const Mesh &mesh); ///< radius 1 around the origin

    /// Asks `source` for a frame before each picture, up to 60 times a second while visible and while `isNew` returns
    /// true; null ends that.
    void setFrameSource(
        std::function<Frame()> source, std::function<bool()> isNew = [] { return true; });
    /// The number of pictures drawn.
    uint64_t pictures() const { return m_pictures; }

    /// Empty (as initially): the best quality that is drawn in time.
    void setQuality(std::optional<Quality> quality);
    Quality quality() const { return m_canvas->quality(); }

    /// Shader files in this directory replace the embedded ones, also while running; empty: embedded only.
    void setShaderDirectory(const QString &path);

    OrbitCamera &camera() { return m_camera; }
    /// Shows everything from the start direction.
    void resetCamera();
    void lookFromAbove();
    /// As a left drag by so many logical pixels does.
    void orbit(const QPointF &drag);
    /// As so many steps of the wheel at a point of this widget do; > 0 zooms in.
    void zoom(double steps, const QPointF &place);
    /// The camera follows the ball at a shorter distance, until switched off or reset.
    void setFollowing(bool isOn);
    bool isFollowing() const { return m_isFollowing; }

    /// Time until the last picture was finished, ms; 0 before the first.
    double lastFrameMilliseconds() const { return m_frameMilliseconds; }
    /// The renderer, for instance "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first picture.
    QString rendererName() const { return m_canvas->name(); }
    /// The current picture, `scale` (1 to 4) pixels per device pixel; null before the first.
    QImage picture(int scale) { return m_canvas->picture(m_frame, scale); }
    /// The pixels on the screen.
    QImage grabFramebuffer() { return m_canvas->shown(); }
    /// The ray through a point of this widget, in the board frame.
    Ray rayAt(const QPointF &place) const;
    /// Where a point (board frame, m) is drawn, in logical pixels of this widget.
    QPointF positionOf(const glm::dvec3 &boardPoint) const;

signals:
    /// A click without a drag, as a ray in the board frame.
    void clicked(const inspector::gl::Ray &ray);
    /// One line or a shader log; drawing continues with what there is.
    void problem(const QString &text);
    void shadersRebuilt();
    void followingChanged(bool isOn);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    const Frame &nextFrame() override;
    View view() const override;
    const OrbitCamera &lookedThrough() const override { return m_camera; }
    glm::dmat4 boardPose() const override;
    void noteDrawn(double milliseconds) override { m_frameMilliseconds = milliseconds; }
    void noteProblem(const QString &text) override { emit problem(text); }
    void noteRebuilt() override { emit shadersRebuilt(); }
    void noteUnusable(const QString &reason) override;

    void makeCanvas(Drawing drawing);
    void keepVisible(Ball &ball) const;

    Drawing m_drawing = Drawing::Flat;
    Canvas *m_canvas = nullptr; ///< a child
    OrbitCamera m_camera;
    Frame m_frame;
    std::function<Frame()> m_source;
    std::function<bool()> m_isNew;
    uint64_t m_pictures = 0;
    QTimer m_pulse;
    Mesh m_maze; ///< kept for a new canvas
    std::optional<Mesh> m_ball;
    Bounds m_bounds;
    double m_largestTilt = 0.0; ///< rad
    QString m_shaderDirectory;
    double m_frameMilliseconds = 0.0;
    QPointF m_pressPosition;
    QPointF m_lastPosition;
    bool m_isDragging = false;
    bool m_isCameraMoved = false; ///< by the user; until then resizing shows everything
    bool m_isFollowing = false;
};

} // namespace inspector::gl
