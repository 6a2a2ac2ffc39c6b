// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ruler.h"

#include "core/setup/inputs.h"
#include "gl/view/maze_view.h"

#include <QLabel>
#include <QMouseEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

const gl::Colour kRulerColour(1.0F, 0.85F, 0.1F, 1.0F);
constexpr float kWidth = 2.5F; ///< logical pixels
constexpr float kEnd = 8.0F;
constexpr double kAbove = 5e-4;   ///< m, height of the line above the floor
constexpr QPoint kBeside(14, 14); ///< offset of the text from the cursor

QString textOf(const glm::dvec3 &way) {
    const double angle = degrees(std::atan2(way.y, way.x));
    return QStringLiteral("%1 mm · %2°").arg(1e3 * glm::length(way), 0, 'f', 2).arg(angle, 0, 'f', 1);
}

} // namespace

Ruler::Ruler(gl::MazeView &view, QObject *parent)
    : QObject(parent)
    , m_view(view)
    , m_text(new QLabel(&view)) {
    m_text->setObjectName(QStringLiteral("ruler"));
    m_text->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_text->setAutoFillBackground(true);
    m_text->setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setMargin(4);
    m_text->setAccessibleName(tr("Length and angle measured"));
    m_text->hide();
    view.installEventFilter(this);
}

bool Ruler::eventFilter(QObject *, QEvent *event) {
    const auto mouse = [event]() -> const QMouseEvent & { return *static_cast<const QMouseEvent *>(event); };
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        dismiss();
        return mouse().button() == Qt::LeftButton && mouse().modifiers() & Qt::ShiftModifier &&
               begin(mouse().position());
    case QEvent::MouseMove:
        if (m_isDragged) drawTo(mouse().position());
        return m_isDragged;
    case QEvent::MouseButtonRelease:
        return std::exchange(m_isDragged, false);
    default:
        return false;
    }
}

std::optional<glm::dvec3> Ruler::floorAt(const QPointF &place) const {
    const gl::Ray ray = m_view.rayAt(place);
    if (ray.direction.z >= 0.0) return std::nullopt;
    return ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
}

bool Ruler::begin(const QPointF &place) {
    const std::optional<glm::dvec3> point = floorAt(place);
    if (!point) return false;
    m_from = m_to = *point;
    m_isDragged = true;
    return true;
}

void Ruler::drawTo(const QPointF &place) {
    const std::optional<glm::dvec3> point = floorAt(place);
    if (!point) return;
    m_to = *point;
    m_isShown = true;
    m_text->setText(textOf(m_to - m_from));
    m_text->adjustSize();
    const QPoint most(m_view.width() - m_text->width(), m_view.height() - m_text->height());
    const QPoint wanted = place.toPoint() + kBeside;
    m_text->move(std::clamp(wanted.x(), 0, std::max(most.x(), 0)), std::clamp(wanted.y(), 0, std::max(most.y(), 0)));
    m_text->show();
    m_view.update();
}

void Ruler::addTo(gl::Strokes &strokes) const {
    if (!m_isShown) return;
    const glm::dvec3 above(0.0, 0.0, kAbove);
    strokes.line(m_from + above, m_to + above, kRulerColour, kWidth);
    for (const glm::dvec3 &end : {m_from, m_to}) strokes.point(end + above, kRulerColour, kEnd);
}

bool Ruler::dismiss() {
    if (!std::exchange(m_isShown, false)) return false;
    m_text->hide();
    m_view.update();
    return true;
}

} // namespace inspector::ui
