// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QScrollArea>

#include <vector>

class QLabel;
class QPushButton;
class QUndoStack;

namespace inspector::ui {

class NumberBox;

/// Position, velocity and spin of the ball as numbers that can be edited while paused, and its start.
class BallDock : public QScrollArea {
    Q_OBJECT

public:
    /// Both must outlive the dock.
    BallDock(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    /// Shows the current moment; called about 30 times a second.
    void refresh(const Snapshot &now);

private:
    void enter(size_t row, double value);
    QString noteOf(const phys_state &ball) const;

    Session &m_session;
    QUndoStack &m_undo;
    std::vector<NumberBox *> m_boxes; ///< in row order
    QPushButton *m_startHere;
    QPushButton *m_usualStart;
    QLabel *m_note;
};

} // namespace inspector::ui
