// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTreeWidget>

namespace inspector::ui {

/// The runs in the history, newest first: level, stepper, time, how it ended, parameters. Enter or a double click
/// returns to one; the one that is ticked, or chosen in the menu, is laid beside the others.
class RunDock : public QTreeWidget {
    Q_OBJECT

public:
    /// session must outlive the dock.
    explicit RunDock(Session &session, QWidget *parent = nullptr);

    /// Shows new runs; called about 30 times a second.
    void refresh();
    QSize sizeHint() const override { return {500, 200}; }

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void goTo(const QTreeWidgetItem *item);
    void layBeside(uint64_t begin, bool isOn);

    Session &m_session;
};

} // namespace inspector::ui
