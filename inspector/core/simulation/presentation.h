// SPDX-License-Identifier: GPL-3.0-or-later
// What the window's thread sees of the run that is shown: pace, samples, events, ghost and snapshots.
#pragma once

#include "core/engine/rate_meter.h"
#include "core/simulation/run.h"
#include "core/simulation/simulation.h"

#include <optional>
#include <vector>

namespace inspector {

/// Used by the stepping thread only.
class Presentation {
public:
    Presentation(Simulation &owner, SampleRing &samples, EventLog &events, LatestValue<Snapshot> &snapshots);

    void show(const Run &run) { m_run = &run; } ///< must be called first
    Simulation &owner() { return m_owner; }     ///< for its signals
    SampleRing &samples() { return m_samples; }
    EventLog &events() { return m_events; }

    // ---- pace ----

    bool isRunning() const { return m_isRunning; }
    void setRunning(bool isRunning);
    void setSpeed(double speed);
    /// Restarts rates and deadlines; keeps the lost time of this run.
    void startPacing();
    void followDt(); ///< restarts pacing if the run's dt has changed
    bool isDue() { return m_isRunning && m_pacer.isDue(Clock::now()); }
    Clock::time_point deadline() const { return m_pacer.deadline(); }
    void advance() { m_pacer.advance(); }

    // ---- ghost ----

    void compare(uint64_t number, const GhostSetup &setup, const QByteArray &leaderId);
    GhostEngine *ghost() { return m_ghost ? &*m_ghost : nullptr; }
    void setGhostInputs(uint64_t number, const std::optional<Inputs> &own); ///< of the ghost, if there is one
    void endComparison() { m_ghost.reset(); }
    /// Whether a ghost of a run that is repeated begins at this state of the ball: in the live run where the present
    /// one met it, unless that one has got other inputs since; in another run at its beginning.
    bool ghostBeginsAt(const phys_state &ball, bool isLive) const;
    /// A ghost like the present one that begins with this ball; nothing if there is none in its scene.
    std::optional<GhostEngine> ghostOf(const Engine &ball, const QByteArray &leaderId) const;
    void addGhost(const GhostEngine &ghost, Sample &sample) const;
    void meetGhost(); ///< restarts the ghost at the ball's state; a ghost of another scene is removed

    // ---- measured ball ----

    /// track: or nullptr. scenes: of the maze that it was measured in; in others it isn't sampled.
    void setTrack(std::shared_ptr<const ShownTrack> track, std::vector<Scene> scenes) {
        m_track = std::move(track);
        m_trackScenes = std::move(scenes);
    }

    // ---- samples and events ----

    /// Called when the state was set from outside: samples and events start over.
    void beginRun();
    void countStep();
    /// The sample of the run's last step, with the measured ball.
    Sample sample() const;
    /// Records sample and events after a step. stepTime: duration of the step, us, or NaN.
    void noteStep(double stepTime);
    void noteEvents();
    /// Between hold() and release() readers keep seeing the old content.
    void hold();
    void release(); ///< if held
    void clear();
    void publish(Clock::time_point due);

private:
    void leadGhost();

    Simulation &m_owner;
    SampleRing &m_samples;
    EventLog &m_events;
    LatestValue<Snapshot> &m_snapshots;
    const Run *m_run = nullptr;
    Pacer m_pacer{};
    RateMeter m_meter{};
    double m_speed = 1.0;
    double m_pacedDt = 0.0; ///< s
    bool m_isRunning = false;
    bool m_isHeld = false;
    uint64_t m_runCount = 0;
    uint64_t m_published = 0;
    std::optional<GhostEngine> m_ghost{};
    uint64_t m_ghostNumber = 0;
    uint64_t m_meetings = 0;     ///< of a ghost with the ball
    bool m_isGhostAsMet = false; ///< its inputs haven't been changed since it met the ball
    std::shared_ptr<const ShownTrack> m_track{};
    std::vector<Scene> m_trackScenes{};
};

} // namespace inspector
