// SPDX-License-Identifier: GPL-3.0-or-later
// Widgets that stand for an action of the window. A click on either leaves the keyboard to the game.
#pragma once

#include <QString>

class QAction;
class QCheckBox;
class QToolButton;

namespace inspector::ui {

// Object names: the prefix and the action's.
QToolButton *buttonFor(QAction &action, const QString &prefix);
// Of a checkable one.
QCheckBox *switchFor(QAction &action, const QString &prefix);

} // namespace inspector::ui
