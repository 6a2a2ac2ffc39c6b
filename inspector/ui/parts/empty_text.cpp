// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/empty_text.h"

#include <QAbstractItemView>
#include <QEvent>

namespace inspector::ui {

namespace {
constexpr int kEmptyMargin = 8; ///< px
}

EmptyText::EmptyText(QAbstractItemView &view, const QString &text)
    : QLabel(text, view.viewport())
    , m_view(view) {
    setObjectName(view.objectName() + QStringLiteral("_empty"));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignCenter);
    setMargin(kEmptyMargin);
    setForegroundRole(QPalette::PlaceholderText);
    setAttribute(Qt::WA_TransparentForMouseEvents); // clicks and the wheel are the list's
    view.setAccessibleDescription(text);
    view.viewport()->installEventFilter(this);
    for (const auto change : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(view.model(), change, this, &EmptyText::follow);
    connect(view.model(), &QAbstractItemModel::modelReset, this, &EmptyText::follow);
    follow();
}

bool EmptyText::eventFilter(QObject *object, QEvent *event) {
    if (event->type() == QEvent::Resize) setGeometry(m_view.viewport()->rect());
    return QLabel::eventFilter(object, event);
}

void EmptyText::follow() { setVisible(m_view.model()->rowCount() == 0); }

} // namespace inspector::ui
