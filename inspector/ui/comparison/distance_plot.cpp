// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/distance_plot.h"

#include "ui/comparison/deviation_text.h"
#include "ui/plots/chart_style.h"

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kPerMetre = 1e3;  // mm
constexpr double kFewest = 1e2;    // upper over lower border, so that a steady distance isn't a ragged line
constexpr double kBelowZero = 0.4; // the lower border, of the height of zeros
const QCPRange kUsual(1e-5, 1e1);  // mm

// Powers of ten, but 0 where zeros are drawn.
class ZeroTicker : public QCPAxisTickerLog {
public:
    // height: that zeros are drawn at; 0 if there are none.
    void setZero(double height) { m_zero = height; }

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar format, int precision) override {
        if (tick < 2.0 * m_zero) return QStringLiteral("0");
        return QCPAxisTickerLog::getTickLabel(tick, locale, format, precision);
    }

private:
    double m_zero = 0.0;
};

double powerOfTen(double exponent) { return std::pow(10.0, exponent); }

} // namespace

DistancePlot::DistancePlot(const SampleRing &samples, QWidget *parent)
    : TimePlot(samples, nullptr, parent)
    , m_ball(addKey(&Accents::ball))
    , m_ghost(addKey(&Accents::ghost)) {
    setObjectName(QStringLiteral("distance_plot"));
    addCurve(Channel::Distance, &Accents::total);
    curves().front().graph->removeFromLegend(); // the axis says it
    makeLogarithmic(*yAxis, tr("Distance [mm]"));
    makeLogarithmic(*yAxis2, tr("Distance [R]"));
    for (QCPAxis *axis : {yAxis, yAxis2}) axis->setTicker(QSharedPointer<ZeroTicker>::create());
    yAxis2->setVisible(true);
    connect(yAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this, &DistancePlot::showRadii);
    yAxis->setRange(kUsual);
}

void DistancePlot::setRadius(double radius) {
    m_radius = radius;
    showRadii();
}

void DistancePlot::setNames(const QString &ball, const QString &ghost) {
    m_ball->setName(ball);
    m_ghost->setName(ghost);
    replot(rpQueuedReplot);
}

void DistancePlot::showRadii() {
    const double radius = m_radius * kPerMetre;
    yAxis2->setRange(yAxis->range().lower / radius, yAxis->range().upper / radius);
}

double DistancePlot::plotted(double value) const { return value * kPerMetre; }

// NaN stays what it is.
double DistancePlot::drawn(double plotted) const {
    const double lowest = std::max(m_zero, yAxis->range().lower);
    return plotted < lowest ? lowest : plotted;
}

// From a power of ten to another; zeros lie at a further one, a little above the border.
void DistancePlot::fitValues() {
    const QCPGraph *graph = curves().front().graph;
    bool hasAny = false;
    bool hasPositive = false;
    const QCPRange all = graph->getValueRange(hasAny);
    const QCPRange positive = graph->getValueRange(hasPositive, QCP::sdPositive);
    QCPRange fitted = kUsual;
    if (hasPositive) {
        fitted.lower = powerOfTen(std::floor(std::log10(positive.lower)));
        fitted.upper = std::max(powerOfTen(std::ceil(std::log10(positive.upper))), kFewest * fitted.lower);
    }
    const bool hasZero = hasAny && all.lower <= 0.0;
    m_zero = hasZero ? fitted.lower / 10.0 : 0.0;
    if (hasZero) fitted.lower = kBelowZero * m_zero;
    yAxis->ticker().staticCast<ZeroTicker>()->setZero(m_zero);
    yAxis->setRange(fitted);
}

QString DistancePlot::textOf(const Sample &sample) const {
    if (std::isnan(sample[Channel::Distance])) return tr("No ghost");
    return tr("%1, speed %2, energy %3")
        .arg(distanceText(sample[Channel::Distance], m_radius), speedDifferenceText(sample[Channel::SpeedDifference]),
             energyDifferenceText(sample[Channel::EnergyDifference]));
}

} // namespace inspector::ui
