// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/velocity_plot.h"

#include "ui/theme.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kShortestWindow = 0.01; // s
constexpr double kLongestWindow = 3600.0;
constexpr double kSmallestSpan = 0.02; // m/s: noise around zero isn't blown up
constexpr double kMargin = 0.08;       // above and below the values, share of their span
constexpr double kShrink = 0.1;        // of the way per picture, so that the axis doesn't jump about

// The plot's colours; alpha keeps a line's own.
QColor mixed(const QColor &a, const QColor &b, double share) {
    return QColor::fromRgbF(float(a.redF() + share * (b.redF() - a.redF())),
                            float(a.greenF() + share * (b.greenF() - a.greenF())),
                            float(a.blueF() + share * (b.blueF() - a.blueF())));
}

} // namespace

VelocityPlot::VelocityPlot(const SampleRing &samples, QWidget *parent)
    : QCustomPlot(parent)
    , m_samples(samples)
    , m_cursorLine(new QCPItemStraightLine(this))
    , m_cursorText(new QCPItemText(this)) {
    setObjectName(QStringLiteral("velocity_plot"));
    setMinimumSize(200, 120);
    setMouseTracking(true);
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    setNoAntialiasingOnDrag(true);
    xAxis->setLabel(tr("Time [s]"));
    yAxis->setLabel(tr("Velocity [m/s]"));
    xAxis->setRange(0.0, m_window);
    yAxis->setRange(-0.1, 0.1);
    yAxis->setNumberFormat(QStringLiteral("g"));
    legend->setVisible(true);
    // The legend above the curves, in one line, where it hides none of them.
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
    addCurves();
    addReadOut();
    takeColours();
}

void VelocityPlot::addCurves() {
    for (const Channel channel : {Channel::VelocityX, Channel::VelocityY, Channel::Speed}) {
        QCPGraph *graph = addGraph();
        graph->setName(QString::fromUtf8(channelInfos()[size_t(channel)].label));
        graph->setAdaptiveSampling(false); // the ring gives one column per pixel already
        auto *dot = new QCPItemTracer(this);
        dot->setStyle(QCPItemTracer::tsCircle);
        dot->setSize(7);
        m_curves.push_back({channel, graph, dot});
    }
}

void VelocityPlot::addReadOut() {
    m_cursorText->setPadding(QMargins(6, 4, 6, 4));
    m_cursorText->setTextAlignment(Qt::AlignLeft);
    m_cursorText->position->setTypeX(QCPItemPosition::ptPlotCoords);
    m_cursorText->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_cursorText->setClipToAxisRect(false);
    updateReadOut();
}

void VelocityPlot::takeColours() {
    const QPalette &colours = palette();
    const QColor base = colours.color(QPalette::Base);
    const QColor text = colours.color(QPalette::Text);
    const QColor faint = mixed(base, text, 0.15);
    setBackground(base);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        for (const auto setter : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*setter)(QPen(mixed(base, text, 0.5)));
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(faint));
        axis->grid()->setZeroLinePen(QPen(mixed(base, text, 0.4)));
    }
    legend->setFont(font());
    legend->setTextColor(text);
    legend->setBrush(Qt::NoBrush);
    legend->setBorderPen(Qt::NoPen);
    const Accents accents = accentsFor(colours);
    const QColor lines[] = {accents.x, accents.y, accents.total};
    for (size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i].graph->setPen(QPen(lines[i], 1.5));
        m_curves[i].dot->setPen(QPen(base, 1.0));
        m_curves[i].dot->setBrush(lines[i]);
    }
    m_cursorLine->setPen(QPen(mixed(base, text, 0.6), 1.0, Qt::DashLine));
    m_cursorText->setColor(text);
    m_cursorText->setBrush(mixed(base, text, 0.08));
    m_cursorText->setPen(QPen(faint));
    m_cursorText->setFont(font());
    m_isStale = true;
}

