// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input/keyboard_focus.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>

#include <algorithm>

namespace inspector::ui {

namespace {

QWidget *firstControl(QWidget *content) {
    const auto isControl = [](const QWidget *widget) {
        const bool takesKeys = widget->isEnabled() && widget->isVisible() && (widget->focusPolicy() & Qt::TabFocus);
        return takesKeys && !qobject_cast<const QScrollArea *>(widget);
    };
    QWidget *first = content;
    while (first->focusProxy()) first = first->focusProxy();
    if (isControl(first)) return first;
    for (QWidget *next = first->nextInFocusChain(); next != first; next = next->nextInFocusChain())
        if (content->isAncestorOf(next) && isControl(next)) return next;
    return first;
}

} // namespace

void giveKeyboard(QWidget &content) {
    QWidget *control = firstControl(&content);
    control->window()->setAttribute(Qt::WA_KeyboardFocusChange);
    control->activateWindow();                  // of a floating dock
    control->setFocus(Qt::ShortcutFocusReason); // a text is selected
}

void moveKeyboard(QMainWindow &window, QWidget &view, int by) {
    QList<QWidget *> parts{&view};
    for (const QAction *action : window.actions()) { // raised docks are in another order
        const QString name = action->objectName();
        const auto *dock =
            name.startsWith(QLatin1String("show_")) ? window.findChild<QDockWidget *>(name.mid(5)) : nullptr;
        if (dock && !dock->visibleRegion().isEmpty()) parts += dock->widget();
    }
    const QWidget *focus = QApplication::focusWidget();
    const auto hasIt = [focus](const QWidget *part) { return part == focus || part->isAncestorOf(focus); };
    const qsizetype now = std::max<qsizetype>(0, std::ranges::find_if(parts, hasIt) - parts.begin()) % parts.size();
    giveKeyboard(*parts[(now + by + parts.size()) % parts.size()]);
}

} // namespace inspector::ui
