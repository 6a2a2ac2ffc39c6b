// SPDX-License-Identifier: GPL-3.0-or-later
// The format of the settings file: keys and text, and nothing that Qt makes objects of. Its own reader builds whatever
// a value names (`@Variant`, `@ByteArray`), as large as it says, so that a damaged file ended the program.
//
//     window/quality="2"
//     window/recent="/a.txt", "/b.txt"      a list
//
// In keys `%` and two or four (`%U`) hexadecimal digits are a character, in values `\\`, `\"`, `\n`, `\r`, `\t` and
// `\x` and up to four digits. `[section]` lines and bare values, as of earlier versions, are read. Lines that are none
// of this, and values in Qt's syntax for objects, are left out: their keys have their defaults.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>

namespace inspector {

// For the constructor of QSettings, which writes by a temporary file under a lock. What it writes of a value is its
// text: bytes are stored by storeBytes() (stored_values.h). A file that is larger than a megabyte counts as empty.
QSettings::Format settingsFormat();

// The user's own, as QSettings names it. Of what QSettings would wait for without end, one line in `problem`, and a
// name that can't be opened: settings then last as long as the program.
QString userSettingsFile(QString *problem);

// What the format does, for tests.
QSettings::SettingsMap readSettings(const QByteArray &bytes);
QByteArray writeSettings(const QSettings::SettingsMap &settings);

} // namespace inspector
