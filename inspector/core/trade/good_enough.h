// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which setting is good enough, given what is unknown about the board.
#pragma once

#include "core/trade/trade.h"
#include "core/trade/trade_run.h"

namespace inspector {

/// Further schedules on which a setting must be good enough. On only a few schedules it may succeed by luck, because
/// hundredths of a radius decide whether a stepper hits an edge that the exact ball clears. Made on first use.
class ValidationSchedules {
public:
    /// Both must outlive this object.
    ValidationSchedules(const TradePlan &plan, const std::stop_token &stop);

    int count() const { return m_plan.validations; }
    /// The error of a setting up to the plan's horizon, as a share of the middle of the uncertainty band there. Nothing
    /// if its run fails; 0 where "exact" fails on the schedule, which isn't the setting's fault.
    std::optional<double> shareOf(const TradePoint &point, int validation);

private:
    struct Validation {
        std::optional<TradeReference> reference;
        double band = 0.0; ///< radii
    };
    const Validation &prepared(int validation);

    const TradePlan &m_plan;
    const std::stop_token &m_stop;
    std::vector<Validation> m_validations;
};

/// A setting's error up to the plan's horizon as a share of the uncertainty, on the worst of the plan's schedules.
double shareOnSchedules(const TradePlan &plan, const TradeResult &result, const TradePoint &point);

/// Among valid points of the plan's model. Nothing if there is none.
std::optional<GoodEnough> cheapestGoodEnough(const TradePlan &plan, const TradeResult &result,
                                             ValidationSchedules &validations);

/// The error of one setting against a reference up to a time, radii; nothing if its run fails.
std::optional<double> errorOfSetting(const TradePlan &plan, const TradePoint &point, const TradeReference &reference,
                                     double until, const std::stop_token &stop);

} // namespace inspector
