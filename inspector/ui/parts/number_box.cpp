// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/number_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionSpinBox>

namespace inspector::ui {

namespace {

constexpr int kMostDigits = 9;

// Digits after the point that `number` needs, at most kMostDigits.
int digitsOf(double number) {
    const QByteArray text = QByteArray::number(number, 'f', kMostDigits);
    qsizetype end = text.size();
    while (text[end - 1] == '0') --end;
    return int(end - 1 - text.indexOf('.'));
}

} // namespace

NumberBox::NumberBox(QWidget *parent)
    : QDoubleSpinBox(parent) {
    setDecimals(kMostDigits);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

void NumberBox::setRow(double minimum, double maximum, double notch) {
    m_digits = digitsOf(notch);
    setRange(minimum, maximum);
    setSingleStep(notch);
}

QString NumberBox::textFromValue(double value) const {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(value, 'f', std::max(m_digits, digitsOf(value)));
}

bool NumberBox::isBeingTyped() const { return lineEdit()->text() != textFromValue(value()) + suffix(); }

// A line takes the keys of undo for its letters. Once the number counts they are the window's.
bool NumberBox::event(QEvent *event) {
    if (event->type() == QEvent::ShortcutOverride && !isBeingTyped()) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QDoubleSpinBox::event(event);
}

// Wide enough for usual values, not for the largest that is allowed.
QSize NumberBox::sizeHint() const {
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-00.0000") + suffix()) + 6;
    const QSize content(width, lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
}

} // namespace inspector::ui
