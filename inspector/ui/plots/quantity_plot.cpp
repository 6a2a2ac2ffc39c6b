// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/quantity_plot.h"

#include "core/setup/numbers.h"
#include "ui/plots/chart_style.h"
#include "ui/plots/quantity_menu.h"

#include <QDropEvent>
#include <QMimeData>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kMargin = 0.08; ///< margin above and below the values, share of their span
constexpr double kShrink = 0.1;  ///< share of the distance per picture, so that the axis moves smoothly
constexpr double kNoise = 1e-9;  ///< share of the largest value: smaller variations aren't magnified
const QString kLogarithmic = QStringLiteral("log:");
QColor Accents::*const kColours[] = {&Accents::x,     &Accents::y,        &Accents::total, &Accents::ball,
                                     &Accents::ghost, &Accents::selected, &Accents::alarm};

QString unitOf(Channel channel) { return QString::fromUtf8(channelInfos()[size_t(channel)].unit); }

QString withUnit(const QString &name, Channel channel) {
    const QString unit = printedUnit(unitOf(channel));
    return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

/// The common unit; empty if the quantities have different ones.
QString unitOf(const std::vector<Channel> &channels) {
    QString unit;
    for (const Channel channel : channels) {
        const QString its = unitOf(channel);
        if (channel != channels.front() && its != unit) return {};
        unit = its;
    }
    return printedUnit(unit);
}

const std::optional<Channel> &counterpartOf(Channel channel) { return channelInfos()[size_t(channel)].counterpart; }

/// The common name of the quantities, apart from a ghost's; empty if they differ.
QString nameOf(const std::vector<Channel> &channels) {
    if (channels.size() == 1) return QString::fromUtf8(channelInfos()[size_t(channels.front())].label);
    QString name;
    for (const Channel channel : channels) {
        const ChannelInfo &info = channelInfos()[size_t(channel)];
        const QString its = QString::fromUtf8(info.group);
        if (info.counterpart) continue;
        if (!name.isEmpty() && its != name) return {};
        name = its;
    }
    return name;
}

} // namespace

QString textOf(const PlotContent &content) {
    QStringList ids;
    for (const Channel channel : content.channels) ids += QString::fromUtf8(channelInfos()[size_t(channel)].id);
    return (content.isLogarithmic ? kLogarithmic : QString()) + ids.join(QLatin1Char(','));
}

PlotContent plotContentOf(const QString &text) {
    PlotContent content;
    content.isLogarithmic = text.startsWith(kLogarithmic);
    const QString ids = content.isLogarithmic ? text.mid(kLogarithmic.size()) : text;
    std::vector<Channel> &channels = content.channels;
    for (const QString &id : ids.split(QLatin1Char(','), Qt::SkipEmptyParts))
        for (size_t i = 0; i < kChannelCount; ++i)
            if (id == QLatin1String(channelInfos()[i].id) && std::ranges::count(channels, Channel(i)) == 0)
                channels.push_back(Channel(i));
    return content;
}

QuantityPlot::QuantityPlot(const SampleRing &samples, const PlotContent &content, std::shared_ptr<TimeView> time,
                           QWidget *parent)
    : TimePlot(samples, std::move(time), parent) {
    setAcceptDrops(true);
    yAxis->setRange(-0.1, 0.1);
    setContent(content);
}

void QuantityPlot::setContent(const PlotContent &content) {
    m_content = content;
    clearCurves();
    size_t number = 0;
    for (const Channel channel : content.channels) {
        const std::optional<Channel> &ball = counterpartOf(channel);
        const auto isBalls = [&ball](const Curve &curve) { return curve.channel == ball; };
        const auto beside = std::ranges::find_if(curves(), isBalls);
        const auto colour = beside == curves().end() ? kColours[number++ % std::size(kColours)] : beside->colour;
        addCurve(channel, colour, ball ? Qt::DashLine : Qt::SolidLine);
        if (ball) curves().back().graph->removeFromLegend(); // until it has values
    }
    const QString unit = unitOf(content.channels);
    if (unit.isEmpty()) // the axis can't tell
        for (const Curve &curve : curves()) curve.graph->setName(withUnit(curve.graph->name(), curve.channel));
    const QString name = nameOf(content.channels);
    const QString label = unit.isEmpty() ? name : (name + QStringLiteral(" [%1]").arg(unit)).trimmed();
    if (content.isLogarithmic) {
        makeLogarithmic(*yAxis, label);
    } else {
        yAxis->setLabel(label);
        yAxis->setScaleType(QCPAxis::stLinear);
        yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
        yAxis->setNumberFormat(QStringLiteral("g"));
        yAxis->setNumberPrecision(6);
    }
    fitAgain();
    emit contentChanged();
}

