// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/elided_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace inspector::ui {

ElidedLabel::ElidedLabel(QWidget *parent)
    : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // so that long texts don't widen the window
}

void ElidedLabel::setWidest(const QString &text) {
    const QMargins margins = contentsMargins();
    m_widest = fontMetrics().horizontalAdvance(text) + margins.left() + margins.right();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    updateGeometry();
}

void ElidedLabel::setLeast(int characters) {
    m_least = characters;
    updateGeometry();
}

QSize ElidedLabel::sizeHint() const {
    const QSize hint = QLabel::sizeHint();
    return {std::max(hint.width(), m_widest), hint.height()};
}

QSize ElidedLabel::minimumSizeHint() const {
    const int least = std::min(fontMetrics().averageCharWidth() * m_least, sizeHint().width());
    return {least, QLabel::minimumSizeHint().height()};
}

QString ElidedLabel::shown() const { return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()); }

bool ElidedLabel::event(QEvent *event) {
    if (event->type() != QEvent::ToolTip || shown() == text()) return QLabel::event(event);
    const QString tip = toolTip().isEmpty() ? text() : text() + QLatin1Char('\n') + toolTip();
    QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), tip, this);
    return true;
}

void ElidedLabel::paintEvent(QPaintEvent *) {
    QPainter(this).drawText(contentsRect(), int(Qt::AlignLeft | Qt::AlignVCenter), shown());
}

} // namespace inspector::ui
