// SPDX-License-Identifier: MIT
// Vectors of doubles, and conversions from and to the C structs.
#pragma once

#include "base/ieee_doubles.h"

#include <physics/physics.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace phys {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

inline Vec3 toVec(const phys_vec3 &v) { return {v.x, v.y, v.z}; }
inline phys_vec3 fromVec(const Vec3 &v) { return {v.x, v.y, v.z}; }
inline Vec2 inPlane(const Vec3 &v) { return {v.x, v.y}; }
inline Vec2 inPlane(const phys_vec3 &v) { return {v.x, v.y}; }

/// Angular velocity of a ball that rolls on the floor with velocity v: z x v / R, model.md 0. Its zeros are never
/// negative, so that adding them to another spin changes no bit.
inline Vec3 rollingSpin(const Vec2 &v, double radius) { return {0.0 - v.y / radius, 0.0 + v.x / radius, 0.0}; }

/// The velocity of a ball that rolls with this angular velocity: w = R (om x z), model.md 0.
inline Vec2 spinSpeed(const Vec3 &spin, double radius) { return {radius * spin.y, -radius * spin.x}; }

} // namespace phys
