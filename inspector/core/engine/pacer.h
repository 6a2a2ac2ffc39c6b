// SPDX-License-Identifier: GPL-3.0-or-later
// Computes when steps are due. Pure arithmetic on the times passed in, so that tests need no clock.
#pragma once

#include <chrono>
#include <cstdint>

namespace inspector {

using Clock = std::chrono::steady_clock;

/// Deadlines are absolute, start + k * dt / speed, so that a late step doesn't delay the next one. A backlog beyond the
/// limit isn't caught up with but dropped and counted: the simulation slows down instead of racing.
class Pacer {
public:
    static constexpr std::chrono::milliseconds kBacklogLimit{100};

    /// dt: s, > 0. speed: simulated seconds per second, > 0. Takes effect from `now` on.
    void start(Clock::time_point now, double dt, double speed);

    /// When the next step is due.
    Clock::time_point deadline() const;
    /// Whether it is due at `now`. Drops a backlog beyond the limit.
    bool isDue(Clock::time_point now);
    /// One step was made.
    void advance() { ++m_steps; }

    /// From one step to the next.
    Clock::duration interval() const;
    /// Total time dropped since construction, s of wall-clock time.
    double lostTime() const { return m_lostTime; }
    void forgetLostTime() { m_lostTime = 0.0; }

private:
    Clock::time_point m_start{};
    uint64_t m_steps = 0;     ///< made since m_start
    double m_interval = 0.01; ///< s
    double m_lostTime = 0.0;
};

} // namespace inspector
