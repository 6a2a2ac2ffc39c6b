// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QWidget>

namespace inspector::ui {

/// A tool tip's text with line breaks.
inline QString wrapped(QString text) {
    static const QRegularExpression longLine(QStringLiteral("(?=.{81})(.{1,80}) "));
    return text.replace(longLine, QStringLiteral("\\1\n"));
}

/// Sets a control's accessible name and tool tip. name: empty where the widget's text is its name; tip: plain text.
inline void describe(QWidget *widget, const QString &name, const QString &tip) {
    widget->setAccessibleName(name);
    widget->setAccessibleDescription(tip);
    widget->setToolTip(tip);
}

} // namespace inspector::ui