std::optional<double> VelocityPlot::newestTime() const {
    Sample sample;
    const uint64_t last = m_samples.last();
    if (last == m_samples.first() || !m_samples.read(last - 1, sample)) return std::nullopt;
    return sample.time;
}

// A restart begins at time 0 again: what was cleared or paused before means nothing any more.
void VelocityPlot::noticeNewRun() {
    const uint64_t generation = m_samples.generation();
    if (generation == m_generation) return;
    m_generation = generation;
    m_clearedAt = 0.0;
    m_isStale = true;
    if (m_isFollowing) xAxis->setRange(0.0, m_window);
    setPaused(false);
}

void VelocityPlot::refresh() {
    noticeNewRun();
    const uint64_t last = m_samples.last();
    if (last == m_shown && !m_isStale) return;
    if (isPaused() && !m_isStale) return;
    m_shown = last;
    m_isStale = false;

    const std::optional<double> newest = newestTime();
    if (m_isFollowing && !isPaused() && newest) showTimeUpTo(*newest);
    std::optional<QCPRange> values;
    for (const Curve &curve : m_curves) {
        const QCPRange range = load(curve);
        if (values) values->expand(range);
        if (!values) values = range;
    }
    if (m_fitsValues && newest) fitValues(*values);
    updateReadOut();
    replot(QCustomPlot::rpQueuedReplot);
}

void VelocityPlot::showTimeUpTo(double time) {
    const double begin = std::max(m_clearedAt, time - m_window);
    xAxis->setRange(begin, begin + m_window);
}

// Puts the visible part of a channel into its curve; the range of its values.
QCPRange VelocityPlot::load(const Curve &curve) {
    const double from = std::max(xAxis->range().lower, m_clearedAt);
    const double to = std::min(xAxis->range().upper, m_pausedAt.value_or(xAxis->range().upper));
    const size_t pixels = size_t(std::max(1, int(axisRect()->width() * devicePixelRatioF())));
    QVector<QCPGraphData> points;
    QCPRange values(0.0, 0.0);
    if (from < to) {
        for (const Column &column : m_samples.columns(curve.channel, from, to, pixels)) {
            if (column.time < m_clearedAt) continue;
            points.append(QCPGraphData(column.time, column.min));
            if (column.max != column.min) points.append(QCPGraphData(column.time, column.max));
            values.expand(QCPRange(column.min, column.max));
        }
    }
    curve.graph->data()->set(points, true);
    return values;
}

void VelocityPlot::fitValues(QCPRange values) {
    if (values.size() < kSmallestSpan) {
        const double middle = values.center();
        values = QCPRange(middle - kSmallestSpan / 2, middle + kSmallestSpan / 2);
    }
    const double margin = kMargin * values.size();
    values = QCPRange(values.lower - margin, values.upper + margin);
    // Out at once, in slowly.
    const QCPRange now = yAxis->range();
    const double lower = std::min(values.lower, now.lower + kShrink * (values.lower - now.lower));
    const double upper = std::max(values.upper, now.upper + kShrink * (values.upper - now.upper));
    yAxis->setRange(lower, upper);
}

void VelocityPlot::setFollowing(bool isOn) {
    m_isStale = true;
    if (isOn) {
        m_fitsValues = true;
        setPaused(false);
    }
    if (m_isFollowing == isOn) return;
    m_isFollowing = isOn;
    emit followingChanged(isOn);
}

void VelocityPlot::setPaused(bool isOn) {
    m_isStale = true;
    if (isPaused() == isOn) return;
    m_pausedAt = isOn ? std::optional(newestTime().value_or(0.0)) : std::nullopt;
    emit pausedChanged(isOn);
}

void VelocityPlot::clear() {
    const std::optional<double> newest = newestTime();
    if (newest) m_clearedAt = std::nextafter(*newest, std::numeric_limits<double>::infinity());
    m_isStale = true;
    refresh();
}

