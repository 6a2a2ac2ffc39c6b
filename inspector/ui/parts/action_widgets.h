// SPDX-License-Identifier: GPL-3.0-or-later
// Widgets for actions of the window. Clicking them doesn't take the keyboard from the game.
#pragma once

#include <QString>

class QAction;
class QCheckBox;
class QToolButton;

namespace inspector::ui {

/// A button. Object names: the prefix and the action's.
QToolButton *buttonFor(QAction &action, const QString &prefix);
/// A check box, for a checkable action.
QCheckBox *switchFor(QAction &action, const QString &prefix);

} // namespace inspector::ui
