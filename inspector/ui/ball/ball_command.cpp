// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ball/ball_command.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <QUndoStack>

#include <utility>

namespace inspector::ui {

namespace {

class BallCommand : public QUndoCommand {
public:
    BallCommand(Session &session, const Snapshot &before, const phys_state &after)
        : QUndoCommand(QCoreApplication::translate("inspector::ui::BallCommand", "placing of the ball"))
        , m_session(session)
        , m_scene(session.scene())
        , m_before(before)
        , m_after(after) {}

    void undo() override {
        if (isHere()) m_session.putBallBack(m_before);
    }
    void redo() override {
        if (!std::exchange(m_isDone, true)) return; // the ball is already there when the command is pushed
        if (!isHere()) return;
        m_before = m_session.simulation().latest();
        m_session.placeBall(m_after);
    }

private:
    /// A place of another maze means nothing in this one: the command is dropped.
    bool isHere() {
        setObsolete(m_session.scene() != m_scene);
        return !isObsolete();
    }

    Session &m_session;
    Scene m_scene;
    Snapshot m_before;
    phys_state m_after;
    bool m_isDone = false;
};

} // namespace

void pushBallCommand(Session &session, QUndoStack &undo, const Snapshot &before, const phys_state &after) {
    undo.push(new BallCommand(session, before, after));
}

} // namespace inspector::ui
