// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the thread that steps: the live ball, and a replay that is shown in its place.
#pragma once

#include "core/engine/rate_meter.h"
#include "core/simulation/simulation.h"

#include <limits>
#include <optional>

namespace inspector {

struct Simulation::Worker {
    Simulation &owner;
    Engine engine;
    uint32_t stepper = 0; // index in the registry
    Pacer pacer{};
    RateMeter meter{};
    double speed = 1.0;
    bool running = false;
    uint64_t run = 0;
    uint64_t published = 0;
    uint64_t obeyed = 0; // number of the inputs that count
    uint64_t impacts = 0;
    double stepTime = 0.0; // of the last live one, us
    std::optional<Recorder> recorder{};
    std::optional<Companion> companion{};
    uint64_t companionNumber = 0;
    double leftAt = std::numeric_limits<double>::infinity();  // when the ball left the maze, s
    double pauseAt = std::numeric_limits<double>::infinity(); // s
    // A replay is shown in place of the engine's ball.
    struct Seek {
        uint64_t position, number;
    };
    std::optional<Player> player{};
    uint64_t replay = 0;          // its number
    std::optional<Seek> sought{}; // to be shown as soon as all before it is checked
    uint64_t seeks = 0;           // number of the last one done
    bool areSamplesHeld = false;  // a place sought is being shown
    double pacedDt = 0.0;         // s
    // What was played, kept; a replay may show that in place of a recording.
    History history{};
    std::optional<Past> past{};
    uint64_t liveRun = 0;  // where the live run began, in the history
    uint64_t shownRun = 0; // the one that samples and events are of

    const Engine &shown() const { return player ? player->engine() : engine; }
    bool isChecking() const { return player && !player->isChecked(); }
    void setOrigin(const Origin &origin);
    void obey(const GivenInputs &given);
    void startPacing();
    void setRunning(bool isRunning);
    void beginRun();
    void step(Clock::time_point due);
    void noteStep();
    void replayStep(Clock::time_point due);
    std::optional<uint64_t> differenceAt() const;
    void checkAhead();
    void goToSought();
    bool showUpTo(uint64_t position);
    void holdSamples();
    void releaseSamples();
    ReplayPlace replayPlace() const;
    void goOnLive(uint64_t number);
    uint64_t pastPlace() const { return past->begin + player->position(); }
    void pastStep(Clock::time_point due);
    void showPastRun();
    void refillSamples(uint64_t first);
    void leavePast();
    std::optional<Ghost> pastGhost() const;
    HistoryPlace historyPlace() const;
    void record(const QString &failure);
    void dropBadRecorder();
    void endRecording();
    void leadCompanion();
    void noteEvents();
    void noteLeaving();
    void publish(Clock::time_point due);
};

} // namespace inspector
