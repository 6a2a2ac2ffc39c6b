// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "gl/view/maze_view.h"

#include <QObject>

#include <optional>

class QMouseEvent;
class QUndoStack;

namespace inspector::ui {

/// Moves the ball by the mouse while paused: a drag moves it, out of walls and onto the floor; a drag with Ctrl sets
/// its velocity. A drag is one undo step.
class BallDragger : public QObject {
    Q_OBJECT

public:
    /// Time represented by the arrow, s: its tip is where the ball would be after this time.
    static constexpr double kArrow = 0.2;

    /// All must outlive this object.
    BallDragger(Session &session, gl::MazeView &view, QUndoStack &undo, QObject *parent);

    /// Adds the velocity's arrow while paused.
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
    std::optional<Snapshot> m_before; ///< the drag
    phys_state m_now{};
    bool m_pulls = false; ///< the drag sets the velocity, not the position
};

} // namespace inspector::ui
