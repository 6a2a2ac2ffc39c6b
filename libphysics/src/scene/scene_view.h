// SPDX-License-Identifier: MIT
// What a stepper sees of a scene: phys_scene_view.
#pragma once

#include "scene/scene.h"

#include <physics/plugin.h>

namespace phys {

/// Valid as long as the scene.
phys_scene_view viewOf(const Scene &scene);

} // namespace phys
