// SPDX-License-Identifier: MIT
// Whether a stepper converges to the motion that the law determines, at its order.
#pragma once

#include "case.h"
#include "integrator/brute_force.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace witness {

constexpr int kSizes = 3;
constexpr int kCheckpoints = 4;
constexpr int kWays = 14; ///< of disturbing a motion

/// Whether a ball at `centre` may come to a gap exactly as wide as itself without being in it: rounding decides what
/// happens at its mouth.
bool hasUndecidedGap(const Case &scene, const phys_vec3 &centre);

/// Whether the ball enters or leaves a throat of three contacts that it exactly fits, on its way between these places.
/// Inside, its centre has a line left, or nothing: as in a gap of its diameter, rounding decides whether it gets there.
bool passesThroat(const Case &scene, const std::vector<phys_vec3> &places);

/// The motion by brute force, and how far it deviates if it is disturbed a little.
class Truth {
public:
    /// Empty if the ball starts inside a box, or if there is no answer: a gap of exactly its diameter in which it
    /// doesn't stay, a throat that it exactly fits and gets into, or a failure of the brute force.
    static std::optional<Truth> of(const Case &scene);

    const std::vector<Motion> &motions() const { return m_motions; }
    /// With a hundred times smaller tolerances, for steppers more accurate than the usual ones. Computed on first
    /// request.
    const Truth &refined() const;
    bool hasEvents() const { return m_hasEvents; }
    /// The motion if gravity or speed is off by the share `disturbance`, or the start by `shift` metres, in one of
    /// kWays; empty if the brute force fails. Computed once, as steppers of one order ask for the same.
    const std::vector<Motion> &disturbed(Real disturbance, Real shift, int way) const;
    /// The motion if one box is smaller by what counts as nothing. Computed once.
    const std::vector<Motion> &withSmaller(size_t box) const;
    /// The uncertainty of the brute force itself.
    Real ownError() const { return m_ownError; }
    Real fastest() const { return m_fastest; }

private:
    explicit Truth(const Case &scene)
        : m_scene(scene) {}
    std::vector<Motion> run(const Law &law, Motion motion, Real tolerance) const;
    std::vector<Motion> run(const std::vector<phys_box> &boxes, const Law &law, Motion motion, Real tolerance) const;
    std::vector<Motion> disturb(Real disturbance, Real shift, int way) const;

    Case m_scene;
    mutable std::shared_ptr<Truth> m_refined;
    using Disturbed = std::map<std::tuple<Real, Real, int>, std::vector<Motion>>;
    using WithSmaller = std::map<size_t, std::vector<Motion>>;
    std::shared_ptr<Disturbed> m_disturbed = std::make_shared<Disturbed>();       ///< shared with the refined one
    std::shared_ptr<WithSmaller> m_withSmaller = std::make_shared<WithSmaller>(); ///< likewise
    std::vector<Motion> m_motions; ///< at the checkpoints, each a quarter of the time
    bool m_hasEvents = false;
    Real m_ownError = 0;
    Real m_fastest = 0;
};

struct Convergence {
    double stepSizes[kSizes];
    Real errors[kSizes]; ///< of the place at the worst checkpoint, m
    phys_status status = PHYS_OK;
    std::string statusText;
    bool isWrong = false;
    std::string what;
};

Convergence converge(const phys_registry *registry, const std::string &stepper, const Case &scene, const Truth &truth);

} // namespace witness
