// SPDX-License-Identifier: MIT
// Owners of what the library creates.
#pragma once

#include <physics/physics.h>

#include <memory>

namespace support {

template<auto destroy>
struct Destroyer {
    template<class T>
    void operator()(T *handle) const {
        destroy(handle);
    }
};

using ScenePtr = std::unique_ptr<phys_scene, Destroyer<phys_scene_destroy>>;
using StepperPtr = std::unique_ptr<phys_stepper, Destroyer<phys_stepper_destroy>>;
using RegistryPtr = std::unique_ptr<phys_registry, Destroyer<phys_registry_destroy>>;

} // namespace support
