// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QString;
class QWidget;

namespace inspector::ui {

/// Shows every shortcut of the window's actions, and what the mouse does.
void showKeysDialog(QWidget &window);
/// Shows versions and licences. renderer: its name.
void showAboutDialog(QWidget &window, const QString &renderer);

} // namespace inspector::ui
