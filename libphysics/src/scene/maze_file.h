// SPDX-License-Identifier: MIT
// Reads a maze text file; the format is described in libphysics/docs/maze_format.md.
#pragma once

#include "scene/scene.h"

#include <string_view>

namespace phys {

/// Reads, checks and makes the scene. Throws std::bad_alloc only.
phys_status loadScene(const char *path, Scene &out, phys_error *err);

/// Like loadScene, from the file's text; name: used in messages.
phys_status parseScene(std::string_view text, const char *name, Scene &out, phys_error *err);

} // namespace phys
