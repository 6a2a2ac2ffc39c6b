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

} // namespace inspector::ui
