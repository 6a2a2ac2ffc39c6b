// SPDX-License-Identifier: GPL-3.0-or-later
// What all charts look like, made from the palette.
#pragma once

#include <QColor>

class QCPAxis;
class QCPLayoutGrid;
class QCustomPlot;

namespace inspector::ui {

// Of what isn't known of a board.
inline constexpr QColor kBandColour(0x2a, 0x9f, 0x4f);
inline constexpr QColor kBandFill(0x2a, 0x9f, 0x4f, 45);

// Charts of small distances are in mm.
inline constexpr double kMillimetresPerMetre = 1e3;

// From a (share 0) to b (share 1).
QColor mixed(const QColor &a, const QColor &b, double share);

// Background, axes, grid and legend in the colours and the font of the widget.
void applyChartStyle(QCustomPlot &chart);

// The legend in one line above the curves, where it hides none of them; left: its margin, pixels. Returns
// that line, for what else stands in it.
QCPLayoutGrid *putLegendAbove(QCustomPlot &chart, int left);

// Powers of ten, written as such.
void makeLogarithmic(QCPAxis &axis, const QString &label);

} // namespace inspector::ui
