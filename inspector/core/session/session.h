// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector without its window: what is open, joined together. Whoever shows it holds nothing of it.
#pragma once

#include "core/pilot/tilt_control.h"
#include "core/program/options.h"
#include "core/session/ball_place.h"
#include "core/session/comparison.h"
#include "core/session/game.h"
#include "core/session/live_uncertainty.h"
#include "core/setup/handles.h"
#include "core/setup/levels.h"
#include "core/setup/parameters.h"
#include "core/simulation/simulation.h"
#include "core/simulation/way_ahead.h"
#include "core/trade/unknowns.h"

#include <QObject>
#include <QSettings>

#include <memory>
#include <vector>

namespace inspector {

// How steps are made.
struct Stepping {
    QByteArray stepper;             // id
    double dt = Engine::kDefaultDt; // s
    std::vector<Setting> settings;  // the model, which stays if left out; the stepper's own, initial if left out
    bool operator==(const Stepping &) const = default;
};

// A run that is kept, from a start, a restart or the moment that it was taken over from.
struct KeptRun {
    uint64_t begin = 0; // steps since the program began
    uint64_t end = 0;
    Level level;
    QByteArray stepper; // id, at its end
    double dt = 0.0;    // s, at its end
    double time = 0.0;  // s, at its end
    bool isOut = false; // it got out of the maze
};

// Where the moment shown is in its run.
struct RunPlace {
    uint64_t begin = 0; // steps since the program began
    uint64_t end = 0;
    uint64_t first = 0; // that shows this run: where another ends, one more
    uint64_t place = 0;
};

class Session : public QObject {
    Q_OBJECT

public:
    // Opens what the options ask for. Null and one line in `error` if something isn't there or isn't allowed.
    // settings: best times and the window's; outlives the session.
    static std::unique_ptr<Session> open(const Options &options, QSettings &settings, QString *error);

    Parameters &parameters() { return m_parameters; }
    Simulation &simulation() { return *m_simulation; }
    Game &game() { return m_game; }
    Comparison &comparison() { return *m_comparison; }
    LiveUncertainty &liveUncertainty() { return m_liveUncertainty; }
    QSettings &settings() { return m_settings; }
    const std::vector<Level> &levels() const { return m_levels; }
    const Level &level() const { return m_level; } // that is open; maybe a file that isn't in the list
    bool isLevelOfTheList() const { return levelIndex() >= 0; }
    const Scene &scene() const { return m_scene; } // of that level
    const Registry &registry() const { return m_registry; }
    // Places of the maze's floor where the ball gets out; nothing if that can't be found. Looked for once.
    const std::optional<std::vector<phys_box>> &exits();
    QByteArray stepperId() const { return m_stepperId; }
    double dt() const { return m_dt; }
    Stepping stepping() const; // with all its settings
    double speed() const { return m_speed; }
    bool hasAutopilot() const { return m_hasAutopilot; }
    // Why a win now is none for the list of best times, in a few words; empty if it is one.
    QString whyNoBestTime() const;

    // Each returns false, changes nothing and sends failed() with one line if it can't be done.
    bool openLevel(const Level &level); // paused at its start; a level of the list also becomes the game's
    bool setStepper(const QByteArray &id);
    bool setDt(double dt); // s, Engine::kSmallestDt .. kLargestDt
    bool setStepping(const Stepping &stepping);
    bool setSpeed(double speed);
    // The steppers of this file are there from now on, behind the others.
    bool loadPlugin(const QString &file);
    bool setAutopilot(bool isOn); // it flies from the present state on; off: the board goes level

    // Records from the next step on, until it is stopped, can't be written or the session ends.
    void startRecording(const QString &file);
    void stopRecording();
    bool isRecording() const { return m_isRecording; }

    // ---- recordings are watched in place of the live ball ----

