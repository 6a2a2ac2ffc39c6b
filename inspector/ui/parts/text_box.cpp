// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/text_box.h"

#include "ui/parts/theme.h"

#include <QKeyEvent>

namespace inspector::ui {

TextBox::TextBox(const QString &text, QWidget *parent)
    : QLineEdit(text, parent)
    , m_alarm(new AlarmText(*this, QPalette::Text)) {}

void TextBox::setRefused(bool isRefused) {
    m_isRefused = isRefused;
    m_alarm->setOn(isRefused);
}

void TextBox::keyPressEvent(QKeyEvent *event) {
    if (event->key() != Qt::Key_Escape || text() == m_before) return QLineEdit::keyPressEvent(event);
    setRefused(false);
    setText(m_before);
    event->accept();
}

void TextBox::focusInEvent(QFocusEvent *event) {
    if (!m_isRefused) m_before = text();
    QLineEdit::focusInEvent(event);
}

} // namespace inspector::ui
