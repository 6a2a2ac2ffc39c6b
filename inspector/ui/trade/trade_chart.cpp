// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/trade_chart.h"

#include "core/setup/tables.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_svg.h"
#include "core/trade/trade_table.h"
#include "ui/parts/printed_unit.h"
#include "ui/plots/chart_style.h"

#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kReach = 12.0; // px, of the mouse

double costOf(const TradePoint &point) { return point.cost.perSecond * 1e6; }
double errorOf(const TradePoint &point) { return std::max(point.error.positionLargest, kSmallestDrawnError); }

// Around the values, with some air.
QCPRange rangeOf(const std::vector<double> &values) {
    if (values.empty()) return {1.0, 10.0};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {*least / 2.0, *most * 2.0};
}

} // namespace

QString tradePointText(const TradePoint &point) {
    QString text = QStringLiteral("%1, %2, %3")
                       .arg(QString::fromUtf8(point.stepper), stepSizeText(point.dt), modelName(point.model));
    for (const TradeColumn &column : tradeColumns())
        text += QStringLiteral("\n%1: %2 %3")
                    .arg(QString::fromUtf8(column.label), figureText(column, point),
                         printedUnit(QString::fromUtf8(column.unit)));
    return point.note.isEmpty() ? text : text + QLatin1Char('\n') + point.note;
}

TradeChart::TradeChart(QWidget *parent)
    : QCustomPlot(parent)
    , m_front(new QCPCurve(xAxis, yAxis))
    , m_ring(new QCPItemTracer(this)) {
    setObjectName(QStringLiteral("trade_chart"));
    setMinimumSize(260, 180);
    setMouseTracking(true);
    makeLogarithmic(*xAxis, tr("CPU time of a simulated second [µs]"));
    makeLogarithmic(*yAxis, tr("Largest error [radii]"));
    m_front->setName(tr("best for its cost"));
    m_ring->setStyle(QCPItemTracer::tsCircle);
    m_ring->setSize(15);
    m_ring->setVisible(false);
    m_ring->position->setType(QCPItemPosition::ptPlotCoords);
    auto *beside = new QCPLayoutGrid; // where the legend hides no curve
    plotLayout()->addElement(0, 1, beside);
    beside->addElement(0, 0, legend);
    beside->addElement(1, 0, new QCPLayoutElement(this));
    beside->setRowStretchFactor(0, 0.001);
    plotLayout()->setColumnStretchFactor(1, 0.001);
    legend->setVisible(true);
    takeColours();
}

void TradeChart::show(const TradeResult &result, uint32_t model) {
    m_result = result;
    m_model = model;
    m_shown.clear();
    for (size_t i = 0; i < result.points.size(); ++i) {
        const TradePoint &point = result.points[i];
        if (point.model == model && point.isValid && point.cost.repeats > 0) m_shown.push_back(i);
    }
    addFront();
    addCurves();
    fitAxes();
    choose(m_chosen);
}

void TradeChart::addFront() {
    std::vector<TradePoint> points;
    for (const size_t i : m_shown) points.push_back(m_result.points[i]);
    m_front->data()->clear();
    for (const size_t i : paretoFront(points)) m_front->addData(costOf(points[i]), errorOf(points[i]));
}

void TradeChart::addCurves() {
    for (QCPCurve *curve : m_curves) removePlottable(curve);
    m_curves.clear();
    QByteArray stepper;
    size_t place = 0;
    for (const TradePoint &point : m_result.points) { // all, so that colours stay while results come in
        if (point.model != m_model) continue;
        if (m_curves.empty() || point.stepper != stepper) {
            const QColor colour = QLatin1String(curveColour(place++));
            const QColor line = colour == QColor(Qt::black) ? palette().color(QPalette::Text) : colour;
            stepper = point.stepper;
            m_curves.push_back(new QCPCurve(xAxis, yAxis));
            m_curves.back()->setName(QString::fromUtf8(stepper));
            m_curves.back()->setPen(QPen(line, 1.8));
            m_curves.back()->setScatterStyle({QCPScatterStyle::ssDisc, line, 6.0});
        }
        if (point.isValid && point.cost.repeats > 0) m_curves.back()->addData(costOf(point), errorOf(point));
    }
}

