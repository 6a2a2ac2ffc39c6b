// SPDX-License-Identifier: GPL-3.0-or-later
// Reads stored values defensively: the file may have been written by another version, edited or damaged.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

class QSettings;

namespace inspector {

/// An integer 0 .. count - 1: one of `count` choices.
std::optional<int> storedChoice(const QSettings &settings, const QString &key, int count);
/// A finite number above 0.
std::optional<double> storedTime(const QSettings &settings, const QString &key);
/// What storeBytes() stored; empty if it is damaged.
QByteArray storedBytes(const QSettings &settings, const QString &key);

void storeBytes(QSettings &settings, const QString &key, const QByteArray &bytes);

} // namespace inspector
