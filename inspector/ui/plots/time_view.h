// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <optional>

#include <qcustomplot.h>

namespace inspector::ui {

// Which span of time plots show. Those that share one move together.
class TimeView : public QObject {
    Q_OBJECT

public:
    static constexpr double kShortestWindow = 0.01; // s
    static constexpr double kLongestWindow = 3600.0;

    // While it follows, the newest sample stays at the right border.
    bool isFollowing() const { return m_isFollowing; }
    void setFollowing(bool isOn); // on: also ends a pause
    // Stands still although samples go on coming; at this time, s.
    std::optional<double> pausedAt() const { return m_pausedAt; }
    void pauseAt(std::optional<double> time);
    // Nothing before is shown, s.
    double clearedAt() const { return m_clearedAt; }
    void clearAt(double time);
    // A run begins at time 0 again: what was cleared or paused before means nothing any more.
    void noticeRun(uint64_t generation);

    const QCPRange &range() const { return m_range; } // s
    void setRange(const QCPRange &range);
    void follow(double newest); // to this time, s
    void zoom(double factor);   // of what is followed
    // The mouse over any of the plots, s.
    std::optional<double> cursor() const { return m_cursor; }
    void setCursor(std::optional<double> time);

signals:
    void changed();
    void followingChanged(bool isOn);
    void pausedChanged(bool isOn);

private:
    double m_window = 10.0; // s in view while following
    QCPRange m_range{0.0, 10.0};
    bool m_isFollowing = true;
    std::optional<double> m_pausedAt;
    double m_clearedAt = 0.0;
    std::optional<double> m_cursor;
    uint64_t m_generation = 0;
};

} // namespace inspector::ui