    // Plays a recording from its beginning. False, nothing changed and failed() with one line if that can't be done.
    bool openRecording(const QString &path);
    // Back to the level that was open before, at its start, with the parameters from before.
    void closeRecording();
    // Ends the replay; the game goes on from the moment shown, with its parameters.
    void goOnFromHere();
    bool isReplaying() const { return m_replay.has_value(); }
    // Of the replay, while there is one; level, stepper, dt and parameters are those of the moment last followed.
    const PlayableRecording &recording() const { return *m_replay->recording; }
    // Level, stepper, dt and parameters become those of the moment shown; called about 30 times a second.
    void followReplay(const Snapshot &now);
    // Where the replay is, or is about to be; nothing before its first picture.
    std::optional<ReplayPlace> replayPlace(const Snapshot &now) const;
    void seek(uint64_t position);
    // "same", "same so far" or what differs first, in one line.
    QString replayVerdict(const Snapshot &now) const;

    // ---- the ball in one's hand ----

    // Puts the ball there, paused; a new run begins. In the past that one is taken over first.
    void placeBall(const phys_state &state);
    // Where a restart brings the ball to; nothing: to the maze's start. Forgotten with another level.
    void setStart(const std::optional<phys_state> &start);
    bool hasOwnStart() const { return m_hasOwnStart; }

    // ---- a measured ball, laid over the run; forgotten with another level ----

    void showTrack(std::shared_ptr<const ShownTrack> track); // or nullptr
    const std::shared_ptr<const ShownTrack> &track() const { return m_track; }
    // On: a run begins where the track's ball was first seen, under the tilts that the track has; best with one that
    // begins at 0. Off, and also at a key that tilts: the board is the player's again. False if it has no tilts.
    bool followTrack(bool isOn);
    bool isFollowingTrack() const { return m_followsTrack; }

    // Where the ball goes from the moment shown if nothing changes; empty while it isn't asked for.
    void showWayAhead(bool isOn);
    const WayAhead &wayAhead() const { return m_way; }
    // Makes it that of the moment shown, for a picture: otherwise it comes a little later.
    void lookAheadAtOnce();
    uint64_t waysAhead() const { return m_ways; } // another number: another way
    // Beside it, while the simulation stands, the ways on boards as they may really be.
    void showOthersAhead(bool isOn);
    // What isn't known of the board; the usual of a board built by hand until told.
    const Unknowns &unknowns() const { return m_unknowns; }
    void setUnknowns(const Unknowns &unknowns);

    // ---- the past: what was played lately is kept, and can be gone back to ----

    bool isInPast() const { return m_past.has_value(); }
    RunPlace runPlace();
    // Shows this place of any run that is kept, paused; the end of the live run is the present.
    void lookAt(uint64_t place);
    // The same by the time in the run shown, s.
    void lookAtTime(double time);
    void returnToPresent();
    // The game goes on from the moment shown, paused as it is. Whatever changes the physics does the same.
    void takeOver();
    // Oldest first; the last is the live one.
    const std::vector<KeptRun> &runs() const { return m_runs; }
    // What had come after the moment that was taken over last, thinned out.
    const std::vector<Sample> &oldFuture() const { return m_oldFuture; }
    // Writes the run shown as a recording. False and one line in `error` if that can't be done.
    bool saveRun(const QString &path, QString *error);

    // Keys of the game: arrow keys as held, and the time since the last call (about 60 times a second). While a key is
    // held, and until the board is level again, the tilt parameters follow the keys.
    void setKeys(TiltKeys keys) { m_tiltControl.setKeys(keys); }
    void advanceKeys(double seconds);
    bool isTiltedByKeys() const { return m_keysTilt; }

signals:
    void levelOpened();
    void stepperChanged();
    void steppersAdded();
    void paceChanged(); // dt or speed
    void autopilotChanged(bool isOn);
    void trackChanged();                       // another one, or whether it is followed
    void failed(const QString &line);          // a command
    void recordingFailed(const QString &line); // and ended; the simulation goes on
    void recordingChanged(bool isOn);
    void replayChanged(bool isOn);
    void pastChanged(bool isIn);
    void replayDiffers(const QString &line); // when it is known, and when it is reached and the replay pauses

private:
    Session(const Options &options, QSettings &settings, const Scene &scene, const Stepper &stepper);

