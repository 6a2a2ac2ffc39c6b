// SPDX-License-Identifier: MIT
// How steeply a camera looks down.
#pragma once

#include "gl/orbit_camera.h"

#include <cmath>

namespace support {

/// rad, above the horizon, from where its eye is.
inline double elevationOf(const inspector::gl::OrbitCamera &camera) {
    return std::asin((camera.eye().z - camera.target().z) / camera.distance());
}

constexpr double kElevationRounding = 1e-6; // near the zenith an arcsine has half the digits

} // namespace support
