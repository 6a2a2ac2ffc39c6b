// SPDX-License-Identifier: MIT
// A part of the card in a process of its own, so that a crash or an endless loop is one line.
#pragma once

#include "measures.h"

#include <chrono>
#include <functional>

namespace plugin_check {

/// The parts of one card, which together get a minute.
class Isolation {
public:
    /// What the work says; that it crashes, isn't done in time, or prints, if it does.
    Measure run(const std::function<Measure()> &work) const;

private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace plugin_check
