// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/trade_chart.h"

#include "core/setup/numbers.h"
#include "core/setup/tables.h"
#include "core/trade/trade_table.h"
#include "ui/plots/chart_style.h"

#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kPickingReach = 12.0; ///< pixels
constexpr int kWide = 44;              ///< lines of text: here the legend has room beside the curves

/// The range of the values with a margin.
QCPRange rangeOf(const std::vector<double> &values) {
    if (values.empty()) return {1.0, 10.0};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {*least / 2.0, *most * 2.0};
}

} // namespace

QString tradePointText(const TradePoint &point, const QString &name) {
    QString text = QStringLiteral("%1, %2, %3").arg(name, stepSizeText(point.dt), modelName(point.model));
    for (const TradeColumn &column : tradeColumns())
        text += QStringLiteral("\n%1: %2 %3")
                    .arg(QString::fromUtf8(column.label), figureText(column, point),
                         printedUnit(QString::fromUtf8(column.unit)));
    return point.note.isEmpty() ? text : text + QLatin1Char('\n') + point.note;
}

TradeChart::TradeChart(QWidget *parent)
    : QCustomPlot(parent)
    , m_title(new QCPTextElement(this))
    , m_below(new QCPLayoutGrid)
    , m_beside(new QCPLayoutGrid)
    , m_front(new QCPCurve(xAxis, yAxis))
    , m_ring(new QCPItemTracer(this))
    , m_goodEnough(new QCPItemTracer(this))
    , m_band(new QCPItemRect(this))
    , m_middle(addGraph())
    , m_limit(addGraph()) {
    setObjectName(QStringLiteral("trade_chart"));
    setMinimumSize(260, 240);
    setMouseTracking(true);
    makeLogarithmic(*xAxis, m_description.costLabel);
    makeLogarithmic(*yAxis, m_description.errorLabel);
    m_front->setName(tr("best for its cost"));
    setAccessibleName(tr("Error of each setting against its cost"));
    legend->setIconSize(20, 12);
    legend->setRowSpacing(0);
    legend->setMargins({4, 2, 4, 2});
    for (QCPGraph *line : {m_middle, m_limit}) line->removeFromLegend();
    for (QCPItemTracer *ring : {m_ring, m_goodEnough}) {
        ring->setStyle(QCPItemTracer::tsCircle);
        ring->setVisible(false);
        ring->position->setType(QCPItemPosition::ptPlotCoords);
    }
    m_ring->setSize(15);
    m_goodEnough->setSize(21);
    // Spans the width of the chart.
    m_band->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_band->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_band->setVisible(false);
    QCPAxisRect *curves = axisRect();
    plotLayout()->addElement(1, 0, m_below);
    m_below->addElement(0, 0, curves);
    m_below->addElement(0, 1, m_beside);
    m_below->setColumnStretchFactor(1, 0.001);
    m_beside->addElement(0, 0, legend);
    m_beside->addElement(1, 0, new QCPLayoutElement(this));
    m_beside->setRowStretchFactor(0, 0.001);
    plotLayout()->addElement(0, 0, m_title);
    m_title->setTextFlags(Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap);
    takeColours();
    arrange();
}

/// The legend never lies on the curves: it is beside them, or below where that would leave them no room, or left out
/// where neither has any; the points' tool tips have the names.
void TradeChart::arrange() {
    wrapTitle();
    const bool isBeside = width() >= kWide * fontMetrics().height();
    wrapLegend(isBeside);
    const bool hasRoom = isBeside || hasRoomBelow();
    legend->setVisible(hasRoom && !m_description.points().empty()); // without curves there is nothing to name
    QCPLayoutGrid *wanted = !hasRoom ? nullptr : isBeside ? m_beside : m_below;
    if (legend->layout() == wanted) return;
    if (legend->layout()) legend->layout()->take(legend);
    if (wanted) wanted->addElement(isBeside ? 0 : 1, 0, legend);
    m_below->simplify();
    if (wanted == m_below) m_below->setRowStretchFactor(1, 0.001);
}

