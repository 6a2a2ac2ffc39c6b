// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace inspector::ui {

/// Sets a control's accessible name and tool tip. name: empty where the widget's text is its name; tip: plain text.
inline void describe(QWidget *widget, const QString &name, const QString &tip) {
    widget->setAccessibleName(name);
    widget->setAccessibleDescription(tip);
    widget->setToolTip(tip);
}

} // namespace inspector::ui
