// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"
#include "mesh/obj_text.h"

#include <optional>

#include <QString>

namespace inspector::gl {

/// Reads a Wavefront .obj with its .mtl files. `problem` (not null) gets one line: file, line number if there is one,
/// expected and found text. Returns nothing on failure; otherwise `problem` says what was left out of the mesh, or is
/// empty.
std::optional<Mesh> loadMesh(const QString &path, QString *problem);

/// The same from memory; the line begins after the file's name: "7: expected ...".
std::optional<Mesh> parseMesh(const QByteArray &text, const MaterialSource &materials, QString *problem);

} // namespace inspector::gl
