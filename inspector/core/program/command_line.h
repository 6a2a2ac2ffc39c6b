// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of the command line to Options. Parameters become options by their rows.
#pragma once

#include "core/program/options.h"

#include <QStringList>

namespace inspector {

struct CommandLine {
    Options options;
    // If set the program ends with this status, after `output` to standard output and `error` (one line) to standard
    // error: 0 after help, version and lists, 2 after wrong use.
    std::optional<int> exitStatus;
    QString output;
    QString error;
};

// arguments: the program's name first. Loads the plugins named. Needs a QCoreApplication.
CommandLine parseCommandLine(const QStringList &arguments);

// Whether these arguments call for no window; may be asked before any application object exists.
bool isWindowless(int argc, const char *const *argv);

} // namespace inspector
