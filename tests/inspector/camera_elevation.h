// SPDX-License-Identifier: MIT
// The elevation of a camera.
#pragma once

#include "gl/orbit_camera.h"

#include <cmath>

namespace support {

/// Angle of the eye above the horizon, rad.
inline double elevationOf(const inspector::gl::OrbitCamera &camera) {
    return std::asin((camera.eye().z - camera.target().z) / camera.distance());
}

constexpr double kElevationRounding = 1e-6; // near the zenith an arcsine has half the digits

} // namespace support
