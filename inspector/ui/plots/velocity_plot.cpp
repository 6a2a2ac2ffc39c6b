// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/velocity_plot.h"

#include <algorithm>

namespace inspector::ui {

namespace {

constexpr double kSmallestSpan = 0.02; // m/s: noise around zero isn't blown up
constexpr double kMargin = 0.08;       // above and below the values, share of their span
constexpr double kShrink = 0.1;        // of the way per picture, so that the axis doesn't jump about

} // namespace

VelocityPlot::VelocityPlot(const SampleRing &samples, QWidget *parent)
    : TimePlot(samples, parent) {
    setObjectName(QStringLiteral("velocity_plot"));
    yAxis->setLabel(tr("Velocity [m/s]"));
    yAxis->setRange(-0.1, 0.1);
    yAxis->setNumberFormat(QStringLiteral("g"));
    addCurve(Channel::VelocityX, &Accents::x);
    addCurve(Channel::VelocityY, &Accents::y);
    addCurve(Channel::Speed, &Accents::total);
}

void VelocityPlot::fitValues() {
    QCPRange values(0.0, 0.0);
    for (const Curve &curve : curves()) {
        bool hasValues = false;
        const QCPRange range = curve.graph->getValueRange(hasValues);
        if (hasValues) values.expand(range);
    }
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

QString VelocityPlot::textOf(const Sample &sample) const {
    QStringList lines;
    for (const Curve &curve : curves())
        lines += QStringLiteral("%1  %2 m/s").arg(curve.graph->name()).arg(sample[curve.channel], 0, 'f', 5);
    return lines.join(QLatin1Char('\n'));
}

} // namespace inspector::ui
