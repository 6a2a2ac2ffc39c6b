// SPDX-License-Identifier: GPL-3.0-or-later
// Untrusted text (names of files, words of a command line, lines of a file) made fit to be shown in one line.
#pragma once

#include <QString>
#include <QTextStream>

namespace inspector {

// Control characters, line breaks and marks that turn the direction of text as escapes (\n, \x1b, \u202e).
QString oneLine(const QString &text);
// The same between single quotes; the middle of a text that is longer than 200 characters is left out.
QString quoted(const QString &text);

// "physics-inspector: LINE", as one line whatever it quotes.
void report(QTextStream &messages, const QString &line);

} // namespace inspector