void QuantityPlot::add(Channel channel) {
    PlotContent content = m_content;
    if (std::find(content.channels.begin(), content.channels.end(), channel) != content.channels.end()) return;
    content.channels.push_back(channel);
    setContent(content);
}

void QuantityPlot::dragEnterEvent(QDragEnterEvent *event) {
    if (event->mimeData()->hasFormat(QLatin1String(kQuantityMime))) event->acceptProposedAction();
}

void QuantityPlot::dropEvent(QDropEvent *event) {
    const PlotContent dropped = plotContentOf(QString::fromUtf8(event->mimeData()->data(QLatin1String(kQuantityMime))));
    for (const Channel channel : dropped.channels) add(channel);
    event->acceptProposedAction();
}

void QuantityPlot::fitValues() {
    if (m_content.isLogarithmic)
        fitPowers();
    else
        fitSpan();
}

/// The legend names a ghost's curves while there is one.
void QuantityPlot::loadBesides(const QCPRange &) {
    for (const Curve &curve : curves()) {
        if (!counterpartOf(curve.channel)) continue;
        const auto isNumber = [](const QCPGraphData &point) { return std::isfinite(point.value); };
        if (std::ranges::any_of(*curve.graph->data(), isNumber))
            curve.graph->addToLegend();
        else
            curve.graph->removeFromLegend();
    }
}

/// Fits the axis to whole decades.
void QuantityPlot::fitPowers() {
    QCPRange values(0.0, 0.0);
    for (const QCPGraph *graph : graphs()) {
        bool hasValues = false;
        const QCPRange range = graph->getValueRange(hasValues, QCP::sdPositive, fittedTimes());
        if (hasValues) values = values.upper > 0.0 ? values.expanded(range) : range;
    }
    if (values.upper <= 0.0) return;
    const double lower = std::pow(10.0, std::floor(std::log10(values.lower)));
    yAxis->setRange(lower, std::max(10.0 * lower, std::pow(10.0, std::ceil(std::log10(values.upper)))));
}

void QuantityPlot::fitSpan() {
    bool hasAny = false;
    QCPRange values(0.0, 0.0);
    for (const QCPGraph *graph : graphs()) {
        bool hasValues = false;
        const QCPRange range = graph->getValueRange(hasValues, QCP::sdBoth, fittedTimes());
        if (hasValues) values = hasAny ? values.expanded(range) : range;
        hasAny = hasAny || hasValues;
    }
    const double largest = std::max(std::abs(values.lower), std::abs(values.upper));
    const double smallest = std::max(kNoise * largest, largest > 0.0 ? 0.0 : 0.02);
    const double span = std::max(values.size(), smallest);
    const double reach = 0.5 * span + kMargin * span;
    values = QCPRange(values.center() - reach, values.center() + reach);
    // Widen immediately, shrink slowly.
    const QCPRange now = fitsAtOnce() ? values : yAxis->range();
    const double lower = std::min(values.lower, now.lower + kShrink * (values.lower - now.lower));
    const double upper = std::max(values.upper, now.upper + kShrink * (values.upper - now.upper));
    yAxis->setRange(lower, upper);
}

/// Clamps values that a logarithmic axis can't show to its lower end.
double QuantityPlot::drawn(double plotted) const {
    if (!m_content.isLogarithmic || plotted > yAxis->range().lower) return plotted;
    return std::isnan(plotted) ? plotted : yAxis->range().lower;
}

QString QuantityPlot::textOf(const Sample &sample) const {
    const bool isMixed = unitOf(m_content.channels).isEmpty();
    QStringList parts;
    for (const Curve &curve : curves()) {
        const double value = sample[curve.channel];
        if (std::isnan(value) && counterpartOf(curve.channel)) continue;
        const QString number = std::isnan(value) ? QStringLiteral("–") : QStringLiteral("%1").arg(value, 0, 'g', 6);
        parts += isMixed ? (number + QLatin1Char(' ') + printedUnit(unitOf(curve.channel))).trimmed() : number;
    }
    return parts.join(QStringLiteral(" | "));
}

} // namespace inspector::ui
