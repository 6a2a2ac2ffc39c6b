// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace inspector::ui {

/// Writes a picture of the widget as on the screen, including OpenGL. Returns false, with one line in `error` (may be
/// nullptr), if the file can't be written.
bool grabToFile(QWidget &widget, const QString &path, QString *error);

} // namespace inspector::ui
