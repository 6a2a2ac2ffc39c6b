// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/mesh.h"

#include <optional>

#include <QString>

namespace inspector::gl {

// Reads a Wavefront .obj with the .mtl it names. On failure returns nothing and sets `error` (not null) to one line:
// file, line where there is one, what was expected, what was found.
std::optional<Mesh> loadMesh(const QString &path, QString *error);

} // namespace inspector::gl
