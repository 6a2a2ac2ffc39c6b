// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace inspector {

class Session;

/// Describes how the rows of a table of the samples from `since` on, s, were made, as RunSettings does, and their span.
QByteArray rowSettings(Session &session, double since);

} // namespace inspector
