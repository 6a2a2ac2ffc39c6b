// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark theme: one palette from which all widgets, icons, plots and the 3D view take their colours. And the
// size of the texts.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>
#include <QString>

#include <array>

class QWidget;

namespace inspector::ui {

enum class Theme { System, Light, Dark };
inline constexpr int kThemeCount = 3;

void applyTheme(Theme theme);

/// Sizes of the texts, relative to the system's: the last ones are read from the back of a room.
inline constexpr std::array kTextScales{1.0, 1.25, 1.5, 2.0};
void applyTextScale(double scale);

/// A desktop's palette, whose hints in empty fields are readable: some desktops leave them black in dark windows.
QPalette completed(QPalette desktops);

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

/// Gives a widget's text the colour that marks errors, in every theme; all else follows the theme.
class AlarmText : public QObject {
public:
    /// role: that of the text. The widget becomes the owner.
    AlarmText(QWidget &widget, QPalette::ColorRole role);
    void setOn(bool isOn); ///< initially off
    static bool isOn(const QWidget &widget);

protected:
    bool eventFilter(QObject *widget, QEvent *event) override;

private:
    void takeColour();

    QWidget &m_widget;
    QPalette::ColorRole m_role;
    bool m_isOn = false;
};

} // namespace inspector::ui
