// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input/plain_texts.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace inspector::ui {

PlainTexts::PlainTexts(QWidget &window)
    : QObject(&window) {
    qApp->installEventFilter(this);
}

/// Every widget is polished before it is shown; a tool tip is a label, too.
bool PlainTexts::eventFilter(QObject *object, QEvent *event) {
    auto *label = event->type() == QEvent::Polish ? qobject_cast<QLabel *>(object) : nullptr;
    if (label && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
    return false;
}

} // namespace inspector::ui
