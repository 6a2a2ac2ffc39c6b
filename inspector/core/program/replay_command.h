// SPDX-License-Identifier: GPL-3.0-or-later
// What --replay does without a window.
#pragma once

#include "core/program/options.h"

#include <QIODevice>
#include <QTextStream>

namespace inspector {

// Does what --replay asks for: the table to `out` or --csv, the verdict to `messages`; with --check the verdict to
// `out`, a table only to --csv. The program's exit status: 0 if all is the same; 1 if a step differs or the table can't
// be written; 2 if the recording can't be followed.
int runReplay(const Options &options, QIODevice &out, QTextStream &messages);

} // namespace inspector
