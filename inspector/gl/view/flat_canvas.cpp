// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view/flat_canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QElapsedTimer>
#include <QPainter>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace inspector::gl {

namespace {

const glm::vec3 kLight = glm::normalize(glm::vec3(-0.4F, 0.5F, 1.2F)); ///< direction to the light, board frame
constexpr float kAmbient = 0.45F;
constexpr double kSeam = 1.5;     ///< pen width around a smoothed triangle, pixels, to cover seams
constexpr double kMark = 0.32;    ///< share of the ball's radius: spots that show its rotation
constexpr double kSpacing = 1e-4; ///< between a trail's points, m
const QColor kBallColour(0xd8, 0xdc, 0xe0);
const QColor kMarkColour(0xc6, 0x28, 0x28);

QColor toQColor(const glm::vec3 &colour) {
    const glm::vec3 inside = glm::clamp(colour, 0.0F, 1.0F);
    return QColor::fromRgbF(inside.r, inside.g, inside.b);
}

QColor toQColor(const Colour &colour) {
    QColor result = toQColor(glm::vec3(colour));
    result.setAlphaF(std::clamp(colour.a, 0.0F, 1.0F));
    return result;
}

} // namespace

FlatCanvas::FlatCanvas(CanvasHost &host, QWidget *parent)
    : QWidget(parent)
    , m_host(host) {}

QString FlatCanvas::name() const { return QStringLiteral("QPainter, from above"); }

void FlatCanvas::setMaze(const Mesh &mesh) {
    m_triangles.clear();
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle triangle{};
        glm::dvec3 middle(0.0);
        for (size_t corner = 0; corner < 3; ++corner) {
            triangle.corners[corner] = glm::dvec3(mesh.vertices[mesh.indices[i + corner]].position);
            middle += triangle.corners[corner] / 3.0;
        }
        const Vertex &vertex = mesh.vertices[mesh.indices[i]];
        const float own = static_cast<float>(vertex.surface.a) / 255.0F; // emission
        const float lit = kAmbient + (1.0F - kAmbient) * std::max(0.0F, glm::dot(vertex.normal, kLight));
        triangle.colour = glm::vec3(vertex.albedo) / 255.0F * std::max(lit, own);
        triangle.height = static_cast<float>(middle.z);
        m_triangles.push_back(triangle);
    }
    std::stable_sort(m_triangles.begin(), m_triangles.end(),
                     [](const Triangle &a, const Triangle &b) { return a.height < b.height; });
    m_look = {};
    update();
}

void FlatCanvas::setQuality(std::optional<Quality> quality) {
    m_quality = quality.value_or(Quality::Medium);
    update();
}

QPointF FlatCanvas::place(const Projection &projection, const glm::dvec3 &point) const {
    const glm::dvec4 clip = projection * glm::dvec4(point, 1.0);
    return {0.5 * (1.0 + clip.x / clip.w) * width(), 0.5 * (1.0 - clip.y / clip.w) * height()};
}

void FlatCanvas::paintEvent(QPaintEvent *) {
    QElapsedTimer timer;
    timer.start();
    const Frame &frame = m_host.nextFrame();
    QPainter painter(this);
    paintKeptBoard(painter, projection());
    paintMoving(painter, projection(), frame);
    m_host.noteDrawn(1e-6 * static_cast<double>(timer.nsecsElapsed()));
}

QImage FlatCanvas::picture(const Frame &frame, int scale) {
    QImage image = blank(devicePixelRatioF() * scale);
    QPainter painter(&image);
    paintBoard(painter, projection());
    paintMoving(painter, projection(), frame);
    painter.end();
    image.setDevicePixelRatio(1.0);
    return image;
}

FlatCanvas::Projection FlatCanvas::projection() const {
    const View view = m_host.view();
    return view.projection * view.view * m_host.boardPose();
}

