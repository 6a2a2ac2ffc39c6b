// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark theme: one palette from which all widgets, icons, plots and the 3D view take their colours.
#pragma once

#include <QColor>
#include <QString>

class QPalette;

namespace inspector::ui {

enum class Theme { System, Light, Dark };
inline constexpr int kThemeCount = 3;

void applyTheme(Theme theme);

bool isDark(const QPalette &palette);

/// Semantic colours, readable on the palette's base.
struct Accents {
    QColor x, y, total; ///< components and magnitude of a vector
    QColor warning;     ///< background of a message
    QColor ball, ghost; ///< in a comparison: trails and legend
    QColor selected;    ///< the selected bounce
    QColor alarm;       ///< marks errors
};
Accents accentsFor(const QPalette &palette);

} // namespace inspector::ui
