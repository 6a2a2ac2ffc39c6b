// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the inputs of a recording through the library again and compares the hash of every state.
#pragma once

#include "options.h"
#include "recording.h"

#include <QTextStream>

#include <functional>
#include <optional>

namespace inspector {

// The first step whose result isn't the recorded one.
struct Difference {
    uint64_t number = 0; // of the recording's steps, from 1
    uint64_t step = 0;   // since the start or restart, as phys_state.step
    double time = 0.0;   // s, at its beginning
    QString expected;    // a hash, or a failure's line
    QString found;
};

struct ReplayOutcome {
    uint64_t steps = 0; // that ran
    std::optional<Difference> difference;
    QString error; // why the recording can't be followed: its file, line and reason; empty if it can
};

// Shows each step to `visit`, which ends the replay by returning false. A maze is looked for where the recording says,
// then beside the recording, then among the levels; one with the recorded hash is taken.
ReplayOutcome replay(const Recording &recording, const Registry &registry, const std::vector<Level> &levels,
                     const std::function<bool(const Engine &)> &visit);

// "same: 812 steps", or what differs first and, in the same line, which versions differ.
QString verdict(const Recording &recording, const Registry &registry, const ReplayOutcome &outcome);

// Does what --replay asks for: the table to `out` or --csv, the verdict to `messages`; with --check the verdict to
// `out`, a table only to --csv. The program's exit status: 0 if all is the same; 1 if a step differs or the table can't
// be written; 2 if the recording can't be followed.
int runReplay(const Options &options, QIODevice &out, QTextStream &messages);

} // namespace inspector
