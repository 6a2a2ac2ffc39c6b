// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector {
class Session;
} // namespace inspector

namespace inspector::gl {
class MazeView;
} // namespace inspector::gl

namespace inspector::ui {

// Writes the run shown as what the name's ending says: .rec (a recording that repeats it), .csv (a table of all its
// samples) or .png (the view as it is now, alone). False and one line in `error` if that fails.
bool saveRun(Session &session, gl::MazeView &view, const QString &path, QString *error);

// What made a table: level, stepper and parameters as they are now, and which samples there still are; in a file beside
// it. False and one line in `error` (or nullptr) if that can't be written.
bool saveSettingsBeside(Session &session, const QString &csv, QString *error);

// One line if a table of all samples lacks the run's first ones; else empty.
QString lostSamples(Session &session, const QString &path);

} // namespace inspector::ui
