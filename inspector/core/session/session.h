// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector without its window: ties everything together that is open. The user interface keeps no copy of this
// state.
#pragma once

#include "core/program/options.h"
#include "core/session/comparison.h"
#include "core/session/game.h"
#include "core/session/growing_registry.h"
#include "core/session/hand_tilt.h"
#include "core/session/level_selection.h"
#include "core/session/live_uncertainty.h"
#include "core/session/look_ahead.h"
#include "core/session/playback.h"
#include "core/session/run_history.h"
#include "core/session/run_start.h"
#include "core/setup/handles.h"
#include "core/setup/parameters.h"
#include "core/simulation/departure.h"
#include "core/simulation/simulation.h"

#include <QObject>
#include <QSettings>

#include <memory>
#include <vector>

namespace inspector {

/// Stepper, step size and their settings.
struct Stepping {
    QByteArray stepper;             ///< id
    double dt = Engine::kDefaultDt; ///< s
    std::vector<Setting>
        settings; ///< the model (unchanged if left out) and the stepper's own rows (initial if left out)
    bool operator==(const Stepping &) const = default;
};

enum class Direction { Back, On };

/// The position of the moment shown in its run.
struct RunPlace {
    uint64_t begin = 0;
    uint64_t end = 0;
    uint64_t place = 0;
    bool isCut = false; ///< steps before `begin` aren't kept any more
};

class Session : public QObject {
    Q_OBJECT

public:
    /// Opens what the options ask for. Null, with one line in `error`, if something is missing or invalid. settings:
    /// best times and the window's; must outlive the session.
    static std::unique_ptr<Session> open(const Options &options, QSettings &settings, QString *error);

    Parameters &parameters() { return m_parameters; }
    Simulation &simulation() { return *m_simulation; }
    Game &game() { return m_game; }
    Comparison &comparison() { return *m_comparison; }
    const RunStart &start() const { return m_start; }
    const RunHistory &history() const { return m_history; }
    LookAhead &lookAhead() { return m_lookAhead; }
    LiveUncertainty &liveUncertainty() { return m_liveUncertainty; }
    QSettings &settings() { return m_settings; }
    const LevelSelection &levels() const { return m_levels; }
    const Level &level() const { return m_levels.open(); } ///< of the moment shown
    const Scene &scene() const { return m_levels.scene(); }
    const Registry &registry() const { return m_registry.now(); }
    QByteArray stepperId() const { return m_stepperId; }
    double dt() const { return m_dt; }
    Stepping stepping() const; ///< complete, with all settings
    double speed() const { return m_speed; }
    bool hasAutopilot() const { return m_hasAutopilot; }
    /// Why a win at this moment would not count as a best time, in a few words; empty if it would.
    QString whyNoBestTime();
    /// Of the run shown, up to the moment shown.
    std::optional<Departure> departure(const Snapshot &now) const;
    std::optional<Departure> departure() const; ///< of all its samples
    /// Whether the live ball has left the maze and fallen as far as is shown.
    bool hasEnded(const Snapshot &now) const;
    /// s since the start, as a stopwatch shows it: it stops when the ball leaves the maze.
    double stopwatch(const Snapshot &now) const;

    /// On failure each returns false, changes nothing and emits failed() with one line.
    bool openLevel(const Level &level); ///< pauses at its start; a level of the list also becomes the game's
    bool setStepping(const Stepping &stepping);
    bool setSpeed(double speed);
    /// Adds the steppers of this file to the registry.
    bool loadPlugin(const QString &file);
    bool setAutopilot(bool isOn); ///< on: takes over from the current state; off: levels the board

    /// The ball back to the start, or a recording to its beginning; a running game goes on, another one is prompted.
    void restart();

    /// Records from the next step on, until stopRecording(), a write error, or the end of the session.
    void startRecording(const QString &file);
    void stopRecording();
    bool isRecording() const { return m_isRecording; }

    // ---- recordings, played in place of the live ball ----

