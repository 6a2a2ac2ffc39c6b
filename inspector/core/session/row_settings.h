// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace inspector {

class Session;

/// Describes how the rows of a table of the samples from `since` on, s, were made: the settings of the first row, one
/// per line, then a line for each setting that changes, "from 1.06 s: dt 0.001 s", with the time of the first row to
/// which it applies. A tilt that varies isn't listed, as it has a column. Last comes the samples' span.
QByteArray rowSettings(Session &session, double since);

} // namespace inspector
