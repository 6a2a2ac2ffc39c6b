// SPDX-License-Identifier: GPL-3.0-or-later
// A second ball, stepped after a leading one under the same tilts by another stepper, in finer steps or with other
// parameters: what the leading one is wrong by, if the second is the better, or what a parameter changes. Like the
// engine: no thread, no clock, the same bits in every run.
#pragma once

#include "core/engine/engine.h"

#include <optional>

namespace inspector {

// What a ball is compared with, by name.
struct GhostChoice {
    QByteArray stepper = "exact"; // id
    int substeps = 1;             // of dt / substeps, for each step of the ball; 1 .. kMostSubsteps
    bool operator==(const GhostChoice &) const = default;

    static constexpr int kMostSubsteps = 1000;
};

// The ball's minus the ghost's.
struct Deviation {
    double distance = 0.0; // between the centres, m
    double speed = 0.0;    // m/s
    double energy = 0.0;   // per mass, J/kg
};

// What moves a ghost.
struct GhostSetup {
    Scene scene;     // the leader's
    Stepper stepper; // made for it
    phys_stepper_info info;
    int substeps;
    std::optional<Inputs> own = {}; // its own parameters
};

// Nothing, and one line in `error` (or nullptr), if there is no such stepper or it can't do this scene.
std::optional<GhostSetup> makeGhostSetup(const Registry &registry, const GhostChoice &ghostChoice, const Scene &scene,
                                         QString *error);

class GhostEngine {
public:
    // At the leader's present state. leaderId: of its stepper; where both have the same one the ghost obeys the
    // leader's values of the stepper's own rows, otherwise initial ones.
    GhostEngine(const Engine &leader, const GhostSetup &setup, const QByteArray &leaderId);

    // Its own parameters, all but the tilt, which is the leader's; nothing: the leader's.
    void setOwnInputs(const std::optional<Inputs> &own) { m_own = own; }
    // The leader goes on with this stepper.
    void setLeaderStepper(const QByteArray &id) { m_sharesValues = id == m_info.id; }
    // At the leader's present state, also after a refusal.
    void meet(const Engine &leader);
    // One step of the leader's dt, after the leader's. If the stepper refuses it `error` gets the library's line, and
    // the ghost is gone until the next meeting. Out of the maze it waits where it left.
    bool follow(const Engine &leader, QString *error);

    const Scene &scene() const { return m_engine.scene(); }
    bool isThere() const { return m_isThere; }
    const phys_state &state() const { return m_engine.state(); }
    const phys_state &previous() const { return m_previous; } // before the leader's last step
    const phys_state &met() const { return m_met; }           // the leader's where they met last
    const Deviation &deviation() const { return m_deviation; }
    // Fills in the channels of the comparison, if it is there and was in the maze.
    void addTo(Sample &sample) const;

private:
    Inputs inputsBeside(const Engine &leader) const;

    Engine m_engine;
    phys_stepper_info m_info;
    int m_substeps;
    bool m_sharesValues = false; // of the stepper's own rows
    std::optional<Inputs> m_own;
    bool m_isThere = true;
    phys_state m_previous{};
    phys_state m_met{};
    Deviation m_deviation;
};

// Of states after steps of these engines.
Deviation deviationOf(const Engine &ball, const Engine &other);

} // namespace inspector
