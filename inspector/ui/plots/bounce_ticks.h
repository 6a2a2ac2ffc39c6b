// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <qcustomplot.h>

namespace inspector::ui {

/// Marks on a plot's time axis: short lines at its lower border; the selected one spans the whole height.
class BounceTicks : public QCPAbstractItem {
    Q_OBJECT

public:
    explicit BounceTicks(QCustomPlot *plot);

    /// times: s, ascending; selected: need not be one of them. False if nothing changes.
    bool show(std::vector<double> times, std::optional<double> selected);
    /// Only ticks in this range are drawn, s.
    void setRange(double from, double to);
    void setColours(const QColor &tick, const QColor &selected);

    /// The time of the tick at this pixel, or within a few pixels of it.
    std::optional<double> timeAt(const QPointF &pixel) const;

    const std::vector<double> &times() const { return m_times; }
    std::optional<double> selected() const { return m_selected; }

    double selectTest(const QPointF &, bool, QVariant *) const override { return -1.0; }

protected:
    void draw(QCPPainter *painter) override;

private:
    std::vector<double> m_times;
    std::optional<double> m_selected;
    double m_from = 0.0;
    double m_to = 0.0;
    QColor m_tick;
    QColor m_selectedColour;
};

} // namespace inspector::ui
