// SPDX-License-Identifier: GPL-3.0-or-later
// Speed against accuracy, measured: what each stepper and step size costs on this machine, and what it is wrong by
// against stepper "exact", for a scene, its parameters and a schedule of tilts.
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
    Inputs inputs;                       // model, coefficients and strength of gravity; the tilt is the schedules'
    std::vector<TiltSchedule> schedules; // a point's errors are the worst of them
    std::vector<double> stepSizes;       // s
    int repeats = 5;                     // of the timing of each point
    bool withOrientation = false;        // steppers turn the ball, too, as a program that draws it lets them

    Unknowns unknowns;    // none: no band, and no setting is good enough for what is known
    double horizon = 1.0; // s that such a setting looks ahead
    double share = 0.25;  // of the band's middle, that its error stays below
    int validations = 0;  // further schedules on which it has to
};

// CPU time of the thread, s.
struct TradeCost {
    double perStep = 0.0;
    double perSecond = 0.0; // simulated
    double spread = 0.0;    // between the quartiles of the repeats, share of the median
    int repeats = 0;        // 0: not measured yet
};

// The largest position error up to a time.
struct ErrorRecord {
    double time;  // s
    double error; // radii
};

// Against "exact" with the same model, up to the horizon.
struct TradeError {
    double positionLargest = 0.0;         // radii
    double positionFinal = 0.0;           // radii
    double velocityLargest = 0.0;         // m/s; large for a moment when a bounce comes early or late
    double orientationLargest = 0.0;      // rad; 0 without orientation
    double energyDrift = 0.0;             // J/kg, made (> 0) or lost (< 0) by the scheme itself
    double penetrationLargest = 0.0;      // radii
    std::optional<double> timeUntilWrong; // s, when the position error first passes kWrong radii
    int wrongImpacts = 0;                 // missing or invented, or out of order
    std::optional<double> model;          // radii: the rolling model's largest distance from the rigid one
    std::vector<ErrorRecord> growth;      // of positionLargest, each larger than the one before
};

inline constexpr double kWrong = 0.1; // radii

struct TradePoint {
    QByteArray stepper;
    double dt = 0.0; // s
    uint32_t model = PHYS_MODEL_ROLLING;
    bool isValid = false;           // has errors, and got to the end
    QString note;                   // why not, in a line
    uint64_t steps = 0;             // of the whole schedule
    std::vector<TradeError> errors; // by schedule
    TradeError error;               // each figure the worst of them
    std::optional<double> share;    // of what isn't known, that the error is within the plan's horizon
    TradeCost cost;
};

// How far the comparison goes for a model and a schedule, and what there is to compare with.
struct TradeSpan {
    double compared = 0.0;    // s: the horizon, or the end of the reference if that is sooner
    bool isSensitive = false; // the horizon came first: from there on a push of a millionth of a radius shows
    QString endReason;        // why the reference ends before the schedule; empty if it doesn't
    double end = 0.0;         // s, of the reference
    int impacts = 0;          // counted ones up to the end
    int early = 0;            // of these, those within the plan's horizon
    double knowable; // s: until then the rounding of numbers moves the ball by less than a radius; at most the end
    Band band;       // of the plan's model only
};

// The cheapest setting whose error stays below the plan's share of what isn't known, on every schedule that was looked
// at.
struct GoodEnough {
    size_t point;    // its index
    double largest;  // of these shares
    int validations; // schedules that it was seen on besides the plan's
};

struct TradeResult {
    std::vector<std::array<TradeSpan, 2>> spans; // by schedule and model
    std::vector<TradePoint> points;       // stepper by stepper, from long to short steps; the rolling model's first
    std::optional<GoodEnough> goodEnough; // of the plan's model
    bool isComplete = false;              // not cancelled

    // s: as far as all schedules are compared.
    double compared(uint32_t model) const;

    // Of one model, those that a person can choose from.
    std::vector<TradePoint> valid(uint32_t model) const;
};

// Called by the thread that measures. Any may be empty.
struct TradeListener {
    std::function<void(const TradeResult &)> began;                 // spans and points without figures
    std::function<void(size_t index, const TradePoint &)> measured; // again after each repeat
    std::function<void(double share, const QString &what)> progressed;
};

// Takes seconds. Stops soon after it is asked to. No result and one line in `error` if "exact" can't do the scene:
// then there is nothing to compare with.
std::optional<TradeResult> measureTrade(const TradePlan &plan, const TradeListener &listener,
                                        const std::stop_token &stop, QString *error);

// Impacts of one sequence that the other hasn't in the same order, both ways. Fast ones have to be found among the
// other's impacts of at least half the speed, so that one near the limit isn't wrong by a rounding.
int wrongImpacts(const std::vector<Impact> &expected, const std::vector<Impact> &found);

// Each figure the worst of several; at least one.
TradeError worstOf(const std::vector<TradeError> &errors);

} // namespace inspector
