// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace inspector {

/// Thrown inside a command without a window: ends the program with a status and one line.
struct Failure {
    int status;
    QString line;
};

} // namespace inspector
