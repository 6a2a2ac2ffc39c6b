// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/stepping_command.h"

#include <QUndoCommand>
#include <QUndoStack>

#include <utility>

namespace inspector::ui {

namespace {

class SteppingCommand : public QUndoCommand {
public:
    SteppingCommand(Session &session, Stepping before, Stepping after, const QString &text)
        : QUndoCommand(text)
        , m_session(session)
        , m_before(std::move(before))
        , m_after(std::move(after)) {}

    void undo() override { m_session.setStepping(m_before); }
    void redo() override { m_session.setStepping(m_after); } ///< no effect when it is pushed

private:
    Session &m_session;
    Stepping m_before;
    Stepping m_after;
};

} // namespace

bool changeStepping(Session &session, QUndoStack &undo, const Stepping &wanted, const QString &text) {
    const Stepping before = session.stepping();
    if (!session.setStepping(wanted)) return false;
    const Stepping after = session.stepping();
    if (after != before) undo.push(new SteppingCommand(session, before, after, text));
    return true;
}

} // namespace inspector::ui
