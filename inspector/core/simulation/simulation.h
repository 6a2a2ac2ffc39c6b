// SPDX-License-Identifier: GPL-3.0-or-later
// An Engine on a thread of its own, at a fixed dt. Nobody waits for anybody: inputs go in through a latest-wins
// mailbox, states come out through a latest-value slot, samples through a ring; commands are taken between two steps.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/ghost_engine.h"
#include "core/events/event_log.h"
#include "core/recording/history.h"
#include "core/recording/player.h"
#include "core/recording/recorder.h"
#include "core/simulation/latest_value.h"
#include "core/simulation/sample_ring.h"
#include "core/simulation/snapshot.h"
#include "core/track/shown_track.h"

#include <QObject>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace inspector {

// Inputs come through a mailbox and with commands: the number tells which were given last.
struct GivenInputs {
    Inputs inputs;
    uint64_t number = 0;
};

class Simulation : public QObject {
    Q_OBJECT

public:
    static constexpr double kSlowest = 1.0 / 16.0; // simulated seconds per second
    static constexpr double kFastest = 16.0;

    // Paused at the scene's start. origin: for the events' stepper, and the recorder's.
    Simulation(const Scene &scene, const Stepper &stepper, const Origin &origin = {}, QObject *parent = nullptr);
    ~Simulation() override; // ends the thread

    // Commands, from the thread that owns this object; they return at once and take effect before the next step.
    void run();
    void pause();
    void pauseAt(double time); // s: when the ball has reached it, in whole steps; the live ball only
    void stepOnce();           // pauses, too
    void restart();            // at the scene's start; goes on running or stays paused
    // Pauses at its start. origin: as above.
    void setScene(const Scene &scene, const Stepper &stepper, const Origin &origin = {});
    // Goes on from the same state; made for the same scene. With its inputs, because a stepper's own values fit no
    // other. origin: for the recorder and the ghost, if there are any.
    void setStepper(const Stepper &stepper, const Inputs &inputs, const Origin &origin = {});
    void setState(const phys_state &state);
    void setStart(const std::optional<phys_state> &start); // of restarts; nothing: the scene's
    void setDt(double dt);                                 // s, > 0
    void setSpeed(double speed); // clamped to kSlowest .. kFastest; changes how many steps run, never dt
    // Its places go into samples from the next step on, beside the ball's; or nullptr.
    void setTrack(std::shared_ptr<const ShownTrack> track);
    void setPilot(std::shared_ptr<const Pilot> pilot); // or nullptr: the tilt of the inputs counts
    // Notes every step from now on, in the place of a recording before, until one can't be written.
    void startRecording(const QString &file, const Origin &origin);
    void stopRecording();

    // A ghost meets the ball and follows it from now on, in the place of one before. At a restart and when a state
    // is set they meet again; with another scene it is gone. leaderId: of the present stepper. Returns the ghost's
    // number, as in its refusals.
    uint64_t compareWith(const GhostSetup &setup, const QByteArray &leaderId);
    // From the next step on; nothing: the ball's.
    void setGhostInputs(const std::optional<Inputs> &own);
    void endComparison();

    // Shows a recording, which has steps, at its beginning and paused; the live ball waits. Returns the replay's
    // number, as in its snapshots. run(), pause(), stepOnce(), restart() and setSpeed() then act on the replay.
    uint64_t startReplay(std::shared_ptr<const PlayableRecording> recording);
    // Shows this position as soon as all before it is checked; goes on running or stays paused. Returns the seek's
    // number: the snapshot says how many are done.
    uint64_t seek(uint64_t position);
    void stepBack();  // pauses, too
    void endReplay(); // the live ball again, paused
    // The live ball goes on from this position of the replay, under its conditions; goes on running or stays paused.
    void goOnFrom(uint64_t position, const Origin &origin);

    // What is kept of [from, to), or all of it; nothing and one line in `error` if it can't be run again. Waits until
    // the step at hand is made.
    std::optional<Past> past(QString *error, uint64_t from = 0, uint64_t to = UINT64_MAX);
    // Shows the past of the live ball, which waits, paused at its end; like a replay, but samples and events stay those
    // of the run shown, all of it. Returns its number.
    uint64_t lookBack(const Past &past);
    // The live ball again, paused, as if nothing had been.
    void returnToPresent();

    // Latest wins: from the next step on.
    void setInputs(const Inputs &inputs);

    // The newest snapshot. What belongs together is to be taken from one. The owner's thread only.
    Snapshot latest();
    // All samples of this run. Any thread.
    const SampleRing &samples() const { return m_samples; }
    // What happened in this run. Any thread.
    const EventLog &events() const { return m_events; }

signals: // queued: sent by the thread that steps, and received in the order in which it all happened
    // A step failed; the simulation is paused, the state is the one before it. `line` is the library's.
    void failed(const QString &line);
    // A restart, another scene, a state that was set: what was wrong before is over.
    void runBegan();
    // The ball has left the maze at `time` (s since the start). It goes on falling for a while, then a pause.
    void leftMaze(double time);
    void runningChanged(bool running);
    // The recording can't be written and ends; the simulation goes on.
    void recordingFailed(const QString &line);
    // The ghost's stepper refused a step; there is no ghost until the next meeting. The simulation goes on.
    void comparisonRefused(uint64_t ghost, const QString &line);
    // The first step of this replay that differs is known; once.
    void differenceFound(uint64_t replay, const Difference &difference);
    // The replay has come to it and is paused.
    void differenceReached(uint64_t replay);

private:
    struct Worker; // all that belongs to the thread
    using Command = std::function<void(Worker &)>;
    struct Work {
        bool hasInputs; // new ones, in the mailbox
        std::vector<Command> commands;
    };

    void post(Command command);
    Work nextWork(const std::stop_token &stop);
    void work(const std::stop_token &stop);

    uint64_t m_givenCount = 0; // the owner's
    uint64_t m_replayCount = 0;
    uint64_t m_seekCount = 0;
    uint64_t m_ghostCount = 0;
    LatestValue<GivenInputs> m_inputs;
    LatestValue<Snapshot> m_snapshots;
    SampleRing m_samples;
    EventLog m_events;

    std::mutex m_mutex; // guards m_commands
    std::condition_variable_any m_wake;
    std::vector<Command> m_commands;

    std::unique_ptr<Worker> m_worker;
    std::jthread m_thread; // last: ends before anything above it goes
};

} // namespace inspector
