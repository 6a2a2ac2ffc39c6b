// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace phys {

/// Per mass, J/kg: model.md 9.
double energyOf(const Scene &scene, const phys_params &params, const phys_state &state);

} // namespace phys
