// SPDX-License-Identifier: GPL-3.0-or-later
// Untrusted text (file names, words of a command line, lines of a file) made safe to show in one line.
#pragma once

#include <QString>
#include <QTextStream>

namespace inspector {

/// Escapes control characters, line breaks and marks of text direction (\n, \x1b, \u202e).
QString oneLine(const QString &text);
/// The same between single quotes; texts longer than 200 characters lose their middle.
QString quoted(const QString &text);
/// What was found in place of something expected: the same, or "nothing" without any letter.
QString foundText(const QString &text);

/// Prints "physics-inspector: LINE", escaped to a single line.
void report(QTextStream &messages, const QString &line);

} // namespace inspector
