// SPDX-License-Identifier: GPL-3.0-or-later
// A second ball (the ghost) that follows a leading one under the same tilts, with another stepper, finer steps or other
// parameters. It shows the leader's error if its own method is the better one, or the effect of a parameter. Like
// Engine it has no thread and no clock, and every run gives the same bits.
#pragma once

#include "core/engine/engine.h"

#include <optional>

namespace inspector {

/// Stepper and step size of the ghost.
struct GhostChoice {
    QByteArray stepper = "exact"; ///< id
    int substeps = 1;             ///< steps of dt / substeps for each step of the ball; 1 .. kMostSubsteps
    bool operator==(const GhostChoice &) const = default;

    static constexpr int kMostSubsteps = 1000;
};

/// The ball's values minus the ghost's.
struct Deviation {
    double distance = 0.0; ///< between the centres, m
    double speed = 0.0;    ///< m/s
    double energy = 0.0;   ///< per mass, J/kg
};

/// What a ghost is stepped with.
struct GhostSetup {
    Scene scene;     ///< the leader's
    Stepper stepper; ///< made for that scene
    phys_stepper_info info;
    int substeps;
    std::optional<Inputs> own = {}; ///< its own parameters
};

/// Returns nothing, with one line in `error` (may be nullptr), if there is no such stepper or it doesn't support this
/// scene.
std::optional<GhostSetup> makeGhostSetup(const Registry &registry, const GhostChoice &ghostChoice, const Scene &scene,
                                         QString *error);

class GhostEngine {
public:
    /// Starts at the leader's current state. leaderId: the leader's stepper. If both use the same one, the ghost takes
    /// over the leader's values of the stepper's own rows; otherwise those have their initial values.
    GhostEngine(const Engine &leader, const GhostSetup &setup, const QByteArray &leaderId);

    /// The ghost's own parameters; empty: the leader's. The tilt is always the leader's.
    void setOwnInputs(const std::optional<Inputs> &own) { m_setup.own = own; }
    /// Called when the leader has changed its stepper.
    void setLeaderStepper(const QByteArray &id) { m_sharesValues = id == m_setup.info.id; }
    /// Returns to the leader's current state, also after a refusal.
    void meet(const Engine &leader);
    /// Makes one step of the leader's dt; call it after the leader's step. If the stepper fails, `error` gets the
    /// library's message and there is no ghost until the next meet(). A ball outside of the maze stays where it left
    /// it.
    bool follow(const Engine &leader, QString *error);

    const GhostSetup &setup() const { return m_setup; }
    const Scene &scene() const { return m_engine.scene(); }
    bool isThere() const { return m_isThere; }
    const phys_state &state() const { return m_engine.state(); }
    const phys_state &previous() const { return m_previous; } ///< before the leader's last step
    const phys_state &met() const { return m_met; }           ///< the common state at the last meet()
    const Deviation &deviation() const { return m_deviation; }
    /// Fills in the channels of the comparison if the ghost exists and is in the maze.
    void addTo(Sample &sample) const;

private:
    Inputs inputsBeside(const Engine &leader) const;

    Engine m_engine;
    GhostSetup m_setup;
    bool m_sharesValues = false; ///< of the stepper's own rows
    bool m_isThere = true;
    phys_state m_previous{};
    phys_state m_met{};
    Deviation m_deviation;
};

/// Between the current states of two engines.
Deviation deviationOf(const Engine &ball, const Engine &other);

} // namespace inspector
