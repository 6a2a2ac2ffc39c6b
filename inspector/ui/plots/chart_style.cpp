// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/chart_style.h"

#include <qcustomplot.h>

namespace inspector::ui {

QColor mixed(const QColor &a, const QColor &b, double share) {
    const auto between = [share](float from, float to) { return float(from + share * (to - from)); };
    return QColor::fromRgbF(between(a.redF(), b.redF()), between(a.greenF(), b.greenF()),
                            between(a.blueF(), b.blueF()));
}

void applyChartStyle(QCustomPlot &chart) {
    const QColor base = chart.palette().color(QPalette::Base);
    const QColor text = chart.palette().color(QPalette::Text);
    chart.setBackground(base);
    for (QCPAxis *axis : {chart.xAxis, chart.yAxis, chart.yAxis2}) {
        for (const auto setter : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*setter)(QPen(mixed(base, text, 0.5)));
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(chart.font());
        axis->setLabelFont(chart.font());
        axis->grid()->setPen(QPen(mixed(base, text, 0.15)));
        axis->grid()->setZeroLinePen(QPen(mixed(base, text, 0.4)));
    }
    chart.legend->setFont(chart.font());
    chart.legend->setTextColor(text);
    chart.legend->setBrush(Qt::NoBrush);
    chart.legend->setBorderPen(Qt::NoPen);
}

QCPLayoutGrid *putLegendAbove(QCustomPlot &chart, int left) {
    chart.legend->setVisible(true);
    auto *line = new QCPLayoutGrid;
    chart.plotLayout()->insertRow(0);
    chart.plotLayout()->addElement(0, 0, line);
    line->addElement(0, 0, chart.legend);
    line->setColumnStretchFactor(0, 0.001);
    chart.plotLayout()->setRowStretchFactor(0, 0.001);
    chart.plotLayout()->setRowSpacing(0);
    chart.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    chart.legend->setMargins(QMargins(left, 4, 8, 0));
    chart.legend->setColumnSpacing(18);
    return line;
}

void makeLogarithmic(QCPAxis &axis, const QString &label) {
    axis.setLabel(label);
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis.setNumberFormat(QStringLiteral("eb"));
    axis.setNumberPrecision(0);
}

} // namespace inspector::ui
