// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

class QAbstractItemView;

namespace inspector::ui {

/// What a list says in the middle while it has no rows: what will be there, and what makes it.
class EmptyText : public QLabel {
public:
    /// Belongs to the view, which must have its model.
    EmptyText(QAbstractItemView &view, const QString &text);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void follow();

    const QAbstractItemView &m_view;
};

} // namespace inspector::ui
