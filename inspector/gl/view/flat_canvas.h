// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/view/canvas.h"

#include <vector>

class QPainter;

namespace inspector::gl {

/// Draws without OpenGL, for a camera that looks from above: painter's algorithm in order of height. The table shows
/// through holes in the floor. While the board doesn't move, the picture of board and table is kept.
class FlatCanvas : public QWidget, public Canvas {
public:
    /// host must outlive the canvas.
    FlatCanvas(CanvasHost &host, QWidget *parent);

    QWidget &widget() override { return *this; }
    void setMaze(const Mesh &mesh) override;
    void setBall(const Mesh &) override {} ///< the ball is drawn as a disc
    QImage picture(const Frame &frame, int scale) override;
    QImage shown() override { return grab().toImage(); }
    QString name() const override;
    /// Low: without smoothing edges, which takes most of the time.
    void setQuality(std::optional<Quality> quality) override;
    Quality quality() const override { return m_quality; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Triangle {
        glm::dvec3 corners[3];
        glm::vec3 colour; ///< sRGB, shaded
        float height;     ///< of its middle, m
    };
    using Projection = glm::dmat4; ///< board to clip

    /// Everything that determines the picture of board and table; the maze clears it.
    struct BoardLook {
        Projection projection{0.0};
        QSize pixels;
        Quality quality = Quality::Low;
        Backdrop backdrop;
        bool operator==(const BoardLook &) const = default;
    };

    Projection projection() const;
    QImage blank(double pixelRatio) const; ///< of this widget's size
    void paintKeptBoard(QPainter &painter, const Projection &projection);
    void paintBoard(QPainter &painter, const Projection &projection) const;
    void paintMoving(QPainter &painter, const Projection &projection, const Frame &frame) const;
    void paintMaze(QPainter &painter, const Projection &projection) const;
    void paintBall(QPainter &painter, const Projection &projection, const Ball &ball) const;
    void paintGhost(QPainter &painter, const Projection &projection, const GhostBall &ghost) const;
    void paintStrokes(QPainter &painter, const Projection &projection, const Frame &frame) const;
    QPointF place(const Projection &projection, const glm::dvec3 &point) const;
    double discRadius(const Projection &projection, const Ball &ball) const;

    CanvasHost &m_host;
    Quality m_quality = Quality::Medium;
    std::vector<Triangle> m_triangles; ///< lowest first
    BoardLook m_look;                  ///< of the last picture
    QImage m_board;                    ///< kept once two pictures in a row share that look
};

} // namespace inspector::gl
