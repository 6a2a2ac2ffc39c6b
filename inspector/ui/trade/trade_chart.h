// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade_chart.h"

#include <qcustomplot.h>

#include <optional>

namespace inspector::ui {

/// The trade's chart on the screen, whose points can be read and selected.
class TradeChart : public QCustomPlot {
    Q_OBJECT

public:
    explicit TradeChart(QWidget *parent = nullptr);

    /// result: what the chart describes, for its points' texts. Keeps the selected point if it is still there.
    void show(const ChartDescription &chart, const TradeResult &result);
    /// Marks the point with this index in the result's points, or none.
    void choose(std::optional<size_t> index);

    /// The index, in the result's points, of the point within a few pixels; nothing if there is none.
    std::optional<size_t> pointAt(const QPointF &place) const;
    QColor colourOf(const QByteArray &stepper) const; ///< of its curve; transparent if it has none

signals:
    void chosen(size_t index);

protected:
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange();
    void wrapTitle();
    void wrapLegend(bool isBeside);
    bool hasRoomBelow() const;
    void addFront();
    void addCurves();
    void showBand();
    void showGoodEnough();
    void fitAxes();
    QString tipOf(size_t index) const;
    QColor shown(const char *colour) const;
    void takeColours();

    ChartDescription m_description;
    std::vector<TradePoint> m_points; ///< of the result
    std::optional<size_t> m_chosen;
    QCPTextElement *m_title;
    QCPLayoutGrid *m_below;  ///< the title: curves, legend
    QCPLayoutGrid *m_beside; ///< the curves
    QCPCurve *m_front;
    QCPItemTracer *m_ring;
    QCPItemTracer *m_goodEnough;
    QCPItemRect *m_band;
    QCPGraph *m_middle; ///< of the band
    QCPGraph *m_limit;  ///< settings below are good enough
    std::vector<QCPCurve *> m_curves;
};

/// All figures of a point, a line each, for tool tips. name: the stepper's.
QString tradePointText(const TradePoint &point, const QString &name);

} // namespace inspector::ui
