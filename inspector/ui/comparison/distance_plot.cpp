// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/distance_plot.h"

#include "ui/comparison/deviation_text.h"
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

/// Smallest ratio of the upper to the lower end of the axis, so that a constant distance isn't drawn as a ragged line.
constexpr double kFewest = 1e2;
constexpr double kBelowZero = 0.4;     ///< lower border as a share of the position of zeros
const QCPRange kUsualRange(1e-5, 1e1); ///< mm
constexpr double kSmallest = 1e-12;    ///< mm, where zeros of the band are drawn on a logarithmic axis

/// With a tick 0 where zeros are drawn.
class ZeroTicker : public LogTicker {
public:
    /// height: the position of zeros; 0 if there are none.
    void setZero(double height) { m_zero = height; }

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar format, int precision) override {
        if (tick < 2.0 * m_zero) return QStringLiteral("0");
        return LogTicker::getTickLabel(tick, locale, format, precision);
    }

private:
    double m_zero = 0.0;
};

double powerOfTen(double exponent) { return std::pow(10.0, exponent); }

} // namespace

DistancePlot::DistancePlot(const SampleRing &samples, QWidget *parent)
    : TimePlot(samples, nullptr, parent)
    , m_ball(addKey(&Accents::ball))
    , m_ghost(addKey(&Accents::ghost))
    , m_low(addGraph())
    , m_high(addGraph())
    , m_middle(addGraph()) {
    setObjectName(QStringLiteral("distance_plot"));
    addCurve(Channel::Distance, &Accents::total);
    curves().front().graph->removeFromLegend(); // the axis label names it
    m_high->setBrush(kBandFill);
    m_high->setChannelFillGraph(m_low);
    m_middle->setPen(QPen(kBandColour, 1.5));
    for (QCPGraph *edge : {m_low, m_high}) edge->setPen(Qt::NoPen);
    for (QCPGraph *graph : {m_low, m_high, m_middle}) graph->removeFromLegend();
    makeLogarithmic(*yAxis, tr("Distance [mm]"));
    makeLogarithmic(*yAxis2, tr("Distance [R]"));
    for (QCPAxis *axis : {yAxis, yAxis2}) axis->setTicker(QSharedPointer<ZeroTicker>::create());
    yAxis2->setVisible(true);
    connect(yAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this, &DistancePlot::showRadii);
    yAxis->setRange(kUsualRange);
}

void DistancePlot::setRadius(double radius) {
    m_radius = radius;
    showRadii();
}

void DistancePlot::setNames(const QString &ball, const QString &ghost) {
    m_ballName = ball;
    m_ghostName = ghost;
    nameKeys();
    replot(rpQueuedReplot);
}

/// The dock's lists name the steppers, too, and a legend of three lines would leave little room for the curve.
void DistancePlot::nameKeys() {
    m_ball->setName(m_ballName);
    m_ghost->setName(m_ghostName);
    m_high->setName(tr("Not known (9 boards in 10)"));
    if (hasLegendInOneLine(*this)) return;
    m_ball->setName(tr("Ball"));
    m_ghost->setName(tr("Ghost"));
    m_high->setName(tr("Not known"));
}

void DistancePlot::showBand(const std::shared_ptr<const Band> &band) {
    if (band == m_band) return;
    m_band = band;
    if (band)
        m_high->addToLegend();
    else
        m_high->removeFromLegend();
    drawAnew();
}

/// Includes the next points outside of the range, so that the band reaches the border.
void DistancePlot::loadBesides(const QCPRange &times) {
    nameKeys();
    const std::vector<double> all = m_band ? m_band->times : std::vector<double>();
    const auto after = std::lower_bound(all.begin(), all.end(), times.lower);
    const auto first = size_t(std::max<ptrdiff_t>(after - all.begin() - 1, 0));
    const auto load = [&](QCPGraph *graph, const std::vector<double> &radii) {
        QVector<QCPGraphData> points;
        for (size_t i = first; i < all.size() && (i == first || all[i - 1] < times.upper); ++i)
            points.append(QCPGraphData(all[i], std::max(plotted(radii[i] * m_radius), kSmallest)));
        graph->data()->set(points, true);
    };
    const Band none;
    const Band &band = m_band ? *m_band : none;
    load(m_low, band.low);
    load(m_middle, band.middle);
    load(m_high, band.high);
}

void DistancePlot::showRadii() {
    const double radius = m_radius * kMillimetresPerMetre;
    yAxis2->setRange(yAxis->range().lower / radius, yAxis->range().upper / radius);
}

double DistancePlot::plotted(double value) const { return value * kMillimetresPerMetre; }

/// NaN is passed through.
double DistancePlot::drawn(double plotted) const {
    const double lowest = std::max(m_zero, yAxis->range().lower);
    return plotted < lowest ? lowest : plotted;
}

/// Whole decades; zeros get one more below, slightly above the border.
void DistancePlot::fitValues() {
    const QCPGraph *graph = curves().front().graph;
    bool hasAny = false;
    bool hasPositive = false;
    const QCPRange all = graph->getValueRange(hasAny);
    const QCPRange positive = graph->getValueRange(hasPositive, QCP::sdPositive);
    QCPRange fitted = kUsualRange;
    if (hasPositive) {
        fitted.lower = powerOfTen(std::floor(std::log10(positive.lower)));
        fitted.upper = std::max(powerOfTen(std::ceil(std::log10(positive.upper))), kFewest * fitted.lower);
    }
    bool hasBand = false;
    const QCPRange band = m_high->getValueRange(hasBand, QCP::sdPositive);
    if (hasBand) fitted.upper = std::max(fitted.upper, powerOfTen(std::ceil(std::log10(band.upper))));
    const bool hasZero = hasAny && all.lower <= 0.0;
    m_zero = hasZero ? fitted.lower / 10.0 : 0.0;
    if (hasZero) fitted.lower = kBelowZero * m_zero;
    yAxis->ticker().staticCast<ZeroTicker>()->setZero(m_zero);
    yAxis->setRange(fitted);
}

QString DistancePlot::textOf(const Sample &sample) const {
    if (std::isnan(sample[Channel::Distance])) return tr("No ghost");
    const bool isKnown = m_band && sample.time <= m_band->times.back();
    const QString limit =
        isKnown ? tr("; not known: %1").arg(distanceText(m_band->middleAt(sample.time) * m_radius, m_radius))
                : QString();
    return tr("%1, speed %2, energy %3%4")
        .arg(distanceText(sample[Channel::Distance], m_radius), speedDifferenceText(sample[Channel::SpeedDifference]),
             energyDifferenceText(sample[Channel::EnergyDifference]), limit);
}

} // namespace inspector::ui