QImage FlatCanvas::blank(double pixelRatio) const {
    QImage image((QSizeF(size()) * pixelRatio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

/// A board that moves is drawn directly, because its picture would be used only once.
void FlatCanvas::paintKeptBoard(QPainter &painter, const Projection &projection) {
    const BoardLook look{projection, size() * devicePixelRatioF(), m_quality, m_host.view().backdrop};
    if (look != std::exchange(m_look, look)) {
        m_board = {};
        return paintBoard(painter, projection);
    }
    if (m_board.isNull()) {
        m_board = blank(devicePixelRatioF());
        QPainter kept(&m_board);
        paintBoard(kept, projection);
    }
    painter.drawImage(0, 0, m_board);
}

void FlatCanvas::paintBoard(QPainter &painter, const Projection &projection) const {
    painter.setRenderHint(QPainter::Antialiasing, m_quality != Quality::Low);
    painter.fillRect(rect(), toQColor(m_host.view().backdrop.table));
    paintMaze(painter, projection);
}

void FlatCanvas::paintMoving(QPainter &painter, const Projection &projection, const Frame &frame) const {
    painter.setRenderHint(QPainter::Antialiasing, m_quality != Quality::Low);
    paintStrokes(painter, projection, frame);
    for (const GhostBall &ghost : frame.ghosts) paintGhost(painter, projection, ghost);
    paintBall(painter, projection, frame.ball);
}

/// Back faces are culled: on the screen they are clockwise. Only between smoothed edges are there seams to cover.
void FlatCanvas::paintMaze(QPainter &painter, const Projection &projection) const {
    const bool hasSeams = painter.testRenderHint(QPainter::Antialiasing);
    for (const Triangle &triangle : m_triangles) {
        QPointF corners[3];
        for (int i = 0; i < 3; ++i) corners[i] = place(projection, triangle.corners[i]);
        const QPointF a = corners[1] - corners[0];
        const QPointF b = corners[2] - corners[0];
        if (a.x() * b.y() - a.y() * b.x() >= 0.0) continue; // y points down
        const QColor colour = toQColor(triangle.colour);
        painter.setPen(hasSeams ? QPen(colour, kSeam) : QPen(Qt::NoPen));
        painter.setBrush(colour);
        painter.drawConvexPolygon(corners, 3);
    }
}

double FlatCanvas::discRadius(const Projection &projection, const Ball &ball) const {
    const QPointF reach =
        place(projection, ball.position + glm::dvec3(ball.radius, 0.0, 0.0)) - place(projection, ball.position);
    return std::hypot(reach.x(), reach.y());
}

/// Spots at the ends of the ball's axes, if visible from above.
void FlatCanvas::paintBall(QPainter &painter, const Projection &projection, const Ball &ball) const {
    const QPointF middle = place(projection, ball.position);
    const double radius = discRadius(projection, ball);
    QRadialGradient shine(middle - QPointF(0.3, 0.35) * radius, 1.5 * radius);
    shine.setColorAt(0.0, Qt::white);
    shine.setColorAt(0.5, kBallColour);
    shine.setColorAt(1.0, kBallColour.darker(200));
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
    painter.setBrush(shine);
    painter.drawEllipse(middle, radius, radius);
    const auto &q = ball.orientation;
    const glm::dmat3 turn = glm::mat3_cast(glm::dquat(q[3], q[0], q[1], q[2]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(kMarkColour);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const glm::dvec3 end = sign * turn[axis];
            if (end.z <= 0.0) continue;
            const double reach = ball.radius * (1.0 - kMark);
            const QPointF spot = place(projection, ball.position + reach * glm::dvec3(end.x, end.y, 0.0));
            painter.drawEllipse(spot, kMark * radius, kMark * radius * std::max(end.z, 0.3));
        }
}

void FlatCanvas::paintGhost(QPainter &painter, const Projection &projection, const GhostBall &ghost) const {
    const double radius = discRadius(projection, ghost.ball);
    const QColor colour = toQColor(ghost.colour);
    painter.setPen(QPen(colour.darker(150), 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(place(projection, ghost.ball.position), radius, radius);
}

void FlatCanvas::paintStrokes(QPainter &painter, const Projection &projection, const Frame &frame) const {
    Strokes strokes;
    for (const Trail &trail : frame.trails) strokes.trail(trail.points, trail.colour, trail.width, kSpacing);
    for (const Strokes *all : {static_cast<const Strokes *>(&strokes), &frame.strokes}) {
        for (const Stroke &stroke : all->all()) {
            const Qt::PenCapStyle ends = stroke.roundEnds > 0.5F ? Qt::RoundCap : Qt::FlatCap;
            const QColor colour = toQColor(0.5F * (stroke.fromColour + stroke.toColour));
            painter.setPen(QPen(colour, stroke.width, Qt::SolidLine, ends));
            const QPointF from = place(projection, glm::dvec3(stroke.from));
            const QPointF to = place(projection, glm::dvec3(stroke.to));
            from == to ? painter.drawPoint(from) : painter.drawLine(from, to);
        }
    }
}

} // namespace inspector::gl
