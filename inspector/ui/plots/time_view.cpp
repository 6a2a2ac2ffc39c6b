// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/time_view.h"

#include <algorithm>
#include <utility>

namespace inspector::ui {

void TimeView::setFollowing(bool isOn) {
    if (isOn) pauseAt(std::nullopt);
    m_followed.reset();
    const bool isNew = m_isFollowing != isOn;
    m_isFollowing = isOn;
    emit changed();
    if (isNew) emit followingChanged(isOn);
}

void TimeView::pauseAt(std::optional<double> time) {
    const bool isNew = m_pausedAt.has_value() != time.has_value();
    m_pausedAt = time;
    m_followed.reset();
    emit changed();
    if (isNew) emit pausedChanged(time.has_value());
}

void TimeView::clearAt(double time) {
    m_clearedAt = time;
    m_followed.reset();
    emit changed();
}

void TimeView::noticeRun(uint64_t generation) {
    if (generation == m_generation) return;
    m_generation = generation;
    m_clearedAt = 0.0;
    if (m_isFollowing) m_range = {0.0, m_window};
    pauseAt(std::nullopt);
}

void TimeView::setRange(const QCPRange &range) {
    const double half = 0.5 * std::clamp(range.size(), kShortestWindow, kLongestWindow);
    const double centre = std::max(range.center(), 0.0); // nothing is before the start
    const QCPRange bounded(centre - half, centre + half);
    if (bounded == m_range) return;
    m_range = bounded;
    emit changed();
}

void TimeView::follow(double newest, std::optional<double> moment) {
    const double time = moment.value_or(newest);
    if (std::exchange(m_followed, time) == time) return;
    if (moment && m_range.contains(time)) return;
    const double end = moment ? time + 0.5 * m_window : newest;
    const double begin = std::max(m_clearedAt, end - m_window);
    setRange({begin, begin + m_window});
}

void TimeView::setCursor(std::optional<double> time) {
    if (time == m_cursor) return;
    m_cursor = time;
    emit changed();
}

} // namespace inspector::ui
