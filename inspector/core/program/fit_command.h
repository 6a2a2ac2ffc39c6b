// SPDX-License-Identifier: GPL-3.0-or-later
// A measured ball fitted on the command line.
#pragma once

#include "core/program/options.h"

#include <QIODevice>
#include <QTextStream>

namespace inspector {

// The program's exit status: 0 if a model explains the track; 1 if none does or the table can't be written; 2 if
// something asked for can't be read or fitted; after a signal what is the custom. progress: a terminal, or nullptr.
int runFit(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress);

} // namespace inspector
