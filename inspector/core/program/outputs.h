// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a run may write what it is asked to: told before anything runs.
#pragma once

#include "core/program/options.h"

namespace inspector {

// --csv without a file, or with "-".
bool isStandardOutput(const QString &csv);

// What made a table stands beside it, in a file of this name that begins so.
QString settingsFileOf(const QString &csv);
inline constexpr char kSettingsMark[] = "physics-inspector ";

// One line if a file can't be written, is one of the run's inputs or another of its outputs, or is there already and
// not of the kind that takes its place (a recording never is); --force allows the last. Empty if all is well. Changes
// no file.
QString outputProblem(const Options &options);

} // namespace inspector
