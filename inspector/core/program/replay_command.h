// SPDX-License-Identifier: GPL-3.0-or-later
// Implements --replay without a window.
#pragma once

#include "core/program/options.h"

#include <QIODevice>
#include <QTextStream>

namespace inspector {

/// Replays a recording: the table goes to `out` or --csv, the verdict to `messages`; with --check the verdict goes to
/// `out`, and a table only to --csv. Returns the exit status: 0 if all is the same; 1 if a step differs or the table
/// can't be written; 2 if the recording can't be replayed.
int runReplay(const Options &options, QIODevice &out, QTextStream &messages);

} // namespace inspector
