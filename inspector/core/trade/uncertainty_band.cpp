// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/uncertainty_band.h"

#include "core/trade/ball_ensemble.h"
#include "core/trade/quantile.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kLow = 0.05;
constexpr double kHigh = 0.95;

/// The larger of the two distances of each ball; NaN is kept.
void keepFarthest(std::vector<double> &farthest, const std::vector<double> &distances) {
    for (size_t i = 0; i < farthest.size(); ++i)
        farthest[i] = std::isnan(distances[i]) ? distances[i] : std::max(farthest[i], distances[i]);
}

} // namespace

void appendQuantiles(Band &band, double time, std::vector<double> distances, double radius) {
    std::erase_if(distances, [](double distance) { return std::isnan(distance); });
    if (distances.empty()) return;
    std::sort(distances.begin(), distances.end());
    band.times.push_back(time);
    band.low.push_back(quantile(distances, kLow) / radius);
    band.middle.push_back(quantile(distances, 0.5) / radius);
    band.high.push_back(quantile(distances, kHigh) / radius);
}

double Band::middleAt(double time) const {
    if (times.empty()) return 0.0;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.end()) return middle.back();
    if (after == times.begin()) return middle.front();
    const auto i = size_t(after - times.begin());
    const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return middle[i - 1] + share * (middle[i] - middle[i - 1]);
}

std::optional<double> Band::timeUntil(double radii) const {
    const auto reached = std::find_if(middle.begin(), middle.end(), [&](double value) { return value >= radii; });
    if (reached == middle.end()) return std::nullopt;
    return times[size_t(reached - middle.begin())];
}

Band uncertaintyBand(const BandPlan &plan, const TradeReference &reference, const std::stop_token &stop) {
    Band band;
    const Stepper stepper = makeStepper(plan.registry, "exact", plan.scene, nullptr);
    if (!stepper || plan.unknowns.empty() || plan.balls < 1) return band;
    const double radius = phys_scene_radius(plan.scene.get());
    phys_state start;
    phys_scene_start(plan.scene.get(), &start);
    BallEnsemble balls(stepper, plan.scene, sampleBoards(plan.unknowns, plan.inputs, plan.balls, kBandSeed), start);
    std::vector<double> farthest = balls.distancesFrom(start.position);
    appendQuantiles(band, 0.0, farthest, radius);
    for (size_t i = 0; i < reference.legs().size() && !stop.stop_requested(); ++i) {
        const Leg &leg = reference.legs()[i];
        balls.step(reference.segments()[leg.segment].tilt, leg.dt, leg.steps);
        keepFarthest(farthest, balls.distancesFrom(reference.states()[i + 1].position));
        appendQuantiles(band, leg.end, farthest, radius);
        if (leg.end >= plan.until) break;
    }
    band.refused = balls.refused();
    band.balls = plan.balls - band.refused;
    return band;
}

} // namespace inspector
