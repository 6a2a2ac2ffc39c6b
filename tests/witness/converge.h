// SPDX-License-Identifier: MIT
// Whether a stepper converges to the motion that the law determines, at its order.
#pragma once

#include "case.h"
#include "integrator/brute_force.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace witness {

constexpr int kSizes = 3;
constexpr int kCheckpoints = 4;

/// Whether a ball at `centre` may come to a gap exactly as wide as itself without being in it: rounding decides what
/// happens at its mouth.
bool hasUndecidedGap(const Case &scene, const phys_vec3 &centre);

/// The motion by brute force, and how far it deviates if it is disturbed a little.
class Truth {
public:
    /// Empty if the ball starts inside a box, or if there is no answer: a gap of exactly its diameter, or a failure of
    /// the brute force.
    static std::optional<Truth> of(const Case &scene);

    const std::vector<Motion> &motions() const { return m_motions; }
    /// With a hundred times smaller tolerances, for steppers more accurate than the usual ones. Computed on first
    /// request.
    const Truth &refined() const;
    bool hasEvents() const { return m_hasEvents; }
    /// How far each checkpoint moves if gravity and speed are off by the share `disturbance`, or the start by `shift`
    /// metres, in a number of ways. Computed once, as steppers of one order ask for the same.
    const std::vector<Real> &spread(Real disturbance, Real shift) const;
    /// The uncertainty of the brute force itself.
    Real ownError() const { return m_ownError; }
    Real fastest() const { return m_fastest; }

private:
    explicit Truth(const Case &scene)
        : m_scene(scene) {}
    std::vector<Motion> run(const Law &law, Motion motion, Real tolerance) const;
    std::vector<Real> disturb(Real disturbance, Real shift) const;

    Case m_scene;
    mutable std::shared_ptr<Truth> m_refined;
    mutable std::map<std::pair<Real, Real>, std::vector<Real>> m_spreads;
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
