// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the command line with their help.
#pragma once

#include <physics/physics.h>

#include <QString>

#include <vector>

class QCommandLineParser;

namespace inspector {

/// An id in the spelling of options: rolling-friction for rolling_friction.
QString dashed(QString id);

/// The name of a parameter's option, without the dashes before it.
QString optionName(const phys_param_row &row);

/// Adds all options. rows: those of the parameters, which become options, too.
void addOptions(QCommandLineParser &parser, const std::vector<const phys_param_row *> &rows);

/// Which of the given options don't go together, in one line; empty if all do. What depends on an option's value or on
/// the file to open is checked where that is read.
QString conflictOf(const QCommandLineParser &parser);

} // namespace inspector
