// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/rate_meter.h"

namespace inspector {

namespace {
constexpr std::chrono::duration<double> kRatePeriod{0.5};
}

void RateMeter::start(Clock::time_point now) {
    *this = {};
    m_begin = now;
}

void RateMeter::count(Clock::time_point now, double dt) {
    ++m_steps;
    m_simulated += dt;
    const std::chrono::duration<double> passed = now - m_begin;
    if (passed < kRatePeriod) return;
    m_stepsPerSecond = double(m_steps) / passed.count();
    m_speed = m_simulated / passed.count();
    m_begin = now;
    m_steps = 0;
    m_simulated = 0.0;
}

} // namespace inspector
