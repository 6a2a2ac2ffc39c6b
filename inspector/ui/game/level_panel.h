// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTreeWidget>

namespace inspector::ui {

/// The levels with their best times; choosing one opens it.
class LevelPanel : public QTreeWidget {
    Q_OBJECT

public:
    /// session must outlive the panel.
    explicit LevelPanel(Session &session, QWidget *parent = nullptr);
    QSize sizeHint() const override { return {280, 200}; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void showState();
    void fitNames();

    Session &m_session;
};

} // namespace inspector::ui
