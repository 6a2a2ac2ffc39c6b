// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a run's output files before anything runs.
#pragma once

#include "core/program/options.h"

namespace inspector {

/// --csv without a file, or with "-".
bool isStandardOutput(const QString &csv);

/// The name of the file next to a table that holds its settings.
QString settingsFileOf(const QString &csv);
inline constexpr char kSettingsMark[] = "physics-inspector ";

/// Returns one line if a file can't be written, is one of the run's inputs or another of its outputs, or exists and
/// isn't of the kind that may be overwritten (a recording never is); --force lifts the last condition. Returns an empty
/// text otherwise. Changes no file.
QString outputProblem(const Options &options);

} // namespace inspector
