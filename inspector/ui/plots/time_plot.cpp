// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/time_plot.h"

#include "ui/plots/bounce_ticks.h"
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QStyleOptionFocusRect>

namespace inspector::ui {

namespace {

constexpr double kSmallestSpan = 1e-9; ///< smallest span of values
constexpr double kLargestSpan = 1e9;
constexpr float kBesideAlpha = 0.35F;
constexpr int kReadOutMargin = 12;     ///< pixels beside the legend
constexpr double kLeastStretch = 1e-3; ///< of a row: as high as it needs to be

/// Limits the range, keeping its middle. A logarithmic axis is limited by its values.
QCPRange bounded(const QCPAxis &axis) {
    const QCPRange range = axis.range();
    if (axis.scaleType() == QCPAxis::stLogarithmic) return range.bounded(kSmallestSpan * kSmallestSpan, kLargestSpan);
    const double half = 0.5 * std::clamp(range.size(), kSmallestSpan, kLargestSpan);
    return {range.center() - half, range.center() + half};
}

} // namespace

/// Uses the available room instead of requesting it, except for the height of its lines.
class ReadOutText : public QCPTextElement {
public:
    explicit ReadOutText(QCustomPlot *plot)
        : QCPTextElement(plot) {
        setObjectName(QStringLiteral("read_out"));
        setTextFlags(Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
    }
    QSize minimumOuterSizeHint() const override { return {0, m_height}; }
    QSize maximumOuterSizeHint() const override { return {QWIDGETSIZE_MAX, QWIDGETSIZE_MAX}; }

    /// The width of a text and its margins in one line.
    int lineWidth(const QString &text) const {
        constexpr int kRounding = 2; // pixels
        return QFontMetrics(font()).horizontalAdvance(text) + margins().left() + margins().right() + kRounding;
    }
    /// Asks for the height that the text has in lines of this width, margins included.
    void fitHeight(int width) {
        const QFontMetrics metrics(font());
        const QRect room(0, 0, std::max(1, width - margins().left() - margins().right()), QWIDGETSIZE_MAX);
        m_height = std::max(metrics.height(), metrics.boundingRect(room, textFlags(), text()).height());
    }

private:
    int m_height = 0;
};

TimePlot::TimePlot(const SampleRing &samples, std::shared_ptr<TimeView> time, QWidget *parent)
    : QCustomPlot(parent)
    , m_samples(samples)
    , m_time(time ? std::move(time) : std::make_shared<TimeView>())
    , m_ticks(new BounceTicks(this))
    , m_cursorLine(new QCPItemStraightLine(this))
    , m_momentLine(new QCPItemStraightLine(this))
    , m_text(new ReadOutText(this)) {
    setMinimumWidth(140);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    setNoAntialiasingOnDrag(true);
    setLocale(QLocale::c());
    axisRect()->setMinimumSize(50, 20);
    layOutLegend();
    takeColours();
    fitLabels(height());
    fitLeastHeight();
    connect(m_time.get(), &TimeView::changed, this, [this] { m_isStale = true; });
    connect(xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), m_time.get(), &TimeView::setRange);
    xAxis->setRange(m_time->range());
    m_cursorLine->setVisible(false); // until refresh(), as a subclass has the values
    m_momentLine->setVisible(false);
}

void TimePlot::layOutLegend() {
    m_legendLine = putLegendAbove(*this, leftMargin());
    placeReadOut();
}

/// In a small plot the legend takes less of it.
void TimePlot::fitLegend() {
    constexpr int kSmall = 23; // lines of text
    const bool isSmall = width() < kSmall * fontMetrics().height();
    legend->setIconSize(isSmall ? QSize(14, 14) : QSize(32, 18));
    legend->setColumnSpacing(isSmall ? 8 : 18);
    legend->setRowSpacing(isSmall ? 0 : 3);
    legend->setMargins(QMargins(isSmall ? std::max(6, m_labels.unitWidth()) : leftMargin(), 4, 8, 0));
}

/// Room for usual numbers and for the label, the same in all plots, so that stacked ones are aligned.
int TimePlot::leftMargin() const {
    constexpr int kTicks = 14; // pixels, with the gaps between ticks, numbers and label
    return fontMetrics().horizontalAdvance(QStringLiteral("-0.0000")) + fontMetrics().height() + kTicks;
}

void TimePlot::fitLabels(int height) { m_labels.fit(height, tr("Time [s]"), m_place.isLowest); }

/// Room for the legend, some lines of curves, and the times.
void TimePlot::fitLeastHeight() {
    const double lines = m_place.isLowest ? 4.5 : 3.0; // of text
    setMinimumHeight(legend->minimumOuterSizeHint().height() + int(lines * fontMetrics().height()));
}

void TimePlot::setPlace(const StackPlace &place) {
    m_place = place;
    m_isStale = true;
}

int TimePlot::roomBesideLegend() const { return std::max(0, width() - legend->minimumOuterSizeHint().width()); }

/// Puts the read-out beside the legend if there is room for the longest so far, so that the curves don't move at each
/// value, and otherwise below it.
void TimePlot::placeReadOut() {
    if (m_readOut) m_longestReadOut = std::max(m_longestReadOut, m_text->lineWidth(m_text->text()));
    const bool isBelow = m_longestReadOut > roomBesideLegend();
    m_text->setMargins(QMargins(std::max(kReadOutMargin, isBelow ? m_labels.unitWidth() : 0), 0, 4, 0));
    m_text->fitHeight(width());
    QCPLayoutGrid *place = isBelow ? plotLayout() : m_legendLine;
    if (m_text->layout() == place) return;
    if (m_text->layout()) m_text->layout()->take(m_text);
    if (isBelow) {
        plotLayout()->insertRow(1);
        plotLayout()->setRowStretchFactor(1, kLeastStretch);
    } else {
        plotLayout()->simplify(); // removes the row that it had
    }
    isBelow ? place->addElement(1, 0, m_text) : place->addElement(0, 1, m_text);
}

void TimePlot::addCurve(Channel channel, QColor Accents::*colour, Qt::PenStyle style) {
    QCPGraph *graph = addGraph();
    graph->setName(QString::fromUtf8(channelInfos()[size_t(channel)].label));
    graph->setAdaptiveSampling(false); // the ring already returns one column per pixel
    auto *dot = new QCPItemTracer(this);
    dot->setStyle(QCPItemTracer::tsCircle);
    dot->setSize(7);
    dot->setVisible(false);
    m_curves.push_back({channel, colour, style, graph, nullptr, dot});
    setAccessibleName((m_curves.size() == 1 ? tr("Plot of %1") : accessibleName() + tr(", %1")).arg(graph->name()));
    takeColours();
}

void TimePlot::clearCurves() {
    for (const Curve &curve : m_curves) {
        removeItem(curve.dot);
        removePlottable(curve.graph);
        if (curve.beside) removePlottable(curve.beside);
    }
    m_curves.clear();
    m_longestReadOut = 0;
    m_isStale = true;
}

QCPGraph *TimePlot::addKey(QColor Accents::*colour) {
    m_keys.push_back({addGraph(), colour});
    takeColours();
    return m_keys.back().graph;
}

void TimePlot::takeColours() {
    const QPalette &colours = palette();
    const QColor base = colours.color(QPalette::Base);
    const QColor text = colours.color(QPalette::Text);
    applyChartStyle(*this);
    const Accents accents = accentsFor(colours);
    for (const Curve &curve : m_curves) {
        QColor colour = accents.*curve.colour;
        curve.graph->setPen(QPen(colour, 1.5, curve.style));
        curve.dot->setPen(QPen(base, 1.0));
        curve.dot->setBrush(colour);
        colour.setAlphaF(kBesideAlpha);
        if (curve.beside) curve.beside->setPen(QPen(colour, 1.5, curve.style));
    }
    for (const Key &key : m_keys) key.graph->setPen(QPen(accents.*key.colour, 3.0));
    m_ticks->setColours(mixed(base, accents.selected, 0.7), accents.selected);
    m_cursorLine->setPen(QPen(mixed(base, text, 0.6), 1.0, Qt::DashLine));
    m_momentLine->setPen(QPen(mixed(base, text, 0.8), 1.5));
    m_text->setTextColor(text);
    m_text->setFont(font());
    m_labels.takeLook();
    QMargins margins = axisRect()->minimumMargins();
    margins.setLeft(leftMargin());
    axisRect()->setMinimumMargins(margins);
    m_isStale = true;
}

std::optional<double> TimePlot::newestTime() const {
    Sample sample;
    const uint64_t last = m_samples.last();
    if (last == m_samples.first() || !m_samples.read(last - 1, sample)) return std::nullopt;
    return sample.time;
}

void TimePlot::refresh() {
    m_time->noticeRun(m_samples.generation());
    const uint64_t last = m_samples.last();
    if (!m_isStale && (last == m_shown || isPaused())) return;
    m_shown = last;

    const std::optional<double> newest = newestTime();
    if (isFollowing() && !isPaused() && newest) m_time->follow(*newest, m_context.moment);
    xAxis->setRange(m_time->range());
    for (Curve &curve : m_curves) {
        load(curve);
        loadBeside(curve);
    }
    loadBesides(shownTimes());
    fitLabels(height());
    fitLegend();
    fitChart(*this);
    fitLeastHeight();
    if (m_fitsValues && newest) fitValues();
    m_fitsAtOnce = false;
    for (QCPGraph *graph : graphs())
        for (QCPGraphData &point : *graph->data()) point.value = drawn(point.value);
    m_ticks->setRange(m_time->clearedAt(), m_time->pausedAt().value_or(newest.value_or(0.0)));
    updateReadOut();
    m_isStale = false;
    replot(QCustomPlot::rpQueuedReplot);
}

std::vector<QCPGraph *> TimePlot::graphs() const {
    std::vector<QCPGraph *> graphs;
    for (const Curve &curve : m_curves) {
        graphs.push_back(curve.graph);
        if (curve.beside) graphs.push_back(curve.beside);
    }
    return graphs;
}

QCPRange TimePlot::shownTimes() const {
    QCPRange times = xAxis->range();
    times.lower = std::max(times.lower, m_time->clearedAt());
    times.upper = std::min(times.upper, m_time->pausedAt().value_or(times.upper));
    return times;
}

/// The fall after a run would squeeze its curves into a line.
QCPRange TimePlot::fittedTimes() const {
    const QCPRange times = shownTimes();
    const double end = std::min(times.upper, m_context.left.value_or(times.upper));
    return end > times.lower ? QCPRange(times.lower, end) : times;
}

/// Loads the visible part of a channel into its curve.
void TimePlot::load(const Curve &curve) {
    const auto [from, to] = shownTimes();
    const size_t pixels = size_t(std::max(1, int(axisRect()->width() * devicePixelRatioF())));
    QVector<QCPGraphData> points;
    if (from < to) {
        for (const Column &column : m_samples.columns(curve.channel, from, to, pixels)) {
            if (column.time < m_time->clearedAt()) continue;
            points.append(QCPGraphData(column.time, plotted(column.min)));
            if (column.max != column.min) points.append(QCPGraphData(column.time, plotted(column.max)));
        }
    }
    curve.graph->data()->set(points, true);
}

void TimePlot::loadBeside(Curve &curve) {
    const bool hasAny = m_context.beside && !m_context.beside->empty();
    if (!curve.beside && !hasAny) return;
    if (!curve.beside) {
        curve.beside = addGraph();
        curve.beside->setName(tr("Pale: another run"));
        takeColours();
    }
    const bool isNamed = hasAny && &curve == &m_curves.front(); // once for all curves
    isNamed ? curve.beside->addToLegend() : curve.beside->removeFromLegend();
    QVector<QCPGraphData> points;
    if (hasAny)
        for (const Sample &sample : *m_context.beside)
            points.append(QCPGraphData(sample.time, plotted(sample[curve.channel])));
    curve.beside->data()->set(points, true);
}

void TimePlot::fitAgain() {
    m_fitsValues = m_fitsAtOnce = true;
    m_isStale = true;
}

void TimePlot::setFollowing(bool isOn) {
    if (isOn) fitAgain();
    m_time->setFollowing(isOn);
}

void TimePlot::setPaused(bool isOn) {
    if (isPaused() != isOn) m_time->pauseAt(isOn ? std::optional(newestTime().value_or(0.0)) : std::nullopt);
}

void TimePlot::showBounces(std::vector<double> times, std::optional<double> selected) {
    if (m_ticks->show(std::move(times), selected)) m_isStale = true;
}

void TimePlot::setContext(const RunContext &context) {
    if (context == m_context) return;
    m_context = context;
    m_isStale = true;
}

void TimePlot::clear() {
    const std::optional<double> newest = newestTime();
    if (newest) m_time->clearAt(std::nextafter(*newest, std::numeric_limits<double>::infinity()));
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
    const bool isOverPlot = axisRect()->rect().contains(event->position().toPoint());
    m_time->setCursor(isOverPlot ? std::optional(xAxis->pixelToCoord(event->position().x())) : std::nullopt);
    if (!(event->buttons() & Qt::LeftButton)) return;
    m_isStale = true;
    // Values that were dragged aren't fitted any more; after dragging time, the plot doesn't follow.
    if (axisRect()->rangeDrag() == Qt::Vertical) m_fitsValues = false;
    if (axisRect()->rangeDrag() == Qt::Horizontal) m_time->setFollowing(false);
}

void TimePlot::mouseReleaseEvent(QMouseEvent *event) {
    QCustomPlot::mouseReleaseEvent(event);
    if (event->button() != Qt::LeftButton || event->position() != m_pressedAt) return;
    if (const std::optional<double> time = m_ticks->timeAt(event->position())) emit bounceClicked(*time);
}

/// Replots explicitly, because nothing else may have changed.
void TimePlot::mouseDoubleClickEvent(QMouseEvent *event) {
    setFollowing(true);
    refresh();
    event->accept();
}

void TimePlot::wheelEvent(QWheelEvent *event) {
    const Qt::Orientations orientation = orientationAt(event->position(), event->modifiers());
    m_isStale = true;
    event->accept();
    if (orientation == Qt::Vertical) m_fitsValues = false;
    axisRect()->setRangeZoom(orientation);
    QCustomPlot::wheelEvent(event);
    if (orientation == Qt::Horizontal) return endZoom();
    yAxis->setRange(bounded(*yAxis));
}

void TimePlot::endZoom() {
    xAxis->setRange(m_time->range()); // which is limited
    if (isFollowing() && !isPaused()) m_time->followAtThisZoom();
}

void TimePlot::keyPressEvent(QKeyEvent *event) {
    constexpr double kNearer = 0.8;
    constexpr double kPage = 0.5; // of the times shown
    const bool isOfValues = event->modifiers().testFlag(Qt::ControlModifier);
    const auto zoom = isOfValues ? &TimePlot::zoomValues : &TimePlot::zoomTime;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key, without Shift
        return (this->*zoom)(kNearer);
    case Qt::Key_Minus:
        return (this->*zoom)(1.0 / kNearer);
    case Qt::Key_PageUp:
        return moveTime(-kPage);
    case Qt::Key_PageDown:
        return moveTime(kPage);
    case Qt::Key_0:
        return setFollowing(true);
    default:
        QCustomPlot::keyPressEvent(event);
    }
}

