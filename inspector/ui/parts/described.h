// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace inspector::ui {

// What a control is, for those who see it and for those who have it read to them. The name is empty where the text of
// the widget is its name; the tip is plain text.
inline void describe(QWidget *widget, const QString &name, const QString &tip) {
    widget->setAccessibleName(name);
    widget->setAccessibleDescription(tip);
    widget->setToolTip(tip);
}

} // namespace inspector::ui
