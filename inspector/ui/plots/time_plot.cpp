// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/time_plot.h"

#include "ui/plots/bounce_ticks.h"
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kShortestWindow = 0.01; // s
constexpr double kLongestWindow = 3600.0;

} // namespace

TimePlot::TimePlot(const SampleRing &samples, QWidget *parent)
    : QCustomPlot(parent)
    , m_samples(samples)
    , m_ticks(new BounceTicks(this))
    , m_cursorLine(new QCPItemStraightLine(this))
    , m_cursorText(new QCPItemText(this)) {
    setMinimumSize(200, 120);
    setMouseTracking(true);
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    setNoAntialiasingOnDrag(true);
    xAxis->setLabel(tr("Time [s]"));
    xAxis->setRange(0.0, m_window);
    layOutLegend();
    addReadOut();
    takeColours();
}

// Above the curves, in one line, where it hides none of them.
void TimePlot::layOutLegend() {
    legend->setVisible(true);
    auto *line = new QCPLayoutGrid;
    plotLayout()->insertRow(0);
    plotLayout()->addElement(0, 0, line);
    line->addElement(0, 0, legend);
    line->addElement(0, 1, new QCPLayoutElement(this));
    line->setColumnStretchFactor(0, 0.001);
    plotLayout()->setRowStretchFactor(0, 0.001);
    plotLayout()->setRowSpacing(0);
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend->setMargins(QMargins(70, 4, 8, 0));
    legend->setColumnSpacing(18);
}

void TimePlot::addCurve(Channel channel, QColor Accents::*colour) {
    QCPGraph *graph = addGraph();
    graph->setName(QString::fromUtf8(channelInfos()[size_t(channel)].label));
    graph->setAdaptiveSampling(false); // the ring gives one column per pixel already
    auto *dot = new QCPItemTracer(this);
    dot->setStyle(QCPItemTracer::tsCircle);
    dot->setSize(7);
    dot->setVisible(false);
    m_curves.push_back({channel, colour, graph, dot});
    takeColours();
}

QCPGraph *TimePlot::addKey(QColor Accents::*colour) {
    m_keys.push_back({addGraph(), colour});
    takeColours();
    return m_keys.back().graph;
}

void TimePlot::addReadOut() {
    m_cursorText->setPadding(QMargins(6, 4, 6, 4));
    m_cursorText->setTextAlignment(Qt::AlignLeft);
    m_cursorText->position->setTypeX(QCPItemPosition::ptPlotCoords);
    m_cursorText->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_cursorText->setClipToAxisRect(false);
    updateReadOut();
}

void TimePlot::takeColours() {
    const QPalette &colours = palette();
    const QColor base = colours.color(QPalette::Base);
    const QColor text = colours.color(QPalette::Text);
    applyChartStyle(*this);
    const Accents accents = accentsFor(colours);
    for (const Curve &curve : m_curves) {
        curve.graph->setPen(QPen(accents.*curve.colour, 1.5));
        curve.dot->setPen(QPen(base, 1.0));
        curve.dot->setBrush(accents.*curve.colour);
    }
    for (const Key &key : m_keys) key.graph->setPen(QPen(accents.*key.colour, 3.0));
    m_ticks->setColours(mixed(base, accents.selected, 0.7), accents.selected);
    m_cursorLine->setPen(QPen(mixed(base, text, 0.6), 1.0, Qt::DashLine));
    m_cursorText->setColor(text);
    m_cursorText->setBrush(mixed(base, text, 0.08));
    m_cursorText->setPen(QPen(mixed(base, text, 0.15)));
    m_cursorText->setFont(font());
    m_isStale = true;
}

std::optional<double> TimePlot::newestTime() const {
    Sample sample;
    const uint64_t last = m_samples.last();
    if (last == m_samples.first() || !m_samples.read(last - 1, sample)) return std::nullopt;
    return sample.time;
}

