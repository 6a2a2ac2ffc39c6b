// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ball/ball_dragger.h"

#include "core/setup/ball_place.h"
#include "ui/ball/ball_command.h"
#include "ui/parts/board_vector.h"

#include <QLineF>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace inspector::ui {

namespace {

constexpr double kReach = 12.0;   ///< logical pixels, so that a tiny ball can be grabbed, too
constexpr double kSlowest = 1e-4; ///< m/s, smallest velocity with a visible arrow
const gl::Colour kArrowColour{0.10F, 0.45F, 0.85F, 0.95F};

/// Intersects the ray with the plane at this height; nothing if it misses.
std::optional<glm::dvec3> pointAt(const gl::Ray &ray, double height) {
    if (std::abs(ray.direction.z) < 1e-9) return std::nullopt;
    const double along = (height - ray.origin.z) / ray.direction.z;
    if (along <= 0.0) return std::nullopt;
    return ray.origin + along * ray.direction;
}

/// A ball outside of the view couldn't be dragged again.
QPointF nearestIn(const QRect &view, const QPointF &place) {
    return {std::clamp<double>(place.x(), view.left(), view.right()),
            std::clamp<double>(place.y(), view.top(), view.bottom())};
}

} // namespace

BallDragger::BallDragger(Session &session, gl::MazeView &view, QUndoStack &undo, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_view(view)
    , m_undo(undo) {
    view.installEventFilter(this);
}

bool BallDragger::isOverBall(const QPointF &place) const {
    const phys_state &ball = m_session.simulation().latest().current;
    const double radius = phys_scene_radius(m_session.scene().get());
    const glm::dvec3 centre = toGlm(ball.position);
    const QPointF middle = m_view.positionOf(centre);
    const QPointF side = m_view.positionOf(centre + glm::dvec3(radius, 0.0, 0.0));
    return QLineF(middle, place).length() <= std::max(kReach, QLineF(middle, side).length());
}

bool BallDragger::eventFilter(QObject *, QEvent *event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return take(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseMove:
        if (m_before) move(*static_cast<QMouseEvent *>(event));
        return m_before.has_value();
    case QEvent::MouseButtonRelease:
        return drop();
    default:
        return false;
    }
}

bool BallDragger::take(const QMouseEvent &event) {
    const Snapshot &now = m_session.simulation().latest();
    if (event.button() != Qt::LeftButton || now.running || m_session.isReplaying()) return false;
    if (!isOverBall(event.position())) return false;
    m_before = now;
    m_now = now.current;
    m_pulls = event.modifiers() & Qt::ControlModifier;
    return true;
}

void BallDragger::move(const QMouseEvent &event) {
    const QPointF place = m_pulls ? event.position() : nearestIn(m_view.rect(), event.position());
    const std::optional<glm::dvec3> point = pointAt(m_view.rayAt(place), m_before->current.position.z);
    if (!point) return;
    phys_state state = m_before->current;
    if (m_pulls) {
        const glm::dvec3 velocity = (*point - toGlm(state.position)) / kArrow;
        state.velocity = {velocity.x, velocity.y, 0.0};
        state.spin = rollingSpin(state.velocity, phys_scene_radius(m_session.scene().get()));
    } else {
        state.position = freePlace(m_session.scene().get(), {point->x, point->y, state.position.z});
    }
    m_now = state;
    m_session.placeBall(state);
}

bool BallDragger::drop() {
    if (!m_before) return false;
    const Snapshot before = *std::exchange(m_before, std::nullopt);
    const phys_state &ball = before.current;
    const bool hasMoved =
        toGlm(ball.position) != toGlm(m_now.position) || toGlm(ball.velocity) != toGlm(m_now.velocity);
    if (hasMoved) pushBallCommand(m_session, m_undo, before, m_now);
    return hasMoved; // a click without a move is left to the view
}

void BallDragger::addArrow(gl::Strokes &strokes) const {
    const Snapshot &now = m_session.simulation().latest();
    const glm::dvec3 velocity = toGlm(now.current.velocity);
    const double speed = glm::length(velocity);
    if (now.running || speed < kSlowest) return;
    strokes.arrow(toGlm(now.current.position), velocity / speed, kArrow * speed, kArrowColour, 3.0F);
}

} // namespace inspector::ui