    /// Plays a recording from its beginning. On failure returns false, changes nothing and emits failed() with one
    /// line.
    bool openRecording(const QString &path);
    /// Returns to the level that was open before, at its start, with its parameters.
    void closeRecording();
    /// Ends the replay; the game continues from the moment shown, with its parameters.
    void goOnFromHere();
    bool isReplaying() const { return m_replay.has_value(); }
    /// Of the recording; null while there is none. Level, stepper, dt and parameters are those of the last moment
    /// passed to followReplay().
    Playback *replay() { return m_replay ? &m_replay->playback : nullptr; }
    /// Sets level, stepper, dt and parameters to those of the moment shown; called about 30 times a second.
    void followReplay(const Snapshot &now);

    // ---- placing the ball ----

    /// Puts the ball there, paused; begins a new run, and the one before stays in the history. In the past, the past is
    /// taken over first.
    void placeBall(const phys_state &state);
    /// Takes a placing back: `before` is the moment at which it was done. The run that it ended goes on, paused, unless
    /// steps were made since.
    void putBallBack(const Snapshot &before);
    /// Where restarts put the ball; empty: at the maze's start. Reset when another level is opened.
    void setStart(const std::optional<phys_state> &start);
    /// Whether the ball was moved away from its start by hand and hasn't moved since: a game would begin there.
    bool isBallPut() const;

    // ---- a measured ball, overlaid on the run; dropped with another level ----

    /// The track is hidden while another maze than its own is shown.
    void showTrack(std::shared_ptr<const ShownTrack> track); ///< or nullptr
    std::shared_ptr<const ShownTrack> track() const;         ///< null while it is hidden
    /// On: begins a run where the measured ball was first seen, under the track's tilts; a track should begin at 0 for
    /// this. Off (a tilt key does this, too): the player controls the board. False if the track has no tilts.
    bool followTrack(bool isOn);
    bool isFollowingTrack() const { return m_followsTrack; }

    // ---- a run of the history, laid beside the others ----

    /// Compares this run, named by its begin, with any other of its maze; empty: none. It is repeated meanwhile.
    void layBeside(std::optional<uint64_t> begin);
    /// What to show in pale colours beside the run shown: that run, or what followed the moment that was last taken
    /// over. Never null; ascending times.
    std::shared_ptr<const std::vector<Sample>> samplesBeside() const;

    // ---- the past: the history of what was played, which can be shown and taken over ----

    bool isInPast() const { return m_past.has_value(); }
    RunPlace runPlace();
    /// Shows this place in the history, paused; the end of the live run is the present.
    void lookAt(uint64_t place);
    /// The same by time in the run shown, s, also in that of a recording; nothing if it has no step yet.
    void lookAtTime(double time);
    /// Shows the nearest of these times, s, ascending, of the run shown, that is a step or more before or after the
    /// moment shown, or the one that will be. Nothing if there is none.
    std::optional<double> lookAtNearest(const std::vector<double> &times, Direction direction);
    /// Whether the place or the position last asked for is shown by now.
    bool showsWhatIsSought() const;
    void returnToPresent();
    /// If the live run has no step yet, shows the end of the one before, paused, and waits until it is shown.
    void lookAtLastSteps();
    /// Returns when the moment of the past that was last asked for is shown, with its settings.
    void awaitMoment();
    /// The game continues from the moment shown, paused. Any change of the physics has the same effect.
    void takeOver();
    /// What made the steps of the run shown, and those before it that its samples begin with if it continues another.
    std::vector<SettingsSpan> settingsSpans();
    /// The maze of the run shown if its file has changed since: a recording of that run can't be replayed with it.
    std::optional<MazeSource> changedMaze();
    /// Writes the run shown as a recording. Returns false, with one line in `error`, if that fails.
    bool saveRun(const QString &path, QString *error);

