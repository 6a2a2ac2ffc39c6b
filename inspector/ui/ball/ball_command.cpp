// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ball/ball_command.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <QUndoStack>

namespace inspector::ui {

namespace {

class BallCommand : public QUndoCommand {
public:
    BallCommand(Session &session, const phys_state &before, const phys_state &after)
        : QUndoCommand(QCoreApplication::translate("inspector::ui::BallCommand", "placing of the ball"))
        , m_session(session)
        , m_before(before)
        , m_after(after) {}

    void undo() override { m_session.placeBall(m_before); }
    void redo() override {
        if (m_isDone) m_session.placeBall(m_after);
        m_isDone = true; // the ball is already there when the command is pushed
    }

private:
    Session &m_session;
    phys_state m_before;
    phys_state m_after;
    bool m_isDone = false;
};

} // namespace

void pushBallCommand(Session &session, QUndoStack &undo, const phys_state &before, const phys_state &after) {
    undo.push(new BallCommand(session, before, after));
}

} // namespace inspector::ui
