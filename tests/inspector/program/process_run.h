// SPDX-License-Identifier: MIT
// Runs a program to its end.
#pragma once

#include <QByteArray>
#include <QProcess>

namespace inspector {

struct Ended {
    int status; // -1: crashed, or didn't end
    QByteArray out, messages;
};

inline Ended endOf(QProcess &process) {
    const bool hasEnded = process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit;
    return {hasEnded ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

inline bool isOneLine(const QByteArray &messages) {
    return messages.startsWith("physics-inspector: ") && messages.count('\n') == 1;
}

} // namespace inspector
