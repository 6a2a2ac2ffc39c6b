// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade_chart.h"

#include <qcustomplot.h>

#include <optional>

namespace inspector::ui {

// The trade's chart on the screen, with a point to read and to choose.
class TradeChart : public QCustomPlot {
    Q_OBJECT

public:
    explicit TradeChart(QWidget *parent = nullptr);

    // result: what the chart was described from; its points are told of. Keeps the chosen point if it is still there.
    void show(const ChartDescription &chart, const TradeResult &result);
    // Rings the point with this index in the result's points, or none.
    void choose(std::optional<size_t> index);

    // The index, in the result's points, of the one at most some pixels away from there.
    std::optional<size_t> pointAt(const QPointF &place) const;
    // Where a point is drawn, in the widget; nothing if it isn't.
    std::optional<QPointF> placeOf(size_t index) const;

signals:
    void chosen(size_t index);

protected:
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void addFront();
    void addCurves();
    void showBand();
    void showGoodEnough();
    void fitAxes();
    void takeColours();

    ChartDescription m_description;
    std::vector<TradePoint> m_points; // of the result
    std::optional<size_t> m_chosen;
    QCPCurve *m_front;
    QCPItemTracer *m_ring;
    QCPItemTracer *m_goodEnough;
    QCPItemRect *m_band;
    QCPGraph *m_middle; // of the band
    QCPGraph *m_limit;  // below it a setting is good enough
    std::vector<QCPCurve *> m_curves;
};

// All figures of a point, a line each: for the tip of the chart.
QString tradePointText(const TradePoint &point);

// The chart alone, as .pdf or .png. Needs an application that can draw, no screen. False and one line in `error` if the
// file can't be written.
bool writeTradePicture(const ChartDescription &chart, const QString &path, QString *error);

} // namespace inspector::ui
