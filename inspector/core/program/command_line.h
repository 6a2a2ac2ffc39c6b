// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line into Options. Parameters become options generated from their rows.
#pragma once

#include "core/program/options.h"

#include <QStringList>

namespace inspector {

struct CommandLine {
    Options options;
    /// If set, the program ends with this status, after printing `output`: 0 after help, version and lists, 2 after
    /// wrong use.
    std::optional<int> exitStatus;
    QString output;
    QString error; ///< for standard error: what was wrong, or one line for each plugin that was skipped
};

/// arguments: program name first; file names by decodePath(). Loads plugins by `load`, and checks that output files can
/// be opened, without changing them. Needs a QCoreApplication.
CommandLine parseCommandLine(const QStringList &arguments, PluginLoader load = loadPlugin);

} // namespace inspector
