// SPDX-License-Identifier: MIT
// The built-in steppers, each with the same table as a plugin. They guarantee more than a plugin: `in` and `out` may be
// the same; `out` is written only on success, and completely except for time and step; err may be NULL; view->scene is
// a phys::Scene.
#pragma once

#include <physics/plugin.h>

namespace phys {

extern const phys_stepper_api kExplicitEuler;
extern const phys_stepper_api kSymplecticEuler;
extern const phys_stepper_api kVelocityVerlet;
extern const phys_stepper_api kRk4;
extern const phys_stepper_api kSwept;
extern const phys_stepper_api kExact;

/// From crude to exact.
inline constexpr const phys_stepper_api *kBuiltIn[] = {
    &kExplicitEuler, &kSymplecticEuler, &kVelocityVerlet, &kRk4, &kSwept, &kExact,
};

} // namespace phys
