// SPDX-License-Identifier: GPL-3.0-or-later
// An Engine on a thread of its own, at a fixed dt. Neither thread blocks the other: inputs go in through a latest-wins
// mailbox, states come out through a latest-value slot, samples through a ring; commands are executed between two
// steps.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/ghost_engine.h"
#include "core/events/event_log.h"
#include "core/recording/history.h"
#include "core/recording/player.h"
#include "core/recording/recorder.h"
#include "core/simulation/departure.h"
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

/// Inputs arrive through a mailbox and with commands: the number tells which were given last.
struct GivenInputs {
    Inputs inputs;
    uint64_t number = 0;
};

class Simulation : public QObject {
    Q_OBJECT

public:
    static constexpr double kSlowest = 1.0 / 16.0; ///< simulated seconds per second
    static constexpr double kFastest = 16.0;

    /// Starts paused at the scene's start. origin: for the events' stepper, and for the recorder.
    Simulation(const Scene &scene, const Stepper &stepper, const Origin &origin = {}, QObject *parent = nullptr);
    ~Simulation() override; ///< ends the thread

    /// Commands, from the thread that owns this object; they return at once and take effect before the next step.
    void run();
    void pause();
    void pauseAt(double time); ///< s: pauses when the ball has reached this time, in whole steps; the live ball only
    void stepOnce();           ///< pauses, too
    void restart();            ///< at the scene's start; goes on running or stays paused
    /// Pauses at the new scene's start. origin: as above.
    void setScene(const Scene &scene, const Stepper &stepper, const Origin &origin = {});
    /// Continues from the same state; the stepper must be made for the same scene. Takes inputs, because a stepper's
    /// own values don't fit another. origin: for the recorder and the ghost, if there are any.
    void setStepper(const Stepper &stepper, const Inputs &inputs, const Origin &origin = {});
    void setState(const phys_state &state);
    /// Continues this run at its end if no step was made since; otherwise sets the state.
    void resume(const HistoryPlace &run, const phys_state &state);
    void setStart(const std::optional<phys_state> &start); ///< of restarts; empty: the scene's
    void setDt(double dt);                                 ///< s, > 0
    void setSpeed(double speed); ///< clamped to kSlowest .. kFastest; changes the number of steps per second, never dt
    /// A measured ball whose positions go into samples from the next step on, of runs in these scenes; or nullptr.
    void setTrack(std::shared_ptr<const ShownTrack> track, std::vector<Scene> scenes);
    void setPilot(std::shared_ptr<const Pilot> pilot); ///< or nullptr: the inputs' tilt counts
    /// Records every step from now on, replacing an earlier recording, until one can't be written.
    void startRecording(const QString &file, const Origin &origin);
    void stopRecording();

    /// A ghost starts at the ball's state and follows it, replacing an earlier ghost. It starts over at a restart and
    /// when a state is set; another scene removes it. leaderId: of the current stepper. Returns the ghost's number, as
    /// in comparisonRefused().
    uint64_t compareWith(const GhostSetup &setup, const QByteArray &leaderId);
    /// Takes effect from the next step on; empty: the ball's inputs. Returns the ghost's new number.
    uint64_t setGhostInputs(const std::optional<Inputs> &own);
    void endComparison();

    /// Shows a recording, which must have steps, paused at its beginning; the live ball waits. Returns the replay's
    /// number, as in its snapshots. run(), pause(), stepOnce(), restart() and setSpeed() then act on the replay.
    uint64_t startReplay(std::shared_ptr<const PlayableRecording> recording);
    /// Shows this position as soon as everything before it is checked; stays running or paused. Returns the seek's
    /// number: the snapshot says how many are done.
    uint64_t seek(uint64_t position);
    void stepBack();  ///< pauses, too
    void endReplay(); ///< returns to the live ball, paused
    /// The live ball continues from this position of the replay, under its conditions; stays running or paused.
    void goOnFrom(uint64_t position, const Origin &origin);

    /// The history of [from, to), or all of it; nothing, with one line in `error`, if it can't be replayed. Waits until
    /// the current step is finished.
    std::optional<Past> past(QString *error, uint64_t from = 0, uint64_t to = UINT64_MAX);
    /// Shows the history of the live ball, which waits, paused at its end; like a replay, but samples and events remain
    /// those of the whole run shown. Returns its number.
    uint64_t lookBack(const Past &past);
    /// Returns to the live ball, paused and unchanged.
    void returnToPresent();

    /// Latest wins; takes effect from the next step on.
    void setInputs(const Inputs &inputs);

    /// The newest snapshot. Values that belong together must be taken from one. The owner's thread only.
    Snapshot latest();
    /// All samples of this run. Any thread.
    const SampleRing &samples() const { return m_samples; }
    /// The events of this run. Any thread.
    const EventLog &events() const { return m_events; }

signals: // queued: sent by the stepping thread, and received in the order in which things happened
    /// A step failed; the simulation is paused at the state before it. line: the library's message.
    void failed(const QString &line);
    /// A restart, another scene, or a state was set: earlier problems are obsolete.
    void runBegan();
    /// The ball has left the maze. It keeps falling for a while, then the simulation pauses.
    void leftMaze(const Departure &departure);
    void runningChanged(bool running);
    /// The recording can't be written and ends; the simulation continues.
    void recordingFailed(const QString &line);
    /// The ghost's stepper refused a step; there is no ghost until it starts over. The simulation continues.
    void comparisonRefused(uint64_t ghost, const QString &line);
    /// The first differing step of this replay was found; sent once.
    void differenceFound(uint64_t replay, const Difference &difference);
    /// The replay has reached the difference and is paused.
    void differenceReached(uint64_t replay);

private:
    struct Worker; ///< everything that the stepping thread owns
    using Command = std::function<void(Worker &)>;
    struct Work {
        bool hasInputs; ///< new ones, in the mailbox
        std::vector<Command> commands;
    };

    void post(Command command);
    Work nextWork(const std::stop_token &stop);
    void work(const std::stop_token &stop);

    uint64_t m_givenCount = 0; ///< owner's thread only
    uint64_t m_replayCount = 0;
    uint64_t m_seekCount = 0;
    uint64_t m_ghostCount = 0;
    LatestValue<GivenInputs> m_inputs;
    LatestValue<Snapshot> m_snapshots;
    SampleRing m_samples;
    EventLog m_events;

    std::mutex m_mutex; ///< guards m_commands
    std::condition_variable_any m_wake;
    std::vector<Command> m_commands;

    std::unique_ptr<Worker> m_worker;
    std::jthread m_thread; ///< last member: it is joined before the others are destroyed
};

} // namespace inspector
