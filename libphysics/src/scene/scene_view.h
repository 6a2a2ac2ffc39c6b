// SPDX-License-Identifier: MIT
// A stepper's view of a scene: phys_scene_view.
#pragma once

#include "scene/scene.h"

#include <physics/plugin.h>

namespace phys {

/// Valid as long as the scene exists.
phys_scene_view viewOf(const Scene &scene);

} // namespace phys
