// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/phase_plot.h"

#include "core/setup/numbers.h"
#include "ui/parts/theme.h"
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr size_t kIntervals = 4000; ///< number of intervals into which the points divide the time

QString labelOf(Channel channel) {
    const ChannelInfo &info = channelInfos()[size_t(channel)];
    const QString label = QString::fromUtf8(info.label);
    return *info.unit ? QStringLiteral("%1 [%2]").arg(label, printedUnit(QString::fromUtf8(info.unit))) : label;
}

} // namespace

PhasePlot::PhasePlot(const SampleRing &samples, Channel x, Channel y, std::shared_ptr<TimeView> time, QWidget *parent)
    : QCustomPlot(parent)
    , m_samples(samples)
    , m_x(x)
    , m_y(y)
    , m_time(std::move(time))
    , m_curve(new QCPCurve(xAxis, yAxis))
    , m_dot(new QCPItemTracer(this))
    , m_cursorDot(new QCPItemTracer(this))
    , m_text(new QCPTextElement(this)) {
    setMinimumSize(140, 80);
    setMouseTracking(true);
    setLocale(QLocale::c());
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    xAxis->setLabel(labelOf(x));
    yAxis->setLabel(labelOf(y));
    setAccessibleName(tr("Plot of %1 over %2").arg(yAxis->label(), xAxis->label()));
    for (QCPItemTracer *dot : {m_dot, m_cursorDot}) {
        dot->setStyle(QCPItemTracer::tsCircle);
        dot->setSize(7);
    }
    m_text->setObjectName(QStringLiteral("read_out"));
    m_text->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    plotLayout()->insertRow(0);
    plotLayout()->addElement(0, 0, m_text);
    takeColours();
    connect(m_time.get(), &TimeView::changed, this, [this] { m_isStale = true; });
}

void PhasePlot::takeColours() {
    applyChartStyle(*this);
    const Accents accents = accentsFor(palette());
    m_curve->setPen(QPen(accents.total, 1.3));
    m_dot->setPen(QPen(palette().color(QPalette::Base)));
    m_dot->setBrush(accents.ball);
    m_cursorDot->setPen(QPen(palette().color(QPalette::Text)));
    m_text->setFont(font());
    m_text->setTextColor(palette().color(QPalette::Text));
    m_isStale = true;
}

void PhasePlot::refresh() {
    const uint64_t last = m_samples.last();
    if (!m_isStale && last == m_shown) return;
    m_shown = last;
    m_isStale = false;
    const double end = std::min(m_time->range().upper, m_time->pausedAt().value_or(m_time->range().upper));
    const uint64_t from = m_samples.find(std::max(m_time->range().lower, m_time->clearedAt()));
    const uint64_t to = m_samples.find(std::nextafter(end, HUGE_VAL));
    QVector<QCPCurveData> points;
    for (const Sample &sample : m_samples.spread(from, to, kIntervals))
        points.append(QCPCurveData(sample.time, sample[m_x], sample[m_y]));
    m_curve->data()->set(points, true);
    const bool hasEnd = !points.isEmpty() && std::isfinite(points.constLast().key + points.constLast().value);
    m_dot->setVisible(hasEnd); // NaN without a ghost
    if (hasEnd) m_dot->position->setCoords(points.constLast().key, points.constLast().value);
    if (m_fits) fit();
    updateReadOut();
    replot(QCustomPlot::rpQueuedReplot);
}

/// Two lengths get the same scale: the axis with fewer units per pixel is extended.
void PhasePlot::fit() {
    m_curve->rescaleAxes();
    for (QCPAxis *axis : {xAxis, yAxis}) {
        const double least = std::max(1e-6, 1e-9 * std::abs(axis->range().center()));
        const double half = 0.54 * std::max(axis->range().size(), least);
        axis->setRange(axis->range().center() - half, axis->range().center() + half);
    }
    if (QLatin1String(channelInfos()[size_t(m_x)].unit) != QLatin1String(channelInfos()[size_t(m_y)].unit)) return;
    const double acrossX = xAxis->range().size() / std::max(1, axisRect()->width());
    const double acrossY = yAxis->range().size() / std::max(1, axisRect()->height());
    if (acrossX < acrossY)
        xAxis->setScaleRatio(yAxis, 1.0);
    else
        yAxis->setScaleRatio(xAxis, 1.0);
}

/// The time of the curve's nearest point; nothing far from all of them.
std::optional<double> PhasePlot::timeAt(const QPointF &place) const {
    double nearest = 30.0; // pixels
    std::optional<double> time;
    for (const QCPCurveData &point : *m_curve->data()) {
        const QPointF its(xAxis->coordToPixel(point.key), yAxis->coordToPixel(point.value));
        const double distance = std::hypot(its.x() - place.x(), its.y() - place.y());
        if (!(distance < nearest)) continue; // also NaN
        nearest = distance;
        time = point.t;
    }
    return time;
}

void PhasePlot::updateReadOut() {
    const QCPCurveDataContainer &points = *m_curve->data();
    const bool isShown = m_time->cursor() && !points.isEmpty();
    m_cursorDot->setVisible(isShown);
    if (!isShown) return m_text->setText({});
    auto point = points.findBegin(*m_time->cursor(), false);
    if (point == points.constEnd()) --point;
    m_cursorDot->position->setCoords(point->key, point->value);
    m_text->setText(
        tr("%1 s   %2 | %3").arg(point->t, 0, 'f', 4).arg(point->key, 0, 'g', 6).arg(point->value, 0, 'g', 6));
}

void PhasePlot::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    if (isChangeOfLook(*event)) takeColours();
}

void PhasePlot::leaveEvent(QEvent *event) {
    m_time->setCursor(std::nullopt);
    QCustomPlot::leaveEvent(event);
}

void PhasePlot::resizeEvent(QResizeEvent *event) {
    QCustomPlot::resizeEvent(event);
    fitChart(*this);
    m_isStale = true;
}

void PhasePlot::mouseDoubleClickEvent(QMouseEvent *event) {
    m_fits = true;
    m_isStale = true;
    refresh();
    event->accept();
}

void PhasePlot::mouseMoveEvent(QMouseEvent *event) {
    QCustomPlot::mouseMoveEvent(event);
    if (event->buttons() & Qt::LeftButton) m_fits = false;
    if (event->buttons() == Qt::NoButton) m_time->setCursor(timeAt(event->position()));
}

void PhasePlot::wheelEvent(QWheelEvent *event) {
    m_fits = false;
    QCustomPlot::wheelEvent(event);
}

} // namespace inspector::ui
