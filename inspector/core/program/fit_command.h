// SPDX-License-Identifier: GPL-3.0-or-later
// Fits a measured ball on the command line.
#pragma once

#include "core/program/options.h"
#include "core/track/track_fit.h"

#include <QByteArray>
#include <QIODevice>
#include <QStringList>
#include <QTextStream>

namespace inspector {

/// The text beside a fit's table: what the fit began with, and its report. Of the options: level, settings, and those
/// of a measured ball but for the frame.
QByteArray fitSettings(const Options &options, const FitPlan &plan, const QStringList &report);

/// Returns the exit status: 0 if a model explains the track; 1 if none does or the table can't be written; 2 if
/// something can't be read or fitted; after a signal as in statusAfter(). progress: a terminal, or nullptr.
int runFit(const Options &options, QIODevice &out, QTextStream &messages, QTextStream *progress);

} // namespace inspector
