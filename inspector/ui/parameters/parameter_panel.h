// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/parameter_sets.h"

#include <QScrollArea>

#include <vector>

class QAction;
class QGridLayout;
class QPushButton;
class QUndoStack;

namespace inspector::ui {

class ParameterRow;
class SetMenu;
enum class Owner;

/// Shows and edits every row of Parameters and, while the ghost has its own parameters, the ghost's row below each.
/// Edits go through the undo stack.
class ParameterPanel : public QScrollArea {
    Q_OBJECT

public:
    struct Actions {
        QAction &ghostsOwn; ///< checkable
        QAction &copy;
        QAction &swap;
    };

    /// All must outlive the panel.
    ParameterPanel(Session &session, QUndoStack &undo, const Actions &actions, QWidget *parent = nullptr);

    void resetAll();
    void copyToGhost();
    void swapWithGhost();
    /// Shows the tilt, rad, that the autopilot or the measured ball's table sets.
    void showPilotsTilt(Tilt tilt);
    QSize sizeHint() const override;

signals:
    /// A value was refused; line: the library's message.
    void refused(const QString &line);
    void saved(const QString &path); ///< a set of parameters was exported

protected:
    void changeEvent(QEvent *event) override;

private:
    /// One ball's parameters and rows.
    struct Side {
        Owner owner;
        Parameters &parameters;
        std::vector<ParameterRow *> rows{}; ///< null for rows that the ball hasn't: the ghost's tilt
    };

    void rebuild();
    void fitWidth();
    void addRow(Side &side, int index, QGridLayout &grid, int line);
    QWidget *makeHead();
    void useSet(Side &side, const ParameterSet &set);
    void change(Side &side, const std::vector<Setting> &wanted, const QString &text);
    void addResetAll(QGridLayout &grid, int line);
    void edit(Side &side, int index, double value);
    void showValue(const Side &side, int index, double value);
    void showPilot();
    void showGhost();
    void takeBack();
    void updateLocks();
    QString lockOf(const Side &side, const phys_param_row &row) const;

    Session &m_session;
    QUndoStack &m_undo;
    Actions m_actions;
    Side m_ball;
    Side m_ghost;
    SetMenu *m_sets;
    QPushButton *m_resetAll = nullptr;
    int m_gesture = 0;
};

} // namespace inspector::ui
