// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector {
class Session;
struct Options;
} // namespace inspector

namespace inspector::gl {
class MazeView;
} // namespace inspector::gl

namespace inspector::ui {

/// Writes the run shown in the format of the name's suffix: .rec (a recording that repeats it), .csv (a table of all
/// its samples) or .png (the current view). Returns false, with one line in `error`, on failure.
bool saveRun(Session &session, gl::MazeView &view, const QString &path, QString *error);

/// Writes the settings of a table of the samples from `since` on, s, into the file next to it: level, stepper and
/// parameters that made the rows, see rowSettings(). Returns false, with one line in `error` (may be nullptr), on
/// failure.
bool saveSettingsBeside(Session &session, const QString &csv, double since, QString *error);

/// Writes the table that --csv asks for, of the run shown or, if that has no step yet, of the one before, and beside it
/// what made that run. Returns false, with one line in `error`, on failure.
bool writeTableOfRun(Session &session, const Options &options, QString *error);

/// One line if what was saved under this name is a recording or a table without the run's first steps, or a recording
/// of a maze that has changed since; otherwise empty.
QString remarkOnSaved(Session &session, const QString &path);

} // namespace inspector::ui