void TradeChart::wrapLegend(bool isBeside) {
    int widest = 1;
    for (QCPLayoutElement *item : legend->elements(false))
        if (item) widest = std::max(widest, item->minimumOuterSizeHint().width() + legend->columnSpacing());
    legend->setWrap(isBeside ? 1 : std::max(1, (width() - legend->margins().left()) / widest));
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

/// Whether the curves keep a height that the value axis can be read in: that of its label.
bool TradeChart::hasRoomBelow() const {
    constexpr int kLinesBelowAxis = 3; // of text: the cost's numbers and label
    const int taken = m_title->minimumSize().height() + legend->minimumOuterSizeHint().height() +
                      kLinesBelowAxis * fontMetrics().height();
    return height() - taken >= QFontMetrics(yAxis->labelFont()).horizontalAdvance(yAxis->label());
}

void TradeChart::wrapTitle() {
    const QRect room(0, 0, std::max(1, width() - m_title->margins().left() - m_title->margins().right()), height());
    const int needed = QFontMetrics(m_title->font()).boundingRect(room, m_title->textFlags(), m_title->text()).height();
    m_title->setMinimumSize(1, std::max(needed, fontMetrics().height())); // not as wide as its text
    m_title->setMaximumSize(QWIDGETSIZE_MAX, m_title->minimumSize().height());
}

void TradeChart::resizeEvent(QResizeEvent *event) {
    arrange();
    QCustomPlot::resizeEvent(event);
}

void TradeChart::show(const ChartDescription &chart, const TradeResult &result) {
    m_description = chart;
    m_points = result.points;
    m_title->setText(chart.title);
    xAxis->setLabel(chart.costLabel);
    yAxis->setLabel(chart.errorLabel);
    addFront();
    addCurves();
    fitAxes();
    showBand();
    arrange();
    showGoodEnough();
    choose(m_chosen);
}

void TradeChart::addFront() {
    m_front->data()->clear();
    for (const ChartPoint &point : m_description.front) m_front->addData(point.cost, point.error);
}

void TradeChart::addCurves() {
    for (QCPCurve *curve : m_curves) removePlottable(curve);
    m_curves.clear();
    for (const ChartCurve &curve : m_description.curves) {
        const QColor line = shown(curve.colour);
        m_curves.push_back(new QCPCurve(xAxis, yAxis));
        m_curves.back()->setName(curve.name);
        m_curves.back()->setPen(QPen(line, 1.8));
        m_curves.back()->setScatterStyle({QCPScatterStyle::ssDisc, line, 6.0});
        for (const ChartPoint &point : curve.points) m_curves.back()->addData(point.cost, point.error);
    }
}

/// Black curves have the colour of text, which is seen on every background.
QColor TradeChart::shown(const char *colour) const {
    const QColor line = QLatin1String(colour);
    return line == QColor(Qt::black) ? palette().color(QPalette::Text) : line;
}

QColor TradeChart::colourOf(const QByteArray &stepper) const {
    const auto curve = std::ranges::find(m_description.curves, stepper, &ChartCurve::stepper);
    return curve == m_description.curves.end() ? QColor(Qt::transparent) : shown(curve->colour);
}

void TradeChart::showBand() {
    const std::optional<ChartBand> &band = m_description.band;
    m_band->setVisible(band.has_value());
    for (QCPGraph *line : {m_middle, m_limit}) {
        line->data()->clear();
        line->removeFromLegend();
    }
    if (!band) return;
    m_band->topLeft->setCoords(0.0, std::max(band->high, kSmallestDrawnError));
    m_band->bottomRight->setCoords(1.0, std::max(band->low, kSmallestDrawnError));
    const auto draw = [&](QCPGraph *line, double error, const QString &name) {
        for (const double cost : {xAxis->range().lower, xAxis->range().upper})
            line->addData(cost, std::max(error, kSmallestDrawnError));
        line->setName(name);
        line->addToLegend();
    };
    draw(m_middle, band->middle, band->middleText);
    draw(m_limit, band->limit, band->limitText);
}

void TradeChart::showGoodEnough() {
    const std::optional<ChartPoint> &point = m_description.goodEnough;
    m_goodEnough->setVisible(point.has_value());
    if (point) m_goodEnough->position->setCoords(point->cost, point->error);
}

void TradeChart::fitAxes() {
    std::vector<double> costs;
    std::vector<double> errors;
    for (const ChartPoint &point : m_description.points()) {
        costs.push_back(point.cost);
        errors.push_back(point.error);
    }
    if (const std::optional<ChartBand> &band = m_description.band)
        for (const double error : {band->low, band->limit, band->high})
            errors.push_back(std::max(error, kSmallestDrawnError));
    xAxis->setRange(rangeOf(costs));
    yAxis->setRange(rangeOf(errors));
}

void TradeChart::choose(std::optional<size_t> index) {
    m_chosen = index;
    const std::vector<ChartPoint> points = m_description.points();
    const auto shown = std::find_if(points.begin(), points.end(),
                                    [&](const ChartPoint &point) { return index && point.index == *index; });
    m_ring->setVisible(shown != points.end());
    if (shown != points.end()) m_ring->position->setCoords(shown->cost, shown->error);
    replot(rpQueuedReplot);
}

std::optional<size_t> TradeChart::pointAt(const QPointF &place) const {
    std::optional<size_t> nearest;
    double reach = kPickingReach;
    for (const ChartPoint &point : m_description.points()) {
        const QPointF apart = QPointF(xAxis->coordToPixel(point.cost), yAxis->coordToPixel(point.error)) - place;
        const double distance = std::hypot(apart.x(), apart.y());
        if (distance > reach) continue;
        reach = distance;
        nearest = point.index;
    }
    return nearest;
}

void TradeChart::mouseMoveEvent(QMouseEvent *event) {
    const std::optional<size_t> index = pointAt(event->position());
    if (index) {
        QToolTip::showText(event->globalPosition().toPoint(), tipOf(*index), this);
    } else {
        QToolTip::hideText();
    }
    setCursor(index ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

QString TradeChart::tipOf(size_t index) const {
    const TradePoint &point = m_points[index];
    const auto curve = std::ranges::find(m_description.curves, point.stepper, &ChartCurve::stepper);
    return tradePointText(point, curve->name);
}

void TradeChart::mousePressEvent(QMouseEvent *event) {
    const std::optional<size_t> index = pointAt(event->position());
    if (index && event->button() == Qt::LeftButton) emit chosen(*index);
}

void TradeChart::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    if (!isChangeOfLook(*event)) return;
    takeColours();
    addCurves();
    arrange();
    replot(rpQueuedReplot);
}

void TradeChart::takeColours() {
    applyChartStyle(*this);
    m_title->setFont(font());
    QFont small = font();
    small.setPointSizeF(0.9 * small.pointSizeF());
    legend->setFont(small);
    m_title->setTextColor(palette().color(QPalette::Text));
    QPen pen(mixed(palette().color(QPalette::Base), QColor(0xf0, 0xb8, 0x20), 0.6), 9.0);
    pen.setCapStyle(Qt::RoundCap);
    pen.setJoinStyle(Qt::RoundJoin);
    m_front->setPen(pen);
    m_ring->setPen(QPen(palette().color(QPalette::Text), 2.0));
    m_ring->setBrush(Qt::NoBrush);
    m_goodEnough->setPen(QPen(kBandColour, 3.0));
    m_goodEnough->setBrush(Qt::NoBrush);
    m_band->setPen(Qt::NoPen);
    m_band->setBrush(kBandFill);
    m_middle->setPen(QPen(kBandColour, 2.0));
    m_limit->setPen(QPen(kBandColour, 2.0, Qt::DashLine));
}

} // namespace inspector::ui
