// SPDX-License-Identifier: GPL-3.0-or-later
// Fits a measured ball on the command line.
#pragma once

#include "core/program/options.h"

#include <QIODevice>
#include <QTextStream>

namespace inspector {

/// Returns the exit status: 0 if a model explains the track; 1 if none does or the table can't be written; 2 if
/// something can't be read or fitted; after a signal as in statusAfter(). progress: a terminal, or nullptr.
int runFit(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress);

} // namespace inspector