/// While it follows, the newest values stay at the right border, and before they reach it the first ones at the left.
void TimePlot::zoomTime(double factor) {
    const QCPRange times = xAxis->range();
    const double followed = newestTime().value_or(0.0) < times.upper ? times.lower : times.upper;
    xAxis->scaleRange(factor, isFollowing() ? followed : times.center());
    endZoom();
    m_isStale = true;
}

void TimePlot::zoomValues(double factor) {
    yAxis->scaleRange(factor);
    yAxis->setRange(bounded(*yAxis));
    m_fitsValues = false;
    m_isStale = true;
}

void TimePlot::moveTime(double share) {
    m_time->setFollowing(false);
    xAxis->moveRange(share * xAxis->range().size());
    xAxis->setRange(m_time->range());
    m_isStale = true;
}

/// Frames the plot that has the keyboard.
void TimePlot::paintEvent(QPaintEvent *event) {
    QCustomPlot::paintEvent(event);
    if (!hasFocus()) return;
    QStyleOptionFocusRect option;
    option.initFrom(this);
    QPainter painter(this);
    style()->drawPrimitive(QStyle::PE_FrameFocusRect, &option, &painter, this);
}

void TimePlot::leaveEvent(QEvent *event) {
    m_time->setCursor(std::nullopt);
    QCustomPlot::leaveEvent(event);
}

