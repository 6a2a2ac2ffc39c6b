// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/message_bar.h"

#include "ui/parts/path_icon.h"
#include "ui/parts/theme.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace inspector::ui {

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent)
    , m_icon(new QLabel)
    , m_text(new QLabel) {
    setObjectName(QStringLiteral("messages"));
    setAutoFillBackground(true);
    m_text->setObjectName(QStringLiteral("message"));
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_icon->setPixmap(glyphIcon(Glyph::Warning).pixmap(16));

    auto *close = new QToolButton;
    close->setObjectName(QStringLiteral("dismiss"));
    close->setAccessibleName(tr("Dismiss the message"));
    close->setIcon(glyphIcon(Glyph::Close));
    close->setToolTip(tr("Hide this message"));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::TabFocus);
    connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 4, 4);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(close);
    takeColours();
    hide();
}

void MessageBar::showLine(const QString &line, Cause cause) {
    ++m_count;
    const auto same = std::find_if(m_messages.begin(), m_messages.end(),
                                   [cause](const Message &message) { return message.cause == cause; });
    Message message{line, cause, 1};
    if (same != m_messages.end()) {
        if (same->line == line) message.count = same->count + 1;
        m_messages.erase(same);
    }
    m_messages.push_back(message);
    showNewest();
}

void MessageBar::settle(Cause cause) {
    if (std::erase_if(m_messages, [cause](const Message &message) { return message.cause == cause; }) > 0) showNewest();
}

void MessageBar::dismiss() {
    m_messages.clear();
    showNewest();
}

void MessageBar::showNewest() {
    setVisible(!m_messages.empty());
    if (!m_messages.empty()) {
        const Message &newest = m_messages.back();
        m_text->setText(newest.count > 1 ? tr("%1  (%2 times)").arg(newest.line).arg(newest.count) : newest.line);
    }
    emit changed(line());
}

void MessageBar::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange) takeColours();
    QFrame::changeEvent(event);
}

/// The background matches the text colour, which is the window's.
void MessageBar::takeColours() {
    const QColor plate = accentsFor(QApplication::palette()).warning;
    if (palette().color(QPalette::Window) == plate) return; // this call caused the change
    QPalette own;
    own.setColor(QPalette::Window, plate);
    setPalette(own);
    m_icon->setPixmap(glyphIcon(Glyph::Warning).pixmap(16));
}

} // namespace inspector::ui
