// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <optional>

#include <qcustomplot.h>

namespace inspector::ui {

/// The time range that plots show. Plots that share one view move together.
class TimeView : public QObject {
    Q_OBJECT

public:
    static constexpr double kShortestWindow = 0.01; ///< s
    static constexpr double kLongestWindow = 3600.0;

    /// While it follows, the newest sample is at the right border.
    bool isFollowing() const { return m_isFollowing; }
    void setFollowing(bool isOn); ///< on also ends a pause
    /// If set, the view is paused at this time, s, while samples keep arriving.
    std::optional<double> pausedAt() const { return m_pausedAt; }
    void pauseAt(std::optional<double> time);
    /// Nothing before this time is shown, s.
    double clearedAt() const { return m_clearedAt; }
    void clearAt(double time);
    /// Called when a new run begins at time 0: resets clear and pause.
    void noticeRun(uint64_t generation);

    const QCPRange &range() const { return m_range; } ///< s
    void setRange(const QCPRange &range);
    /// Follows to the newest time, s, or to the moment shown if there is one, which moves only what doesn't show it
    /// yet. Nothing is done until that time changes, so that the range can be zoomed while the ball is paused.
    void follow(double newest, std::optional<double> moment);
    void followAtThisZoom() { m_window = m_range.size(); }
    /// The cursor's time in any of the plots, s.
    std::optional<double> cursor() const { return m_cursor; }
    void setCursor(std::optional<double> time);

signals:
    void changed();
    void followingChanged(bool isOn);
    void pausedChanged(bool isOn);

private:
    double m_window = 10.0; ///< s, visible while following
    std::optional<double> m_followed;
    QCPRange m_range{0.0, 10.0};
    bool m_isFollowing = true;
    std::optional<double> m_pausedAt;
    double m_clearedAt = 0.0;
    std::optional<double> m_cursor;
    uint64_t m_generation = 0;
};

} // namespace inspector::ui