// A restart begins at time 0 again: what was cleared or paused before means nothing any more.
void TimePlot::noticeNewRun() {
    const uint64_t generation = m_samples.generation();
    if (generation == m_generation) return;
    m_generation = generation;
    m_clearedAt = 0.0;
    m_isStale = true;
    if (m_isFollowing) xAxis->setRange(0.0, m_window);
    setPaused(false);
}

void TimePlot::refresh() {
    noticeNewRun();
    const uint64_t last = m_samples.last();
    if (last == m_shown && !m_isStale) return;
    if (isPaused() && !m_isStale) return;
    m_shown = last;
    m_isStale = false;

    const std::optional<double> newest = newestTime();
    if (m_isFollowing && !isPaused() && newest) showTimeUpTo(*newest);
    for (const Curve &curve : m_curves) load(curve);
    if (m_fitsValues && newest) fitValues();
    for (const Curve &curve : m_curves)
        for (QCPGraphData &point : *curve.graph->data()) point.value = drawn(point.value);
    m_ticks->setRange(m_clearedAt, m_pausedAt.value_or(newest.value_or(0.0)));
    updateReadOut();
    replot(QCustomPlot::rpQueuedReplot);
}

void TimePlot::showTimeUpTo(double time) {
    const double begin = std::max(m_clearedAt, time - m_window);
    xAxis->setRange(begin, begin + m_window);
}

// Puts the visible part of a channel into its curve.
void TimePlot::load(const Curve &curve) {
    const double from = std::max(xAxis->range().lower, m_clearedAt);
    const double to = std::min(xAxis->range().upper, m_pausedAt.value_or(xAxis->range().upper));
    const size_t pixels = size_t(std::max(1, int(axisRect()->width() * devicePixelRatioF())));
    QVector<QCPGraphData> points;
    if (from < to) {
        for (const Column &column : m_samples.columns(curve.channel, from, to, pixels)) {
            if (column.time < m_clearedAt) continue;
            points.append(QCPGraphData(column.time, plotted(column.min)));
            if (column.max != column.min) points.append(QCPGraphData(column.time, plotted(column.max)));
        }
    }
    curve.graph->data()->set(points, true);
}

void TimePlot::setFollowing(bool isOn) {
    m_isStale = true;
    if (isOn) {
        m_fitsValues = true;
        setPaused(false);
    }
    if (m_isFollowing == isOn) return;
    m_isFollowing = isOn;
    emit followingChanged(isOn);
}

void TimePlot::setPaused(bool isOn) {
    m_isStale = true;
    if (isPaused() == isOn) return;
    m_pausedAt = isOn ? std::optional(newestTime().value_or(0.0)) : std::nullopt;
    emit pausedChanged(isOn);
}

void TimePlot::showBounces(std::vector<double> times, std::optional<double> selected) {
    if (m_ticks->show(std::move(times), selected)) m_isStale = true;
}

void TimePlot::clear() {
    const std::optional<double> newest = newestTime();
    if (newest) m_clearedAt = std::nextafter(*newest, std::numeric_limits<double>::infinity());
    m_isStale = true;
    refresh();
}

Qt::Orientations TimePlot::orientationAt(QPointF position, Qt::KeyboardModifiers modifiers) const {
    const bool isLeftOfPlot = position.x() < axisRect()->left();
    return isLeftOfPlot || modifiers.testFlag(Qt::ControlModifier) ? Qt::Vertical : Qt::Horizontal;
}

void TimePlot::mousePressEvent(QMouseEvent *event) {
    axisRect()->setRangeDrag(orientationAt(event->position(), event->modifiers()));
    m_pressedAt = event->position();
    QCustomPlot::mousePressEvent(event);
}

void TimePlot::mouseMoveEvent(QMouseEvent *event) {
    QCustomPlot::mouseMoveEvent(event);
    m_cursor = event->position();
    m_isStale = true;
    if (!(event->buttons() & Qt::LeftButton)) return;
    // Dragged values stay where they were put; a dragged time no longer follows.
    if (axisRect()->rangeDrag() == Qt::Vertical) m_fitsValues = false;
    if (axisRect()->rangeDrag() == Qt::Horizontal) setFollowing(false);
}

