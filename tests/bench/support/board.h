// SPDX-License-Identifier: MIT
// Owners of what the library creates; failures are thrown as std::runtime_error with the library's own line.
#pragma once

#include "support/scene.h"

#include <filesystem>
#include <memory>
#include <string>

namespace bench {

struct Free {
    void operator()(phys_scene *scene) const { phys_scene_destroy(scene); }
    void operator()(phys_stepper *stepper) const { phys_stepper_destroy(stepper); }
};
using ScenePointer = std::unique_ptr<phys_scene, Free>;
using StepperPointer = std::unique_ptr<phys_stepper, Free>;

void check(phys_status status, const phys_error &error);

// The scene's walls on a floor that reaches beyond them.
ScenePointer createScene(const Scene &scene);
ScenePointer loadScene(const std::filesystem::path &file);

// For engines in two dimensions: walls are the boxes that rise above the centre of a ball at the start.
Scene topView(const phys_scene &scene);

// The scene must outlive the stepper.
StepperPointer createStepper(const std::string &id, const phys_scene &scene);

} // namespace bench
