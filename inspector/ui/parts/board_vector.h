// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <physics/physics.h>

#include <glm/vec3.hpp>

namespace inspector::ui {

/// A vector of the board frame as a glm vector.
inline glm::dvec3 toGlm(const phys_vec3 &v) { return {v.x, v.y, v.z}; }

} // namespace inspector::ui