void TradeChart::fitAxes() {
    std::vector<double> costs;
    std::vector<double> errors;
    for (const size_t i : m_shown) {
        costs.push_back(costOf(m_result.points[i]));
        errors.push_back(errorOf(m_result.points[i]));
    }
    xAxis->setRange(rangeOf(costs));
    yAxis->setRange(rangeOf(errors));
}

void TradeChart::choose(std::optional<size_t> index) {
    m_chosen = index;
    const bool isShown = index && std::find(m_shown.begin(), m_shown.end(), *index) != m_shown.end();
    m_ring->setVisible(isShown);
    if (isShown) m_ring->position->setCoords(costOf(m_result.points[*index]), errorOf(m_result.points[*index]));
    replot(rpQueuedReplot);
}

QPointF TradeChart::placeOf(size_t index) const {
    const TradePoint &point = m_result.points[index];
    return {xAxis->coordToPixel(costOf(point)), yAxis->coordToPixel(errorOf(point))};
}

std::optional<size_t> TradeChart::pointAt(const QPointF &place) const {
    std::optional<size_t> nearest;
    double reach = kReach;
    for (const size_t i : m_shown) {
        const QPointF apart = placeOf(i) - place;
        const double distance = std::hypot(apart.x(), apart.y());
        if (distance > reach) continue;
        reach = distance;
        nearest = i;
    }
    return nearest;
}

void TradeChart::mouseMoveEvent(QMouseEvent *event) {
    const std::optional<size_t> index = pointAt(event->position());
    if (index) {
        QToolTip::showText(event->globalPosition().toPoint(), tradePointText(m_result.points[*index]), this);
    } else {
        QToolTip::hideText();
    }
    setCursor(index ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void TradeChart::mousePressEvent(QMouseEvent *event) {
    const std::optional<size_t> index = pointAt(event->position());
    if (index && event->button() == Qt::LeftButton) emit chosen(*index);
}

void TradeChart::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    takeColours();
    show(TradeResult(m_result), m_model);
}

void TradeChart::takeColours() {
    applyChartStyle(*this);
    QPen pen(mixed(palette().color(QPalette::Base), QColor(0xf0, 0xb8, 0x20), 0.6), 9.0);
    pen.setCapStyle(Qt::RoundCap);
    pen.setJoinStyle(Qt::RoundJoin);
    m_front->setPen(pen);
    m_ring->setPen(QPen(palette().color(QPalette::Text), 2.0));
    m_ring->setBrush(Qt::NoBrush);
}

bool writeTradePicture(const TradePlan &plan, const TradeResult &result, uint32_t model, const QString &path,
                       QString *error) {
    constexpr int kWidth = 900;
    constexpr int kHeight = 560;
    TradeChart chart;
    chart.setPalette(QPalette(Qt::black, Qt::white));
    chart.show(result, model);
    const QString title = QObject::tr("%1 model, schedule %2, errors up to %3 s")
                              .arg(modelName(model), plan.schedule.name)
                              .arg(result.spans[model].compared, 0, 'f', 2);
    chart.plotLayout()->insertRow(0);
    chart.plotLayout()->addElement(0, 0, new QCPTextElement(&chart, title));
    const bool isWritten = path.endsWith(QLatin1String(".pdf")) ? chart.savePdf(path, kWidth, kHeight)
                                                                : chart.savePng(path, kWidth, kHeight, 2.0);
    if (!isWritten) *error = QObject::tr("can't write '%1'").arg(path);
    return isWritten;
}

} // namespace inspector::ui
