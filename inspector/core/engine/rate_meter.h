// SPDX-License-Identifier: GPL-3.0-or-later
// Steps and simulated time per second of wall-clock time, over windows of half a second. Times are passed in, as for
// Pacer.
#pragma once

#include "core/engine/pacer.h"

namespace inspector {

class RateMeter {
public:
    /// A new run begins: no rate is known yet.
    void start(Clock::time_point now);
    /// One step of dt seconds was made.
    void count(Clock::time_point now, double dt);

    double stepsPerSecond() const { return m_stepsPerSecond; }
    double speed() const { return m_speed; } ///< simulated seconds per second

private:
    Clock::time_point m_begin{};
    uint64_t m_steps = 0;
    double m_simulated = 0.0;
    double m_stepsPerSecond = 0.0;
    double m_speed = 0.0;
};

} // namespace inspector