void TimePlot::mouseReleaseEvent(QMouseEvent *event) {
    QCustomPlot::mouseReleaseEvent(event);
    if (event->button() != Qt::LeftButton || event->position() != m_pressedAt) return;
    if (const std::optional<double> time = m_ticks->timeAt(event->position())) emit bounceClicked(*time);
}

void TimePlot::mouseDoubleClickEvent(QMouseEvent *event) {
    setFollowing(true);
    event->accept();
}

void TimePlot::wheelEvent(QWheelEvent *event) {
    const Qt::Orientations orientation = orientationAt(event->position(), event->modifiers());
    m_isStale = true;
    event->accept();
    if (orientation == Qt::Horizontal && m_isFollowing && !isPaused()) {
        const double factor = std::pow(axisRect()->rangeZoomFactor(Qt::Horizontal), event->angleDelta().y() / 120.0);
        m_window = std::clamp(m_window * factor, kShortestWindow, kLongestWindow);
        return;
    }
    if (orientation == Qt::Vertical) m_fitsValues = false;
    axisRect()->setRangeZoom(orientation);
    QCustomPlot::wheelEvent(event);
}

void TimePlot::leaveEvent(QEvent *event) {
    m_cursor.reset();
    m_isStale = true;
    QCustomPlot::leaveEvent(event);
}

void TimePlot::resizeEvent(QResizeEvent *event) {
    QCustomPlot::resizeEvent(event);
    m_isStale = true;
}

void TimePlot::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    const bool isLook = event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (isLook && !m_curves.empty()) takeColours();
}

std::optional<Sample> TimePlot::sampleAt(double time) const {
    const uint64_t after = m_samples.find(time);
    Sample right;
    Sample left;
    const bool hasRight = after < m_samples.last() && m_samples.read(after, right);
    const bool hasLeft = after > m_samples.first() && m_samples.read(after - 1, left);
    if (!hasLeft && !hasRight) return std::nullopt;
    if (!hasLeft || (hasRight && right.time - time < time - left.time)) return right;
    return left;
}

void TimePlot::updateReadOut() {
    m_readOut.reset();
    const bool isOverPlot = m_cursor && axisRect()->rect().contains(m_cursor->toPoint());
    if (isOverPlot) m_readOut = sampleAt(xAxis->pixelToCoord(m_cursor->x()));
    if (m_readOut && m_readOut->time < m_clearedAt) m_readOut.reset();
    m_cursorLine->setVisible(m_readOut.has_value());
    m_cursorText->setVisible(m_readOut.has_value());
    for (const Curve &curve : m_curves) curve.dot->setVisible(m_readOut.has_value());
    if (m_readOut) placeReadOut(*m_readOut);
}

void TimePlot::placeReadOut(const Sample &sample) {
    m_cursorLine->point1->setCoords(sample.time, 0.0);
    m_cursorLine->point2->setCoords(sample.time, 1.0);
    const QString text = tr("Time  %1 s").arg(sample.time, 0, 'f', 4);
    for (const Curve &curve : m_curves)
        curve.dot->position->setCoords(sample.time, drawn(plotted(sample[curve.channel])));
    m_cursorText->setText(text + QLatin1Char('\n') + textOf(sample));
    // Beside the line, on the side where there is more room.
    const bool isRight = xAxis->coordToPixel(sample.time) > axisRect()->center().x();
    m_cursorText->setPositionAlignment(Qt::AlignTop | (isRight ? Qt::AlignRight : Qt::AlignLeft));
    m_cursorText->position->setCoords(xAxis->pixelToCoord(xAxis->coordToPixel(sample.time) + (isRight ? -10 : 10)),
                                      0.04);
}

} // namespace inspector::ui
