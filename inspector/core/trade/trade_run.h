// SPDX-License-Identifier: GPL-3.0-or-later
// One stepper along one schedule: once to see what it is wrong by, several times to see what it costs.
#pragma once

#include "core/trade/trade.h"
#include "core/trade/trade_reference.h"

namespace inspector {

struct TradeRun {
    const Registry &registry;
    const Scene &scene;
    QByteArray stepper;
    phys_params params;
};

// What a run is compared with, and how far.
struct ReferenceMotion {
    const std::vector<Segment> &segments;
    const std::vector<Leg> &legs;
    const std::vector<phys_state> &states; // of the reference at their ends
    const std::vector<Impact> &impacts;    // of the reference
    double until;                          // s
};

// One line in `note` if the run ended before that.
TradeError compareRun(const TradeRun &run, const ReferenceMotion &motion, const std::stop_token &stop, QString *note);

// CPU time of this thread for the whole schedule, s, with no report asked for. Nothing if a step failed.
std::optional<double> timeRun(const TradeRun &run, const std::vector<Segment> &segments, const std::vector<Leg> &legs,
                              const std::stop_token &stop);

} // namespace inspector
