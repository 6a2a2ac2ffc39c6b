// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace inspector {

class Session;

/// What made the rows of a table of the samples from `since` on, s: the settings of the first row, a line each, then a
/// line for each setting that changes, "from 1.06 s: dt 0.001 s", with the time of the first row that it made. A tilt
/// that varies isn't listed: it has a column.
QByteArray rowSettings(Session &session, double since);

} // namespace inspector
