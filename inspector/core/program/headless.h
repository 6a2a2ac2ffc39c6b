// SPDX-License-Identifier: GPL-3.0-or-later
// Runs without a window: an Engine stepped as fast as possible.
#pragma once

#include "core/engine/engine.h"
#include "core/program/options.h"
#include "core/simulation/departure.h"

#include <QTextStream>

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

/// The engine that the options describe, at the level's start. Null, with one line in `error`, if it can't be made.
std::unique_ptr<Engine> makeEngine(const Options &options, const Level &level, QString *error);

struct Outcome {
    QString startFault;            ///< what is wrong with the start, which makes a win impossible; else empty
    std::optional<Departure> left; ///< how the ball left the maze
    double time = 0.0;             ///< s, simulated, at the end
    uint64_t steps = 0;
    double seconds = 0.0; ///< wall-clock time
    QString error;        ///< why a step failed; else empty

    bool isWon() const { return startFault.isEmpty() && left && left->side == BoardSide::Beside; }
    double stepsPerSecond() const { return seconds > 0.0 ? double(steps) / seconds : 0.0; }
};

/// Steps until the ball is out of the maze (unless `goesOn`) or `duration` is reached; passes each step to `visit`,
/// which ends the run by returning false.
struct Limits {
    double duration; ///< s, simulated
    bool goesOn;     ///< continue after the ball left the maze
};
Outcome play(Engine &engine, const Limits &limits, const std::function<bool(const Engine &)> &visit);

/// Runs as the options say. Tables go to `out`, messages to `messages`. Returns the exit status: 0; 1 if the run
/// failed, the autopilot didn't win or a table can't be written; 2 if something can't be opened; after a signal as in
/// statusAfter(). Losses of `out` are for its owner to report. progress: a terminal, or nullptr.
int runHeadless(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress);

} // namespace inspector