void TimePlot::resizeEvent(QResizeEvent *event) {
    QCustomPlot::resizeEvent(event);
    m_isStale = true;
}

void TimePlot::changeEvent(QEvent *event) {
    QCustomPlot::changeEvent(event);
    if (isChangeOfLook(*event)) takeColours();
}

std::optional<Sample> TimePlot::sampleAt(double time) const {
    const uint64_t after = m_samples.find(time);
    Sample right;
    Sample left;
    const bool hasRight = after < m_samples.last() && m_samples.read(after, right);
    const bool hasLeft = after > m_samples.first() && m_samples.read(after - 1, left);
    if (!hasLeft && !hasRight) return std::nullopt;
    if (!hasLeft && time < 0.0) return std::nullopt;
    if (!hasLeft || (hasRight && right.time - time < time - left.time)) return right;
    return left;
}

/// Hints on how to use the plots, if there is room for them: after a resize, the layout has the new one only later.
QString TimePlot::hint() const {
    const QString text = tr("Wheel: zoom · drag: move · double click: follow");
    return m_place.isHighest && m_text->lineWidth(text) <= roomBesideLegend() ? text : QString();
}

void TimePlot::dressForPicture(int height) {
    m_text->setVisible(m_readOut.has_value());
    fitLabels(height);
}

