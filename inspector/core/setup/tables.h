// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says of itself in text: version, steppers, parameters.
#pragma once

#include "core/setup/handles.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace inspector {

// The shortest decimal that reads back as the same number, bit by bit; the same in every locale.
QByteArray exactText(double number);

// Fields of a table, with its end. After each comma a blank, by which gnuplot separates unless it is told otherwise;
// but none in a line that lacks a value: gnuplot then leaves that line out, instead of counting its columns wrong.
QByteArray csvLine(const QList<QByteArray> &fields);

// rolling or rigid
QString modelName(uint32_t model);
// 16.67 ms
QString stepSizeText(double dt);

// Of this program: 1.1.0.
const char *programVersion();
// physics-inspector 1.1.0, libphysics 1.0.0
QString versionLine();

// The choices of a row in lower case, in the order of their numbers; empty if it isn't a choice.
QStringList choicesOf(const phys_param_row &row);
// The values that a row allows, for people: "rolling or rigid", "a number from 0 to 1 m/s".
QString expectedOf(const phys_param_row &row);

QString stepperTable(const Registry &registry);
QString parameterTable(const std::vector<const phys_param_row *> &rows);

} // namespace inspector
