// SPDX-License-Identifier: MIT
#include "split.h"

#include <algorithm>
#include <utility>

namespace witness {

namespace {

constexpr double kDisturbance = 1e-12;
constexpr double kChaos = 1e-3; // share of the radius: a larger effect of the disturbance means that rounding decides

/// The ball's position after all parts. places: gets the position after each of them.
std::optional<Vector> endOf(phys_stepper *stepper, const phys_params &params, const std::vector<double> &parts,
                            phys_state state, std::vector<phys_vec3> &places) {
    for (const double dt : parts) {
        if (phys_step(stepper, &params, dt, &state, &state, nullptr, nullptr)) return std::nullopt;
        places.push_back(state.position);
    }
    return vectorOf(state.position);
}

/// The start with a disturbance in each coordinate or velocity, in both directions.
std::vector<phys_state> disturbed(const phys_state &in, double radius) {
    std::vector<phys_state> states;
    for (const double off : {-kDisturbance, kDisturbance}) {
        for (double phys_vec3::*axis : {&phys_vec3::x, &phys_vec3::y, &phys_vec3::z}) {
            states.push_back(in);
            states.back().position.*axis += off * radius;
        }
        phys_state other = in;
        other.velocity = rounded(Real(1 + off) * vectorOf(in.velocity));
        other.spin = rounded(Real(1 - off) * vectorOf(in.spin));
        states.push_back(other);
    }
    return states;
}

} // namespace

std::optional<SplitDifference> splitDifference(phys_stepper *stepper, const phys_params &params, double dt,
                                               const phys_state &in, double radius) {
    const std::vector<double> whole = {dt};
    const std::vector<double> parts = {0.375 * dt, 0.25 * dt, 0.375 * dt};
    std::vector<phys_vec3> places = {in.position}, unused;
    const std::optional<Vector> once = endOf(stepper, params, whole, in, places);
    const std::optional<Vector> inParts = endOf(stepper, params, parts, in, places);
    if (!once || !inParts) return std::nullopt;
    SplitDifference difference{double(length(*once - *inParts)), 0.0, std::move(places)};
    if (difference.apart <= kDisturbance * radius) return difference;
    for (const phys_state &start : disturbed(in, radius)) {
        const std::optional<Vector> onceMoved = endOf(stepper, params, whole, start, unused);
        const std::optional<Vector> inPartsMoved = endOf(stepper, params, parts, start, unused);
        if (!onceMoved || !inPartsMoved) return std::nullopt;
        difference.spread =
            std::max({difference.spread, double(length(*onceMoved - *once)), double(length(*inPartsMoved - *inParts))});
    }
    if (difference.spread > kChaos * radius) return std::nullopt;
    return difference;
}

} // namespace witness
