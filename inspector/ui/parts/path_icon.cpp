// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/path_icon.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace inspector::ui {

namespace {

/// Shapes in a 16 x 16 square.
constexpr double kSide = 16.0;

struct Drawing {
    QPainterPath filled;
    QPainterPath stroked;
};

QPainterPath triangle(double left, double right) {
    QPainterPath path(QPointF(left, 3.0));
    path.lineTo(right, 8.0);
    path.lineTo(left, 13.0);
    path.closeSubpath();
    return path;
}

QPainterPath line(std::initializer_list<QPointF> points) {
    QPainterPath path(*points.begin());
    for (const QPointF &point : points) path.lineTo(point);
    return path;
}

/// The return arrow: counter-clockwise to the upper left, with an arrow head there.
Drawing turnBack() {
    Drawing drawing;
    const QRectF circle(3.0, 3.0, 10.0, 10.0);
    drawing.stroked.arcMoveTo(circle, -150.0);
    drawing.stroked.arcTo(circle, -150.0, 285.0);
    const QPointF end = drawing.stroked.currentPosition();
    const QPointF ahead(-1.8, 1.8); // tangent of the circle there
    const QPointF aside(1.8, 1.8);
    drawing.filled = line({end + ahead, end + aside, end - aside});
    drawing.filled.closeSubpath();
    return drawing;
}

Drawing drawingOf(Glyph glyph) {
    Drawing drawing;
    switch (glyph) {
    case Glyph::Run:
        drawing.filled = triangle(4.0, 13.0);
        break;
    case Glyph::Pause:
        drawing.filled.addRect(4.0, 3.0, 3.0, 10.0);
        drawing.filled.addRect(9.0, 3.0, 3.0, 10.0);
        break;
    case Glyph::Step:
        drawing.filled.addRect(3.0, 3.0, 2.0, 10.0);
        drawing.filled.addPath(triangle(6.0, 13.0));
        break;
    case Glyph::StepBack:
        drawing.filled.addRect(11.0, 3.0, 2.0, 10.0);
        drawing.filled.addPath(triangle(10.0, 3.0));
        break;
    case Glyph::BounceBack:
        drawing.stroked = line({{4.0, 4.0}, {8.0, 12.5}, {12.0, 4.0}});
        drawing.stroked.addPath(line({{2.5, 7.5}, {4.0, 4.0}, {7.5, 5.5}}));
        break;
    case Glyph::BounceOn:
        drawing.stroked = line({{4.0, 4.0}, {8.0, 12.5}, {12.0, 4.0}});
        drawing.stroked.addPath(line({{8.5, 5.5}, {12.0, 4.0}, {13.5, 7.5}}));
        break;
    case Glyph::Restart:
    case Glyph::Begin:
        drawing.filled.addRect(3.0, 3.0, 2.0, 10.0);
        drawing.filled.addPath(triangle(13.0, 6.0));
        break;
    case Glyph::End:
        drawing.filled.addRect(11.0, 3.0, 2.0, 10.0);
        drawing.filled.addPath(triangle(3.0, 10.0));
        break;
    case Glyph::Autopilot: // a path through a maze
        drawing.stroked = line({{3.0, 13.0}, {3.0, 7.0}, {9.0, 7.0}, {9.0, 3.0}, {13.0, 3.0}});
        drawing.filled.addEllipse(QPointF(3.0, 13.0), 2.0, 2.0);
        break;
    case Glyph::Reset:
        drawing = turnBack();
        break;
    case Glyph::Close:
        drawing.stroked = line({{4.0, 4.0}, {12.0, 12.0}});
        drawing.stroked.addPath(line({{12.0, 4.0}, {4.0, 12.0}}));
        break;
    case Glyph::Warning:
        drawing.stroked = line({{8.0, 2.0}, {14.5, 13.5}, {1.5, 13.5}, {8.0, 2.0}});
        drawing.stroked.addPath(line({{8.0, 6.0}, {8.0, 9.5}}));
        drawing.filled.addEllipse(QPointF(8.0, 11.7), 0.8, 0.8);
        break;
    case Glyph::Clear:
        drawing.stroked = line({{3.0, 4.5}, {13.0, 4.5}});
        drawing.stroked.addPath(line({{4.5, 4.5}, {5.2, 13.5}, {10.8, 13.5}, {11.5, 4.5}}));
        drawing.stroked.addPath(line({{6.5, 4.5}, {6.5, 2.5}, {9.5, 2.5}, {9.5, 4.5}}));
        break;
    case Glyph::Save:
        drawing.stroked = line({{3.0, 10.0}, {3.0, 13.5}, {13.0, 13.5}, {13.0, 10.0}});
        drawing.stroked.addPath(line({{8.0, 2.0}, {8.0, 9.5}}));
        drawing.stroked.addPath(line({{5.0, 6.8}, {8.0, 9.8}, {11.0, 6.8}}));
        break;
    case Glyph::Open:
        drawing.stroked = line({{2.0, 13.0}, {2.0, 3.5}, {6.5, 3.5}, {8.0, 5.5}, {12.5, 5.5}, {12.5, 7.5}});
        drawing.stroked.addPath(line({{2.0, 13.0}, {4.5, 7.5}, {14.5, 7.5}, {12.0, 13.0}, {2.0, 13.0}}));
        break;
    case Glyph::Add:
        drawing.stroked = line({{8.0, 3.0}, {8.0, 13.0}});
        drawing.stroked.addPath(line({{3.0, 8.0}, {13.0, 8.0}}));
        break;
    case Glyph::More:
        drawing.stroked = line({{3.0, 4.0}, {7.0, 8.0}, {3.0, 12.0}});
        drawing.stroked.addPath(line({{9.0, 4.0}, {13.0, 8.0}, {9.0, 12.0}}));
        break;
    case Glyph::Follow:
        drawing.stroked = line({{2.0, 8.0}, {11.0, 8.0}});
        drawing.stroked.addPath(line({{8.0, 5.0}, {11.0, 8.0}, {8.0, 11.0}}));
        drawing.stroked.addPath(line({{13.5, 3.0}, {13.5, 13.0}}));
        break;
    }
    return drawing;
}

class PathIconEngine : public QIconEngine {
public:
    explicit PathIconEngine(Glyph glyph)
        : m_glyph(glyph) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor colour = QApplication::palette().color(group, QPalette::ButtonText);
        const Drawing drawing = drawingOf(m_glyph);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / kSide, rect.height() / kSide);
        painter->fillPath(drawing.filled, colour);
        painter->strokePath(drawing.stroked, QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->restore();
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new PathIconEngine(m_glyph); }

private:
    Glyph m_glyph;
};

} // namespace

QIcon glyphIcon(Glyph glyph) { return QIcon(new PathIconEngine(glyph)); }

} // namespace inspector::ui
