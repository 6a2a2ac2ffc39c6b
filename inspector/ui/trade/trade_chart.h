// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade.h"

#include <qcustomplot.h>

#include <optional>

namespace inspector::ui {

// Cost against error, both logarithmic: a curve per stepper, the front highlighted, a point to read and to choose.
class TradeChart : public QCustomPlot {
    Q_OBJECT

public:
    explicit TradeChart(QWidget *parent = nullptr);

    // The points of one model. Keeps the chosen point if it is still there.
    void show(const TradeResult &result, uint32_t model);
    // Rings the point with this index in the result's points, or none.
    void choose(std::optional<size_t> index);

    // The index, in the result's points, of the one at most some pixels away from there.
    std::optional<size_t> pointAt(const QPointF &place) const;
    // Where a point is drawn, in the widget.
    QPointF placeOf(size_t index) const;

signals:
    void chosen(size_t index);

protected:
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void addFront();
    void addCurves();
    void fitAxes();
    void takeColours();

    TradeResult m_result;
    uint32_t m_model = PHYS_MODEL_ROLLING;
    std::vector<size_t> m_shown; // indices of the points drawn
    std::optional<size_t> m_chosen;
    QCPCurve *m_front;
    QCPItemTracer *m_ring;
    std::vector<QCPCurve *> m_curves;
};

// All figures of a point, a line each: for the tip of the chart.
QString tradePointText(const TradePoint &point);

// The chart alone, as .pdf or .png. Needs an application that can draw, no screen. False and one line in `error` if the
// file can't be written.
bool writeTradePicture(const TradePlan &plan, const TradeResult &result, uint32_t model, const QString &path,
                       QString *error);

} // namespace inspector::ui