Qt::Orientations VelocityPlot::orientationAt(QPointF position, Qt::KeyboardModifiers modifiers) const {
    const bool isLeftOfPlot = position.x() < axisRect()->left();
    return isLeftOfPlot || modifiers.testFlag(Qt::ControlModifier) ? Qt::Vertical : Qt::Horizontal;
}

void VelocityPlot::mousePressEvent(QMouseEvent *event) {
    axisRect()->setRangeDrag(orientationAt(event->position(), event->modifiers()));
    QCustomPlot::mousePressEvent(event);
}

void VelocityPlot::mouseMoveEvent(QMouseEvent *event) {
    QCustomPlot::mouseMoveEvent(event);
    m_cursor = event->position();
    m_isStale = true;
    if (!(event->buttons() & Qt::LeftButton)) return;
    // Dragged values stay where they were put; a dragged time no longer follows.
    if (axisRect()->rangeDrag() == Qt::Vertical) m_fitsValues = false;
    if (axisRect()->rangeDrag() == Qt::Horizontal) setFollowing(false);
}

void VelocityPlot::mouseDoubleClickEvent(QMouseEvent *event) {
    setFollowing(true);
    event->accept();
}

void VelocityPlot::wheelEvent(QWheelEvent *event) {
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

void VelocityPlot::leaveEvent(QEvent *event) {
    m_cursor.reset();
    m_isStale = true;
    QCustomPlot::leaveEvent(event);
}

void VelocityPlot::resizeEvent(QResizeEvent *event) {
    QCustomPlot::resizeEvent(event);
    m_isStale = true;
}

void VelocityPlot::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    const bool isLook = event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (isLook && !m_curves.empty()) takeColours();
}

std::optional<Sample> VelocityPlot::sampleAt(double time) const {
    const uint64_t after = m_samples.find(time);
    Sample right;
    Sample left;
    const bool hasRight = after < m_samples.last() && m_samples.read(after, right);
    const bool hasLeft = after > m_samples.first() && m_samples.read(after - 1, left);
    if (!hasLeft && !hasRight) return std::nullopt;
    if (!hasLeft || (hasRight && right.time - time < time - left.time)) return right;
    return left;
}

void VelocityPlot::updateReadOut() {
    m_readOut.reset();
    const bool isOverPlot = m_cursor && axisRect()->rect().contains(m_cursor->toPoint());
    if (isOverPlot) m_readOut = sampleAt(xAxis->pixelToCoord(m_cursor->x()));
    if (m_readOut && m_readOut->time < m_clearedAt) m_readOut.reset();
    m_cursorLine->setVisible(m_readOut.has_value());
    m_cursorText->setVisible(m_readOut.has_value());
    for (const Curve &curve : m_curves) curve.dot->setVisible(m_readOut.has_value());
    if (m_readOut) placeReadOut(*m_readOut);
}

void VelocityPlot::placeReadOut(const Sample &sample) {
    m_cursorLine->point1->setCoords(sample.time, 0.0);
    m_cursorLine->point2->setCoords(sample.time, 1.0);
    QString text = tr("Time  %1 s").arg(sample.time, 0, 'f', 4);
    for (const Curve &curve : m_curves) {
        const double value = sample[curve.channel];
        curve.dot->position->setCoords(sample.time, value);
        text += QStringLiteral("\n%1  %2 m/s").arg(curve.graph->name()).arg(value, 0, 'f', 5);
    }
    m_cursorText->setText(text);
    // Beside the line, on the side where there is more room.
    const bool isRight = xAxis->coordToPixel(sample.time) > axisRect()->center().x();
    m_cursorText->setPositionAlignment(Qt::AlignTop | (isRight ? Qt::AlignRight : Qt::AlignLeft));
    m_cursorText->position->setCoords(xAxis->pixelToCoord(xAxis->coordToPixel(sample.time) + (isRight ? -10 : 10)),
                                      0.04);
}

} // namespace inspector::ui
