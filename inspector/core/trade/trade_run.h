// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one stepper along one schedule: once for its errors, several times for its cost.
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

/// The plan's parameters, with this model.
phys_params paramsFor(const TradePlan &plan, uint32_t model);
/// Uses the initial values of the stepper's own rows. The plan must outlive the result.
TradeRun runOf(const TradePlan &plan, const TradePoint &point);

/// What a run is compared with.
struct ReferenceMotion {
    std::vector<TiltSegment> segments;
    std::vector<Leg> legs;
    std::vector<phys_state> states; ///< reference states at their ends
    std::vector<Impact> impacts;    ///< the reference's impacts, up to `until`
    double until;                   ///< s
};

/// The reference for a run in steps of dt.
ReferenceMotion motionOf(const TradeReference &reference, double dt, double until);

/// Sets one line in `note` if the run ended early.
TradeError compareRun(const TradeRun &run, const ReferenceMotion &motion, const std::stop_token &stop, QString *note);

/// CPU time of this thread for the whole schedule, s, without reports. Nothing if a step failed.
std::optional<double> timeRun(const TradeRun &run, const std::vector<TiltSegment> &segments,
                              const std::vector<Leg> &legs, const std::stop_token &stop);

} // namespace inspector
