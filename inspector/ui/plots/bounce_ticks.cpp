// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/bounce_ticks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {
constexpr double kHeight = 9.0; ///< pixels
constexpr double kTickReach = 6.0;
} // namespace

BounceTicks::BounceTicks(QCustomPlot *plot)
    : QCPAbstractItem(plot) {
    setSelectable(false);
}

bool BounceTicks::show(std::vector<double> times, std::optional<double> selected) {
    if (times == m_times && selected == m_selected) return false;
    m_times = std::move(times);
    m_selected = selected;
    return true;
}

void BounceTicks::setRange(double from, double to) {
    m_from = from;
    m_to = to;
}

void BounceTicks::setColours(const QColor &tick, const QColor &selected) {
    m_tick = tick;
    m_selectedColour = selected;
}

std::optional<double> BounceTicks::timeAt(const QPointF &pixel) const {
    const QCPAxis *axis = parentPlot()->xAxis;
    const double height = parentPlot()->axisRect()->rect().bottom() - pixel.y();
    if (height < -kTickReach || height > kHeight + kTickReach) return std::nullopt;
    const auto distance = [&](double time) { return std::abs(axis->coordToPixel(time) - pixel.x()); };
    const auto isNearer = [&](double a, double b) { return distance(a) < distance(b); };
    const auto nearest = std::min_element(m_times.begin(), m_times.end(), isNearer);
    if (nearest == m_times.end() || *nearest < m_from || *nearest > m_to || distance(*nearest) > kTickReach) return {};
    return *nearest;
}

void BounceTicks::draw(QCPPainter *painter) {
    const QRect area = parentPlot()->axisRect()->rect();
    const QCPAxis *axis = parentPlot()->xAxis;
    const double bottom = area.bottom();
    const double from = std::max(m_from, axis->range().lower);
    const double to = std::min(m_to, axis->range().upper);
    painter->setAntialiasing(false);
    painter->setPen(QPen(m_tick, 1.5));
    double drawn = -1.0; // ticks in the same pixel are drawn once
    for (auto time = std::lower_bound(m_times.begin(), m_times.end(), from); time != m_times.end(); ++time) {
        if (*time > to) break;
        const double x = std::round(axis->coordToPixel(*time));
        if (x != drawn) painter->drawLine(QLineF(x, bottom, x, bottom - kHeight));
        drawn = x;
    }
    if (!m_selected || *m_selected < from || *m_selected > to) return;
    const double x = std::round(axis->coordToPixel(*m_selected));
    painter->setPen(QPen(m_selectedColour, 1.5));
    painter->drawLine(QLineF(x, bottom, x, area.top()));
    painter->setBrush(m_selectedColour);
    painter->setAntialiasing(true);
    const QPointF tip[] = {{x, bottom - kHeight}, {x - 5.0, bottom}, {x + 5.0, bottom}};
    painter->drawPolygon(tip, 3);
}

} // namespace inspector::ui
