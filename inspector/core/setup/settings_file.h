// SPDX-License-Identifier: GPL-3.0-or-later
// The format of the settings file, which holds only keys and text. Qt's own reader constructs any object that a value
// names (`@Variant`, `@ByteArray`), of any size, so that a damaged file could end the program.
//
//     window/quality="2"
//     window/recent="/a.txt", "/b.txt"      a list
//
// In keys, `%` and two or four (`%U`) hexadecimal digits stand for a character; in values `\\`, `\"`, `\n`, `\r`, `\t`
// and `\x` with up to four digits do. `[section]` lines and unquoted values, as earlier versions wrote them, are read.
// Other lines, and values in Qt's syntax for objects, are ignored: their keys have their defaults.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>

namespace inspector {

/// For the constructor of QSettings, which writes through a temporary file under a lock. Values are written as text;
/// store bytes by storeBytes() (stored_values.h). A file larger than a megabyte counts as empty.
QSettings::Format settingsFormat();

/// The user's settings file, as QSettings names it. If QSettings would block on that file, returns a name that can't be
/// opened, with one line in `problem`: settings then last as long as the program.
QString userSettingsFile(QString *problem);
/// The file of such settings as the user knows it.
QString shownFileOf(const QSettings &settings);

/// Writes and reads the format; public for tests.
QSettings::SettingsMap readSettings(const QByteArray &bytes);
QByteArray writeSettings(const QSettings::SettingsMap &settings);

} // namespace inspector
