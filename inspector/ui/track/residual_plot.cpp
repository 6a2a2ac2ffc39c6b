// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/track/residual_plot.h"

#include "ui/plots/chart_style.h"

#include <cmath>

namespace inspector::ui {

ResidualPlot::ResidualPlot(QWidget *parent)
    : QCustomPlot(parent)
    , m_x(addGraph())
    , m_y(addGraph())
    , m_bounces(addGraph())
    , m_noise(new QCPItemRect(this)) {
    setObjectName(QStringLiteral("track_residuals"));
    setMinimumSize(140, 130);
    xAxis->setLabel(tr("Time [s]"));
    yAxis->setLabel(tr("Residual [mm]"));
    setToolTip(tr("Measured minus computed · wheel: zoom · drag: move"));
    setAccessibleName(tr("Measured minus computed positions"));
    m_x->setName(tr("x"));
    m_y->setName(tr("y"));
    m_bounces->setName(tr("bounces"));
    m_x->setPen(QPen(QColor(0xd5, 0x5e, 0x00), 1.0));
    m_y->setPen(QPen(QColor(0x00, 0x72, 0xb2), 1.0));
    m_bounces->setLineStyle(QCPGraph::lsNone);
    m_bounces->setScatterStyle({QCPScatterStyle::ssTriangle, QColor(0x00, 0x9e, 0x73), 6.0});
    m_noise->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_noise->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_noise->setPen(Qt::NoPen);
    m_noise->setBrush(QColor(0x2a, 0x9f, 0x4f, 45));
    putLegendAbove(*this, 6);
    legend->setIconSize(16, 16); // fits into the narrowest dock
    legend->setColumnSpacing(8);
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    applyChartStyle(*this);
    clear();
}

void ResidualPlot::clear() {
    for (QCPGraph *graph : {m_x, m_y, m_bounces}) graph->data()->clear();
    m_noise->setVisible(false);
    replot(rpQueuedReplot);
}

void ResidualPlot::show(const ModelFit &fit, double noise) {
    clear();
    double largest = 3.0 * noise * kMillimetresPerMetre;
    for (const FitResidual &residual : fit.residuals) {
        const double x = (residual.seen.x - residual.computed.x) * kMillimetresPerMetre;
        const double y = (residual.seen.y - residual.computed.y) * kMillimetresPerMetre;
        m_x->addData(residual.seen.time, x);
        m_y->addData(residual.seen.time, y);
        largest = std::max({largest, std::abs(x), std::abs(y)});
    }
    for (const FittedBounce &bounce : fit.bounces) m_bounces->addData(bounce.time, -1.05 * largest);
    m_noise->topLeft->setCoords(0.0, 2.0 * noise * kMillimetresPerMetre);
    m_noise->bottomRight->setCoords(1.0, -2.0 * noise * kMillimetresPerMetre);
    m_noise->setVisible(true);
    if (!fit.residuals.empty()) xAxis->setRange(fit.residuals.front().seen.time, fit.residuals.back().seen.time);
    yAxis->setRange(-1.15 * largest, 1.15 * largest);
    replot(rpQueuedReplot);
}

void ResidualPlot::resizeEvent(QResizeEvent *event) {
    QCustomPlot::resizeEvent(event);
    fitChart(*this);
}

void ResidualPlot::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    if (!isChangeOfLook(*event)) return;
    applyChartStyle(*this);
    replot(rpQueuedReplot);
}

} // namespace inspector::ui
