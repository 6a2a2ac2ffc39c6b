// SPDX-License-Identifier: MIT
// A run without a window, started as the program starts it from its command line.
#pragma once

#include "core/program/command_line.h"
#include "core/program/headless.h"

#include <QBuffer>
#include <QByteArrayList>
#include <QStringList>
#include <QTextStream>

namespace inspector {

struct Result {
    int status;
    QByteArray out;
    QString messages;
    QString progress; // as a terminal gets it

    QByteArrayList rows() const {
        return out.trimmed().split('\n').mid(1); // without the header
    }
};

inline Result runOf(const QStringList &words) {
    const CommandLine line = parseCommandLine(QStringList{"physics-inspector"} + words);
    if (line.exitStatus) return {*line.exitStatus, {}, line.error, {}};
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    QString text;
    QTextStream messages(&text);
    QString shown;
    QTextStream progress(&shown);
    const int status = runHeadless(line.options, out, messages, &progress);
    return {status, out.data(), text, shown};
}

} // namespace inspector
