// SPDX-License-Identifier: GPL-3.0-or-later
// Texts about the program (version, steppers, parameters), and number formats of tables.
#pragma once

#include "core/setup/handles.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace inspector {

/// The shortest decimal that reads back to the same bits, in every locale.
QByteArray exactText(double number);

/// One line of a table, with its line end. Fields are separated by a comma and a space, because gnuplot separates by
/// spaces by default; but there is none in a line that lacks a value: gnuplot then skips that line instead of
/// miscounting its columns.
QByteArray csvLine(const QList<QByteArray> &fields);

/// rolling or rigid
QString modelName(uint32_t model);
/// 16.67 ms
QString stepSizeText(double dt);

/// The program's version, for instance 1.1.0.
const char *programVersion();
/// physics-inspector 1.1.0, libphysics 1.0.0
QString versionLine();

/// The names of a row's choices in lower case, by number; empty if it has none.
QStringList choicesOf(const phys_param_row &row);
/// The values that a row allows, for messages: "rolling or rigid", "a number from 0 to 1 m/s".
QString expectedOf(const phys_param_row &row);

QString stepperTable(const Registry &registry);
QString parameterTable(const std::vector<const phys_param_row *> &rows);

} // namespace inspector
