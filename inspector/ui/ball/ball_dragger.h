// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "gl/view/maze_view.h"

#include <QObject>

#include <optional>

class QMouseEvent;
class QUndoStack;

namespace inspector::ui {

// The ball in one's hand, while everything stands: a drag puts it to another place, out of walls and onto the floor; a
// drag with Ctrl pulls its velocity. One undo takes a drag back.
class BallDragger : public QObject {
    Q_OBJECT

public:
    static constexpr double kArrow = 0.2; // s: the arrow ends where the ball would be after this time

    // All outlive the hand.
    BallDragger(Session &session, gl::MazeView &view, QUndoStack &undo, QObject *parent);

    // The arrow of the velocity, while everything stands.
    void addArrow(gl::Strokes &strokes) const;

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool isOverBall(const QPointF &place) const;
    bool take(const QMouseEvent &event);
    void move(const QMouseEvent &event);
    bool drop();

    Session &m_session;
    gl::MazeView &m_view;
    QUndoStack &m_undo;
    std::optional<phys_state> m_before; // of the drag
    phys_state m_now{};
    bool m_pulls = false; // the velocity
};

} // namespace inspector::ui
