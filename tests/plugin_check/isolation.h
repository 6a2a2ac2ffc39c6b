// SPDX-License-Identifier: MIT
// Runs a part of the card in a process of its own, so that a crash or an endless loop becomes one line.
#pragma once

#include "measures.h"

#include <chrono>
#include <functional>

namespace plugin_check {

/// The parts of one card, which together get a minute.
class Isolation {
public:
    explicit Isolation(int seconds = 55)
        : m_seconds(seconds) {}

    /// The result of the work; or that it crashes, takes more seconds, or prints. Open if the card's time is over.
    Measure run(const std::function<Measure()> &work, int seconds = 25) const;

private:
    int m_seconds;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace plugin_check
