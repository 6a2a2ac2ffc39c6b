// SPDX-License-Identifier: GPL-3.0-or-later
// What a settings file says, if it makes sense: it may be of another version of the program, edited or damaged.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

class QSettings;

namespace inspector {

// A whole number 0 .. count - 1: one of so many choices.
std::optional<int> storedChoice(const QSettings &settings, const QString &key, int count);
// A finite number above 0.
std::optional<double> storedTime(const QSettings &settings, const QString &key);
// What storeBytes() stored, empty if it isn't whole.
QByteArray storedBytes(const QSettings &settings, const QString &key);

void storeBytes(QSettings &settings, const QString &key, const QByteArray &bytes);

} // namespace inspector
