// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of the command line to Options. Parameters become options by their rows.
#pragma once

#include "core/program/options.h"

#include <QStringList>

namespace inspector {

struct CommandLine {
    Options options;
    // If set the program ends with this status, after `output` to standard output: 0 after help, version and lists, 2
    // after wrong use.
    std::optional<int> exitStatus;
    QString output;
    QString error; // for standard error: a line of wrong use, or one for each plugin that was left out
};

// arguments: the program's name first; file names by decodePath(). Loads plugins by `load`, and opens, but doesn't
// change, the files to be written. Needs a QCoreApplication.
CommandLine parseCommandLine(const QStringList &arguments, PluginLoader load = loadPlugin);

} // namespace inspector
