// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/pacer.h"

namespace inspector {

namespace {

using Seconds = std::chrono::duration<double>;

Clock::duration ticks(double seconds) { return std::chrono::round<Clock::duration>(Seconds(seconds)); }

} // namespace

void Pacer::start(Clock::time_point now, double dt, double speed) {
    m_start = now;
    m_steps = 0;
    m_interval = dt / speed;
}

Clock::duration Pacer::interval() const { return ticks(m_interval); }

/// Multiplied, not summed, so that rounding to ticks doesn't accumulate.
Clock::time_point Pacer::deadline() const { return m_start + ticks(double(m_steps + 1) * m_interval); }

bool Pacer::isDue(Clock::time_point now) {
    const Clock::duration late = now - deadline();
    if (late < Clock::duration::zero()) return false;
    if (late <= kBacklogLimit) return true;
    m_lostTime += Seconds(late).count();
    m_start += late;
    return true;
}

} // namespace inspector
