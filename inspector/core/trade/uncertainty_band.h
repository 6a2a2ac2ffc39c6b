// SPDX-License-Identifier: GPL-3.0-or-later
// How far the real ball can be from the computed one because the board isn't known exactly: a Monte Carlo ensemble of
// boards is sampled, and each is stepped by "exact" under the same tilts.
#pragma once

#include "core/schedule/trade_reference.h"
#include "core/trade/unknowns.h"

namespace inspector {

/// Distances from the computed ball over time: nine in ten balls lie between low and high, half of them below middle.
struct Band {
    std::vector<double> times; ///< s, from 0
    std::vector<double> low;   ///< radii
    std::vector<double> middle;
    std::vector<double> high;
    int balls = 0;   ///< in the ensemble
    int refused = 0; ///< boards that "exact" refused before the end

    bool isEmpty() const { return times.empty(); }
    /// Linear between the times, constant after the last one. 0 if it is empty.
    double middleAt(double time) const;
    /// When the middle first reaches this distance, s; nothing if it doesn't.
    std::optional<double> timeUntil(double radii) const;
};

struct BandPlan {
    const Registry &registry;
    const Scene &scene;
    Inputs inputs; ///< model, coefficients and magnitude of gravity, as in the reference
    Unknowns unknowns;
    int balls = 100;
    double until; ///< s
};

inline constexpr uint64_t kBandSeed = 1;

/// distances: m; NaN are ignored, and if all are NaN the band is unchanged.
void appendQuantiles(Band &band, double time, std::vector<double> distances, double radius);

/// The band of the running maxima of the distances, comparable to the errors of settings. Empty if nothing is unknown
/// or "exact" refuses the boards.
Band uncertaintyBand(const BandPlan &plan, const TradeReference &reference, const std::stop_token &stop);

} // namespace inspector
