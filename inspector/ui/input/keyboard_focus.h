// SPDX-License-Identifier: GPL-3.0-or-later
// Where the keyboard goes between the view and the docks.
#pragma once

class QMainWindow;
class QWidget;

namespace inspector::ui {

/// Gives the keyboard to the first control of a dock, and shows that it is there, as after Tab. Where none had it,
/// letters would play the game.
void giveKeyboard(QWidget &content);

/// Gives the keyboard to the part after the one that has it, or before it (by: 1 or -1): the view, then the docks that
/// are seen, in the order of their keys.
void moveKeyboard(QMainWindow &window, QWidget &view, int by);

} // namespace inspector::ui
