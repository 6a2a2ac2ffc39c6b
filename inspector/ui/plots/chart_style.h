// SPDX-License-Identifier: GPL-3.0-or-later
// The common style of charts, from the palette.
#pragma once

#include <QColor>

#include <qcustomplot.h>

namespace inspector::ui {

/// The colour of uncertainty bands.
inline constexpr QColor kBandColour(0x2a, 0x9f, 0x4f);
inline constexpr QColor kBandFill(0x2a, 0x9f, 0x4f, 45);

/// Factor for charts of small distances, which are in mm.
inline constexpr double kMillimetresPerMetre = 1e3;

/// Blends from a (share 0) to b (share 1).
QColor mixed(const QColor &a, const QColor &b, double share);

/// Whether a widget's colours or font have changed, which its chart has to take over.
bool isChangeOfLook(const QEvent &event);

/// Sets background, axes, grid and legend to the widget's colours and font.
void applyChartStyle(QCustomPlot &chart);

/// Puts the legend into one line above the curves, so that it hides nothing; left: its margin, pixels. Returns that
/// line's layout, for further elements.
QCPLayoutGrid *putLegendAbove(QCustomPlot &chart, int left);

/// Whether the legend's entries fit beside each other across the chart.
bool hasLegendInOneLine(const QCustomPlot &chart);

/// For charts with little room: fewer ticks, and more lines for the legend above the curves.
void fitChart(QCustomPlot &chart);

/// Ticks of a logarithmic axis: at powers of ten; at 1, 2 and 5 times these on an axis too short for them; at equal
/// distances on a yet shorter one. Labels have all digits of their ticks.
class LogTicker : public QCPAxisTickerLog {
protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar format, int precision) override;
    QVector<double> createTickVector(double step, const QCPRange &range) override;

private:
    QVector<double> thinned(const QVector<double> &ticks, const QCPRange &range) const;
};

/// Makes an axis logarithmic, labelled in powers of ten.
void makeLogarithmic(QCPAxis &axis, const QString &label);

} // namespace inspector::ui
