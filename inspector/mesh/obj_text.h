// SPDX-License-Identifier: GPL-3.0-or-later
// A Wavefront .obj and its .mtl as text, checked line by line and written anew: what the loader gets consists of lines
// of known form with numbers and indices in range, whatever the files are like.
#pragma once

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>

namespace inspector::gl {

// Coordinates beyond this are refused, m: a picture of floats shows nothing there.
inline constexpr double kLargestCoordinate = 1e6;

struct CheckedObj {
    QByteArray shapes;    // v, vn, f, o and usemtl lines; materials by number: m0, m1, ...
    QByteArray materials; // newmtl m0 and its Kd, Ks, Ke and Ns lines, and so on
    QString note;         // the first thing that was left out, with its line; empty if all is there
};

// Bytes of a material file by its name in the .obj; nothing and the reason if they can't be had.
using MaterialSource = std::function<std::optional<QByteArray>(const QString &name, QString *error)>;

// What tools write is understood: comments, continued lines, any line ends, a byte order mark, names with spaces,
// several material files, colours after a vertex, lines and points (left out). A wrong number or index or no face at
// all: nothing, and `error` gets "LINE: expected ..., found ...".
std::optional<CheckedObj> checkObj(const QByteArray &text, const MaterialSource &materials, QString *error);

} // namespace inspector::gl
