// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QScrollArea>

#include <vector>

class QUndoStack;

namespace inspector::ui {

class ParameterRow;

// Every row of Parameters, to be seen and set; edits go through the undo stack.
class ParameterPanel : public QScrollArea {
    Q_OBJECT

public:
    // Both outlive the panel.
    ParameterPanel(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    void resetAll();
    // While the autopilot flies: the tilt that it chose, rad.
    void showFlownTilt(Tilt tilt);
    QSize sizeHint() const override;

signals:
    // A value was refused; the library's line.
    void refused(const QString &line);

protected:
    void changeEvent(QEvent *event) override;

private:
    void rebuild();
    void edit(int index, double value);
    void showValue(int index, double value);
    void showAutopilot();
    void updateLocks();
    QString lockOf(const phys_param_row &row) const;

    Session &m_session;
    Parameters &m_parameters;
    QUndoStack &m_undo;
    std::vector<ParameterRow *> m_rows;
    int m_gesture = 0;
};

} // namespace inspector::ui
