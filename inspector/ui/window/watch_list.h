// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTreeWidget>

#include <vector>

namespace inspector::ui {

/// Selected quantities as numbers, at the moment shown. A right click selects them; a name can be dragged onto a plot.
class WatchList : public QTreeWidget {
    Q_OBJECT

public:
    /// session must outlive the list.
    explicit WatchList(Session &session, QWidget *parent = nullptr);

    /// Shows the current moment; called about 30 times a second.
    void refresh(const Snapshot &now);
    QSize sizeHint() const override { return {260, 180}; }

protected:
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    QMimeData *mimeData(const QList<QTreeWidgetItem *> &items) const override;

private:
    void toggle(Channel channel);
    void rebuild();
    void fitColumns();

    Session &m_session;
    std::vector<Channel> m_channels;
};

} // namespace inspector::ui
