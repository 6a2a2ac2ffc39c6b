// SPDX-License-Identifier: GPL-3.0-or-later
// Runs without a window: an Engine stepped by hand, as fast as it goes.
#pragma once

#include "core/engine/engine.h"
#include "core/program/options.h"

#include <QTextStream>

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

// The engine that the options describe, at the level's start. Null and one line in `error` if it can't be made.
std::unique_ptr<Engine> makeEngine(const Options &options, const Level &level, QString *error);

struct Outcome {
    std::optional<double> outAt; // s, simulated, when the ball left the maze
    double time = 0.0;           // s, simulated, at the end
    uint64_t steps = 0;
    double seconds = 0.0; // of the clock
    QString error;        // a step's failure; empty if there was none

    bool isOut() const { return outAt.has_value(); }
    double stepsPerSecond() const { return seconds > 0.0 ? double(steps) / seconds : 0.0; }
};

// Steps until the ball is out of the maze (unless `goesOn`) or so much time is simulated; shows each step to `visit`,
// which ends the run by returning false.
struct Limits {
    double duration; // s, simulated
    bool goesOn;     // after the ball left the maze
};
Outcome play(Engine &engine, const Limits &limits, const std::function<bool(const Engine &)> &visit);

// Does what the options ask for. Tables go to `out`, messages to `messages`. The program's exit status: 0; 1 if the run
// failed, the autopilot didn't win or a table can't be written; 2 if something asked for can't be opened; after a
// signal what is the custom. What `out` lost is for its owner to tell. progress: a terminal, or nullptr.
int runHeadless(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress);

} // namespace inspector