    int levelIndex() const;    // in the list; -1 for a file that isn't in it
    QString otherMaze() const; // such a file's, for the game; empty for a level of the list
    void showPrompt();
    bool report(const QString &line); // sends it; always false
    bool refuseInReplay();
    // As the public ones, but nothing is sent; a failure may leave part of a stepping in use.
    bool useStepper(const QByteArray &id, QString *error);
    bool useDt(double dt, QString *error);
    bool useStepping(const Stepping &stepping, QString *error);
    void watchPhysics();
    bool fly(QString *error);
    void levelBoard();
    void setTilt(Tilt tilt);
    void sendInputs();
    void showRecording(bool isOn);
    Origin origin() const;

    struct Replaying {
        std::shared_ptr<const PlayableRecording> recording;
        uint64_t number; // as in snapshots
        Level levelBefore;
        Stepping before;               // with all parameters
        std::optional<size_t> segment; // last followed
        uint64_t sought = 0;           // position
        uint64_t seeks = 0;            // number of the last one
        QString difference;            // the line
    };
    bool startReplay(const QString &path, QString *error);
    void follow(const PlayableRecording &recording, std::optional<size_t> &followed, size_t segment);
    // What is shown instead of the present.
    struct LookingBack {
        Past past;
        uint64_t number; // as in snapshots
        Level level;     // these three of the present
        Scene scene;
        Stepping stepping;
        std::optional<size_t> segment; // last followed
        uint64_t sought = 0;           // place
        uint64_t seeks = 0;            // number of the last one
    };
    bool lookBack();
    bool isAtPresent(const RunPlace &run) const;
    void watchRuns(const Snapshot &now);
    void lookAhead(const Snapshot &now);
    void askAnew();
    std::vector<OtherBoard> otherBoards(const Snapshot &now) const;
    void keepOldFuture(uint64_t place);
    void noteDifference(uint64_t replay, const Difference &difference);
    Stepping steppingWithAll() const;
    void show(const Stepping &stepping);
    void leaveReplay();

    QSettings &m_settings;
    Registry m_registry;
    PluginLoader m_pluginLoader;
    std::vector<Registry> m_registriesBefore; // rows and names of theirs are in use
    std::vector<Level> m_levels;
    Level m_level;
    Scene m_scene;
    Scene m_exitsOf; // that m_exits are of
    std::optional<std::vector<phys_box>> m_exits;
    QByteArray m_stepperId;
    double m_dt = Engine::kDefaultDt;
    double m_speed = 1.0;
    bool m_hasAutopilot = false;
    bool m_isRecording = false;
    TiltControl m_tiltControl;
    std::optional<Replaying> m_replay;
    std::optional<LookingBack> m_past;
    bool m_isFollowing = false; // parameters change because the moment shown does
    bool m_hasOwnStart = false;
    bool m_showsWay = false;
    bool m_showsOthers = false;
    Unknowns m_unknowns;
    uint64_t m_askedFor = 0; // moment: of a snapshot, with or without others
    WayAhead m_way;
    uint64_t m_ways = 0;
    std::vector<KeptRun> m_runs;
    std::vector<Sample> m_oldFuture;
    uint64_t m_oldFutureRun = 0;   // of snapshots: with another one it is forgotten
    bool m_isTakenOver = false;    // from a replay: such a run sets no record
    bool m_hasUsualPhysics = true; // since the level was started
    bool m_keysTilt = false;       // the board's tilt is the keys' just now
    Parameters m_parameters;
    Game m_game;
    std::unique_ptr<Simulation> m_simulation;
    std::unique_ptr<Comparison> m_comparison;
    WayFinder m_wayFinder;
    LiveUncertainty m_liveUncertainty;
    std::shared_ptr<const ShownTrack> m_track;
    bool m_followsTrack = false;
};

} // namespace inspector
