// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QSlider>

namespace inspector::ui {

namespace {

bool hasValue(const QWidget *widget) {
    return qobject_cast<const QSlider *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget) ||
           qobject_cast<const QComboBox *>(widget) || qobject_cast<const QLineEdit *>(widget);
}

} // namespace

WheelGuard::WheelGuard(QWidget &window)
    : QObject(&window) {
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject *object, QEvent *event) {
    if (event->type() != QEvent::Wheel) return false;
    const auto *widget = qobject_cast<const QWidget *>(object);
    if (!hasValue(widget) || widget->hasFocus()) return false;
    event->ignore(); // propagates to the parent
    return true;
}

} // namespace inspector::ui