    /// The game's arrow keys: which are held, and the time since the last call (about 60 times a second). While a key
    /// is held, and until the board is level again, the tilt parameters follow the keys.
    void setKeys(TiltKeys keys) { m_tilt.setKeys(keys); }
    void advanceKeys(double seconds);
    bool isTiltedByKeys() const { return m_tilt.isByKeys(); }
    /// Whether the autopilot or the measured ball's table sets the tilt, so that the parameters' tilt has no effect.
    bool isTiltedByPilot() const { return m_hasAutopilot || m_followsTrack; }

signals:
    void levelOpened();
    void stepperChanged();
    void steppersAdded();
    void paceChanged(); ///< dt or speed changed
    void autopilotChanged(bool isOn);
    void trackChanged();                       ///< the track, or whether it is followed
    void failed(const QString &line);          ///< a command failed
    void recordingFailed(const QString &line); ///< and has ended; the simulation continues
    void recordingChanged(bool isOn);
    void replayChanged(bool isOn);
    void pastChanged(bool isIn);
    void olderMazeOpened(const QString &path); ///< by taking over a run; the next start reads the file
    void takenOver();                          ///< the past was; the run that was shown stays in the history
    void runLeft();                            ///< the ball was placed by hand; the run before stays in the history
    void ballPutBack();                        ///< to where it was before it was placed
    void replayDiffers(const QString &line); ///< emitted when it is found, and when it is reached and the replay pauses

private:
    Session(const Options &options, QSettings &settings, const Scene &scene, const Stepper &stepper);

    void showPrompt();
    void startGame();
    void endGame(const Departure &departure);
    bool report(const QString &line); ///< sends failed(); returns false
    bool refuseInReplay();
    /// Like the public functions, but without signals; a failure may leave the change incomplete.
    bool useStepper(const QByteArray &id, QString *error);
    bool useDt(double dt, QString *error);
    bool useStepping(const Stepping &stepping, QString *error);
    void watchPhysics();
    bool fly(QString *error);
    void noticeOlderMaze(const PlayableRecording &recording, size_t segment);
    void endTakenTilt();
    void sendInputs();
    QStringList openFiles() const;
    void showRecording(bool isOn);
    Origin origin() const;

    struct Replaying {
        Playback playback;
        Level levelBefore;
        Stepping before; ///< with all parameters
    };
    bool startReplay(const QString &path, QString *error);
    void follow(Playback &playback, size_t segment);
    /// The past shown instead of the present.
    struct LookingBack {
        Past past;
        Playback playback; ///< its positions are places, from the first of the past on
        Level level;       ///< these three of the present
        Scene scene;
        Stepping stepping;
    };
    bool lookBack();
    bool isAtPresent(const RunPlace &run) const;
    void watchRuns(const Snapshot &now);
    std::vector<SettingsSpan> settingsSpans(uint64_t begin, uint64_t end);
    void noteDifference(uint64_t replay, const Difference &difference);
    Stepping steppingWithAll() const;
    void show(const Stepping &stepping);
    void leaveReplay();
    void layTrackOver();
    void passTrack();

    QSettings &m_settings;
    GrowingRegistry m_registry;
    LevelSelection m_levels;
    QByteArray m_stepperId;
    double m_dt = Engine::kDefaultDt;
    double m_speed = 1.0;
    bool m_hasAutopilot = false;
    bool m_isRecording = false;
    std::optional<Replaying> m_replay;
    std::optional<LookingBack> m_past;
    bool m_isFollowing = false; ///< parameters are being set to those of the moment shown
    RunStart m_start;
    RunHistory m_history;
    bool m_hasUsualPhysics = true; ///< unchanged since the level was started
    Parameters m_parameters;
    HandTilt m_tilt;
    Game m_game;
    std::unique_ptr<Simulation> m_simulation;
    std::unique_ptr<Comparison> m_comparison;
    LookAhead m_lookAhead;
    LiveUncertainty m_liveUncertainty;
    std::shared_ptr<const ShownTrack> m_track;
    QString m_trackMaze; ///< path
    bool m_followsTrack = false;
};

} // namespace inspector