void TimePlot::dressForWindow() {
    m_text->setVisible(true);
    fitLabels(height());
}

void TimePlot::updateReadOut() {
    m_readOut = m_time->cursor() ? sampleAt(*m_time->cursor()) : std::nullopt;
    if (m_readOut && m_readOut->time < m_time->clearedAt()) m_readOut.reset();
    m_cursorLine->setVisible(m_readOut.has_value());
    m_momentLine->setVisible(m_context.moment.has_value());
    if (m_context.moment) {
        m_momentLine->point1->setCoords(*m_context.moment, 0.0);
        m_momentLine->point2->setCoords(*m_context.moment, 1.0);
    }
    for (const Curve &curve : m_curves) {
        const double value = m_readOut ? drawn(plotted((*m_readOut)[curve.channel])) : std::nan("");
        curve.dot->setVisible(std::isfinite(value)); // NaN without a ghost
        if (std::isfinite(value)) curve.dot->position->setCoords(m_readOut->time, value);
    }
    m_text->setText(m_readOut ? tr("%1 s   %2").arg(m_readOut->time, 0, 'f', 4).arg(textOf(*m_readOut)) : hint());
    m_text->setTextColor(m_readOut ? palette().color(QPalette::Text) : palette().color(QPalette::PlaceholderText));
    placeReadOut();
    if (!m_readOut) return;
    m_cursorLine->point1->setCoords(m_readOut->time, 0.0);
    m_cursorLine->point2->setCoords(m_readOut->time, 1.0);
}

} // namespace inspector::ui
