// SPDX-License-Identifier: GPL-3.0-or-later
// When steps are due. Pure arithmetic on times that it is given, so that tests need no clock.
#pragma once

#include <chrono>
#include <cstdint>

namespace inspector {

using Clock = std::chrono::steady_clock;

// Deadlines are absolute, start + k * dt / speed, so lateness of one step doesn't move the next one. What is behind by
// more than the backlog limit isn't caught up but dropped and counted: the ball then waits instead of racing.
class Pacer {
public:
    static constexpr std::chrono::milliseconds kBacklogLimit{100};

    // dt: s, > 0. speed: simulated seconds per second, > 0. Takes effect from `now` on.
    void start(Clock::time_point now, double dt, double speed);

    // When the next step is due.
    Clock::time_point deadline() const;
    // Whether it is due at `now`. Drops a backlog beyond the limit.
    bool isDue(Clock::time_point now);
    // One step was made.
    void advance() { ++m_steps; }

    // From one step to the next.
    Clock::duration interval() const;
    // All that was dropped since the pacer was made, s of the clock.
    double lostTime() const { return m_lostTime; }
    void forgetLostTime() { m_lostTime = 0.0; }

private:
    Clock::time_point m_start{};
    uint64_t m_steps = 0;     // made since m_start
    double m_interval = 0.01; // s
    double m_lostTime = 0.0;
};

} // namespace inspector
