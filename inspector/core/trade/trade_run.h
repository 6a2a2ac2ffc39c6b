// SPDX-License-Identifier: GPL-3.0-or-later
// One stepper along one schedule: once to see what it is wrong by, several times to see what it costs.
#pragma once

#include "core/schedule/trade_reference.h"
#include "core/trade/trade.h"

namespace inspector {

struct TradeRun {
    const Registry &registry;
    const Scene &scene;
    QByteArray stepper;
    phys_params params;
};

// The plan's parameters, of this model.
phys_params paramsFor(const TradePlan &plan, uint32_t model);
// With the initial values of the stepper's own rows. The plan outlives it.
TradeRun runOf(const TradePlan &plan, const TradePoint &point);

// What a run is held against.
struct ReferenceMotion {
    std::vector<TiltSegment> segments;
    std::vector<Leg> legs;
    std::vector<phys_state> states; // of the reference at their ends
    std::vector<Impact> impacts;    // of the reference, up to `until`
    double until;                   // s
};

// Of a run in steps of dt with a reference.
ReferenceMotion motionOf(const TradeReference &reference, double dt, double until);

// One line in `note` if the run ended before that.
TradeError compareRun(const TradeRun &run, const ReferenceMotion &motion, const std::stop_token &stop, QString *note);

// CPU time of this thread for the whole schedule, s, with no report asked for. Nothing if a step failed.
std::optional<double> timeRun(const TradeRun &run, const std::vector<TiltSegment> &segments,
                              const std::vector<Leg> &legs, const std::stop_token &stop);

} // namespace inspector
