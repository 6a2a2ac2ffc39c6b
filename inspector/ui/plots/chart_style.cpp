// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <qcustomplot.h>

namespace inspector::ui {

QColor mixed(const QColor &a, const QColor &b, double share) {
    const auto between = [share](float from, float to) { return float(from + share * (to - from)); };
    return QColor::fromRgbF(between(a.redF(), b.redF()), between(a.greenF(), b.greenF()),
                            between(a.blueF(), b.blueF()));
}

bool isChangeOfLook(const QEvent &event) {
    return event.type() == QEvent::PaletteChange || event.type() == QEvent::FontChange;
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

namespace {

constexpr int kMostTicks = 5;
constexpr int kLinesBesideAxis = 4;    ///< of text, above and below a value axis
constexpr int kMostDecimals = 9;       ///< of a tick's label
constexpr double kTickRounding = 1e-9; ///< share of a tick's value
constexpr double kLinearDecades = 0.5;
constexpr double kTickDecades = 1.6; ///< from which on QCPAxisTickerLog has ticks at powers of ten

std::vector<int> entryWidths(const QCPLegend &legend) {
    std::vector<int> widths;
    for (int cell = 0; cell < legend.elementCount(); ++cell) // including empty ones at the end of its last line
        if (const QCPLayoutElement *entry = legend.elementAt(cell))
            widths.push_back(entry->minimumOuterSizeHint().width());
    return widths;
}

/// The width that entries take in this many columns.
int widthOf(const std::vector<int> &entries, size_t columns, int spacing) {
    int width = int(columns - 1) * spacing;
    for (size_t column = 0; column < columns; ++column) {
        int widest = 0;
        for (size_t entry = column; entry < entries.size(); entry += columns) widest = std::max(widest, entries[entry]);
        width += widest;
    }
    return width;
}

int roomOf(const QCPLegend &legend, int width) { return width - legend.margins().left() - legend.margins().right(); }

void wrapLegend(QCPLegend &legend, int width) {
    const std::vector<int> entries = entryWidths(legend);
    const int room = roomOf(legend, width);
    size_t columns = std::max<size_t>(entries.size(), 1);
    while (columns > 1 && widthOf(entries, columns, legend.columnSpacing()) > room) --columns;
    const int wrap = columns < entries.size() ? int(columns) : 0;
    if (wrap == legend.wrap()) return;
    legend.setWrap(wrap);
    legend.setFillOrder(legend.fillOrder(), true);
}

} // namespace

bool hasLegendInOneLine(const QCustomPlot &chart) {
    const QCPLegend &legend = *chart.legend;
    const std::vector<int> entries = entryWidths(legend);
    return entries.empty() || widthOf(entries, entries.size(), legend.columnSpacing()) <= roomOf(legend, chart.width());
}

void fitChart(QCustomPlot &chart) {
    const int line = QFontMetrics(chart.font()).height();
    wrapLegend(*chart.legend, chart.width());
    const int least = chart.height() < (chart.legend->rowCount() + kLinesBesideAxis) * line ? 1 : 2;
    const int ticks = std::clamp((chart.height() - kLinesBesideAxis * line) / (2 * line), least, kMostTicks);
    for (const QCPAxis *axis : {chart.yAxis, chart.yAxis2}) axis->ticker()->setTickCount(ticks);
    const QMargins margins = chart.axisRect()->margins();
    const int numbers = (chart.width() - margins.left() - margins.right()) /
                        QFontMetrics(chart.font()).horizontalAdvance(QStringLiteral("00.00  "));
    chart.xAxis->ticker()->setTickCount(std::clamp(numbers, 1, kMostTicks));
}

QString LogTicker::getTickLabel(double tick, const QLocale &locale, QChar format, int) {
    int decimals = 0;
    while (decimals < kMostDecimals &&
           std::abs(QString::number(tick, 'e', decimals).toDouble() / tick - 1.0) > kTickRounding)
        ++decimals;
    return QCPAxisTickerLog::getTickLabel(tick, locale, format, decimals);
}

/// QCPAxisTickerLog may return twice as many ticks as wanted, for which a short axis has no room.
QVector<double> LogTicker::thinned(const QVector<double> &ticks, const QCPRange &range) const {
    const auto shown = std::ranges::count_if(ticks, [&range](double tick) { return range.contains(tick); });
    const qsizetype most = std::max(1, 2 * tickCount() - 1);
    const qsizetype pitch = std::max<qsizetype>(1, (shown + most - 1) / most);
    QVector<double> kept;
    for (qsizetype i = 0; i < ticks.size(); i += pitch) kept.append(ticks[i]);
    return kept;
}

QVector<double> LogTicker::createTickVector(double step, const QCPRange &range) {
    const double decades = std::log10(range.upper / range.lower);
    if (!(decades > kLinearDecades)) return QCPAxisTickerLog::createTickVector(step, range);
    if (decades >= kTickDecades) return thinned(QCPAxisTickerLog::createTickVector(step, range), range);
    QVector<double> ticks;
    const int lowest = static_cast<int>(std::floor(std::log10(range.lower)));
    const int highest = static_cast<int>(std::floor(std::log10(range.upper)));
    for (int decade = lowest; decade <= highest; ++decade)
        for (const double digit : {1.0, 2.0, 5.0}) ticks.append(digit * std::pow(10.0, decade));
    return ticks;
}

void makeLogarithmic(QCPAxis &axis, const QString &label) {
    axis.setLabel(label);
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<LogTicker>::create());
    axis.setNumberFormat(QStringLiteral("eb"));
    axis.setNumberPrecision(0);
}

} // namespace inspector::ui
