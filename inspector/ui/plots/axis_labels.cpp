// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/axis_labels.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kLowLines = 7.0; ///< of text; a lower chart has no room for the label of its keys' axis
constexpr int kUsualMargin = 15;  ///< pixels, that of QCPAxisRect
constexpr int kUnitGap = 6;       ///< pixels, on both sides of a unit

QString unitOf(const QString &label) {
    const qsizetype bracket = label.lastIndexOf(QLatin1Char('['));
    return bracket < 0 ? QString() : label.mid(bracket);
}

} // namespace

AxisLabels::AxisLabels(QCustomPlot &chart)
    : m_chart(chart) {
    // At the chart's border, where its label would be.
    const auto unit = [&chart](QCPAxis *axis, double border, Qt::Alignment side) {
        auto *text = new QCPItemText(&chart);
        text->setClipToAxisRect(false);
        text->setSelectable(false);
        text->position->setTypeX(QCPItemPosition::ptViewportRatio);
        text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        text->position->setCoords(border, 0.0);
        text->setPositionAlignment(side | Qt::AlignBottom);
        text->setVisible(false);
        return Unit{axis, text};
    };
    m_units = {unit(chart.yAxis, 0.0, Qt::AlignLeft), unit(chart.yAxis2, 1.0, Qt::AlignRight)};
}

int AxisLabels::lines(double count) const { return int(count * m_chart.fontMetrics().height()); }

void AxisLabels::takeLook() {
    for (const Unit &unit : m_units) {
        unit.text->setFont(m_chart.font());
        unit.text->setColor(m_chart.palette().color(QPalette::Text));
        unit.text->setPadding(QMargins(kUnitGap, 0, kUnitGap, lines(0.5))); // above the number at the axis's end
    }
}

/// Labels of value axes become transparent, so that stacked charts remain aligned.
void AxisLabels::fit(int height, const QString &keys, bool isLowest) {
    const bool isLow = height < lines(kLowLines);
    const QMargins margins = m_chart.axisRect()->margins();
    const int width = m_chart.width() - margins.left() - margins.right();
    const bool isNarrow = m_chart.fontMetrics().horizontalAdvance(keys) > width;
    m_chart.xAxis->setLabel(isLow || isNarrow ? QString() : keys);
    m_chart.xAxis->setTickLabels(isLowest || !isLow);
    fitMargins(isLow);
    const int above = m_chart.legend->minimumOuterSizeHint().height();
    for (const Unit &unit : m_units) {
        const bool isCut = m_chart.fontMetrics().horizontalAdvance(unit.axis->label()) > height - above - lines(1.0);
        const bool isAbove = unit.axis->visible() && (isLow || isCut);
        unit.axis->setLabelColor(isAbove ? QColor(Qt::transparent) : m_chart.palette().color(QPalette::Text));
        unit.text->setText(unitOf(unit.axis->label()));
        unit.text->setVisible(isAbove && !unit.text->text().isEmpty());
    }
}

void AxisLabels::fitMargins(bool isLow) {
    QMargins margins = m_chart.axisRect()->minimumMargins();
    const int margin = isLow ? std::min(kUsualMargin, lines(0.5)) : kUsualMargin;
    margins.setTop(margin);
    margins.setBottom(margin);
    m_chart.axisRect()->setMinimumMargins(margins);
}

int AxisLabels::unitWidth() const {
    double widest = 0.0;
    for (const auto &[axis, text] : m_units)
        if (text->visible())
            widest = std::max(widest, text->right->pixelPosition().x() - text->left->pixelPosition().x());
    return int(std::ceil(widest));
}

} // namespace inspector::ui
