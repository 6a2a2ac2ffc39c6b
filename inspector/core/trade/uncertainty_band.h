// SPDX-License-Identifier: GPL-3.0-or-later
// How far a ball can be from the computed one because the board isn't known exactly: many boards are drawn, and each is
// stepped by "exact" under the same tilts.
#pragma once

#include "core/schedule/trade_reference.h"
#include "core/trade/unknowns.h"

namespace inspector {

// Distances from the computed ball over time: nine balls in ten lie between low and high, half of them below middle.
struct Band {
    std::vector<double> times; // s, from 0
    std::vector<double> low;   // radii
    std::vector<double> middle;
    std::vector<double> high;
    int balls = 0;   // that it is made of
    int refused = 0; // draws that "exact" couldn't do to the end

    bool isEmpty() const { return times.empty(); }
    // Between the given times linearly, after the last one as there. 0 if it is empty.
    double middleAt(double time) const;
    // When the middle first reaches a length, s; nothing if it doesn't.
    std::optional<double> timeUntil(double radii) const;
};

struct BandPlan {
    const Registry &registry;
    const Scene &scene;
    Inputs inputs; // model, coefficients and strength of gravity, as the reference has them
    Unknowns unknowns;
    int balls = 100;
    double until; // s
};

inline constexpr uint64_t kBandSeed = 1;

// distances: m; those that are NaN don't count, and without any other the band stays as it is.
void appendQuantiles(Band &band, double time, std::vector<double> distances, double radius);

// Of the largest distances up to each time, as errors of settings are the largest up to it. Empty if nothing
// is unknown or "exact" can't step the draws.
Band uncertaintyBand(const BandPlan &plan, const TradeReference &reference, const std::stop_token &stop);

} // namespace inspector
