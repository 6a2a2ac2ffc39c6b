// SPDX-License-Identifier: GPL-3.0-or-later
// Speed against accuracy (a work-precision study): what each stepper and step size costs on this machine, and its error
// against stepper "exact", for a scene, its parameters and schedules of tilts.
#pragma once

#include "core/setup/handles.h"
#include "core/setup/numbers.h"
#include "core/trade/uncertainty_band.h"

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace inspector {

struct TradePlan {
    Registry registry;
    Scene scene;
    Inputs inputs; ///< model, coefficients and magnitude of gravity; tilts come from the schedules
    std::vector<TiltSchedule> schedules; ///< a point's errors are those on the worst of them
    std::vector<double> stepSizes;       ///< s
    int repeats = 5;                     ///< timings of each point
    bool withOrientation = false;        ///< with the ball's orientation, as a program that draws it needs

    Unknowns unknowns;         ///< if empty: no band, and no good-enough setting
    double horizon = 1.0;      ///< s, over which such a setting must be good enough; at most the longest schedule
    double askedHorizon = 0.0; ///< s, what was asked for before that
    double share = 0.25;       ///< the error must stay below this share of the band's middle
    int validations = 0;       ///< number of further schedules on which it must hold
};

/// CPU time of the thread, s.
struct TradeCost {
    double perStep = 0.0;
    double perSecond = 0.0; ///< simulated
    double spread = 0.0;    ///< interquartile range of the repeats, share of the median
    int repeats = 0;        ///< 0: not measured yet
};

/// The largest position error up to a time.
struct ErrorRecord {
    double time;  ///< s
    double error; ///< radii
};

/// Against "exact" with the same model, up to the horizon.
struct TradeError {
    double positionLargest = 0.0;             ///< radii
    double positionFinal = 0.0;               ///< radii
    double velocityLargest = 0.0;             ///< m/s; momentarily large when a bounce is early or late
    std::optional<double> orientationLargest; ///< rad; none without orientation
    double energyDrift = 0.0;                 ///< J/kg, gained (> 0) or lost (< 0) by the scheme itself
    double penetrationLargest = 0.0;          ///< radii
    std::optional<double> timeUntilWrong;     ///< s, when the position error first passes kWrong radii
    int wrongImpacts = 0;                     ///< missing, spurious or out of order
    std::optional<double> model;              ///< radii: the rolling model's largest distance from the rigid one
    std::vector<ErrorRecord> growth;          ///< running maximum of the position error
};

inline constexpr double kWrong = 0.1; ///< radii

struct TradePoint {
    QByteArray stepper;
    double dt = 0.0; ///< s
    uint32_t model = PHYS_MODEL_ROLLING;
    bool isValid = false;           ///< has errors, and reached the end
    QString note;                   ///< why it isn't valid, in one line
    uint64_t steps = 0;             ///< for the whole schedule
    std::vector<TradeError> errors; ///< by schedule
    TradeError error;               ///< the worst of them, figure by figure
    std::optional<double> share;    ///< error within the plan's horizon as a share of the uncertainty
    TradeCost cost;
};

/// The time span of the comparison for a model and a schedule, and its references.
struct TradeSpan {
    double compared = 0.0;    ///< s: the predictability horizon, or the end of the reference if that is earlier
    bool isSensitive = false; ///< the horizon came first: beyond it a push of a millionth of a radius is visible
    QString endReason;        ///< why the reference ends before the schedule does; else empty
    double end = 0.0;         ///< s, of the reference
    int impacts = 0;          ///< counted impacts up to the end
    int early = 0;            ///< of these, those within the plan's horizon
    double knowable;          ///< until then rounding moves the ball by less than a radius; at most `end`
    Band band;                ///< for the plan's model only
};

/// A setting that is good enough on the plan's schedules, but not on one that was tried besides.
struct PassedOver {
    size_t point;                ///< index of the point
    std::optional<double> share; ///< there; empty: its run fails
};

/// The cheapest setting whose error stays below the plan's share of the uncertainty on every schedule that was tried.
struct GoodEnough {
    size_t point;                       ///< index of the point
    double largest;                     ///< worst share
    int validations;                    ///< schedules tried besides the plan's
    std::vector<PassedOver> passedOver; ///< cheaper ones, cheapest first
};

struct TradeResult {
    std::vector<std::array<TradeSpan, 2>> spans; ///< by schedule and model
    std::vector<TradePoint> points;              ///< by stepper, from long to short steps; the rolling model first
    std::optional<GoodEnough> goodEnough;        ///< for the plan's model
    bool isComplete = false;                     ///< wasn't cancelled

    /// s, up to which all schedules are compared.
    double compared(uint32_t model) const;

    /// The points of one model that can be chosen.
    std::vector<TradePoint> valid(uint32_t model) const;
};

/// Callbacks, on the measuring thread. Each may be empty.
struct TradeListener {
    std::function<void(const TradeResult &)> began;                 ///< with spans, and points without figures
    std::function<void(size_t index, const TradePoint &)> measured; ///< called after each repeat
    std::function<void(double share, const QString &what)> progressed;
};

/// Takes seconds. Stops soon after a stop is requested. Returns no result, with one line in `error`, if "exact" refuses
/// the scene, as there is no reference then.
std::optional<TradeResult> measureTrade(const TradePlan &plan, const TradeListener &listener,
                                        const std::stop_token &stop, QString *error);

/// Counts impacts of either sequence that aren't in the other in the same order. Fast impacts are matched with impacts
/// of at least half the speed, so that rounding near the threshold doesn't matter.
int wrongImpacts(const std::vector<Impact> &expected, const std::vector<Impact> &found);

/// The worst of several errors, figure by figure; at least one.
TradeError worstOf(const std::vector<TradeError> &errors);

} // namespace inspector
