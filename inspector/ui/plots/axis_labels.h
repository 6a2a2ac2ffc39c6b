// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

class QCPAxis;
class QCPItemText;
class QCustomPlot;

namespace inspector::ui {

/// The labels of a chart's axes as far as there is room for them: a value axis that is too short for its label has its
/// unit above it, as `[m/s]`.
class AxisLabels {
public:
    /// The legend is above the curves, and the keys' axis below them.
    explicit AxisLabels(QCustomPlot &chart);

    /// Takes the chart's font and colours.
    void takeLook();
    /// height: that of the chart, pixels. keys: label of the keys' axis. isLowest: no other chart with the same keys is
    /// below, which would show their numbers.
    void fit(int height, const QString &keys, bool isLowest);
    /// The width of the widest unit that stands above an axis; 0 if there is none.
    int unitWidth() const;

private:
    struct Unit {
        QCPAxis *axis;
        QCPItemText *text;
    };
    void fitMargins(bool isLow);
    int lines(double count) const; ///< pixels

    QCustomPlot &m_chart;
    std::vector<Unit> m_units;
};

} // namespace inspector::ui
