// SPDX-License-Identifier: GPL-3.0-or-later
// Validates a Wavefront .obj and its .mtl line by line and writes them anew, so that whatever is in the files, the
// loader only gets lines of a known form with numbers and indices in range.
#pragma once

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>

namespace inspector::gl {

/// Larger coordinates are refused, m: floats can't be drawn precisely there.
inline constexpr double kLargestCoordinate = 1e6;

struct CheckedObj {
    QByteArray shapes;    ///< v, vn, f, o and usemtl lines; materials are named m0, m1, ...
    QByteArray materials; ///< newmtl m0 and its Kd, Ks, Ke and Ns lines, and so on
    QString note;         ///< the first thing that was left out, with its line number; empty if nothing was
};

/// Returns a material file's bytes by its name in the .obj; nothing, with the reason in `error`, if they can't be read.
using MaterialSource = std::function<std::optional<QByteArray>(const QString &name, QString *error)>;

/// Accepts what common tools write: comments, continued lines, any line ends, a byte order mark, names with spaces,
/// several material files, colours after a vertex, lines and points (ignored). For a wrong number or index, or no face
/// at all, returns nothing, and `error` gets "LINE: expected ..., found ...".
std::optional<CheckedObj> checkObj(const QByteArray &text, const MaterialSource &materials, QString *error);

} // namespace inspector::gl
