// SPDX-License-Identifier: MIT
// The steppers that can be made: the built-in ones and those that plugins brought.
#pragma once

#include <physics/plugin.h>

#include <span>
#include <string>
#include <vector>

namespace phys {

/// From crude to exact.
std::span<const phys_stepper_api *const> builtInSteppers();

struct PluginStepper {
    const phys_stepper_api *api;
    std::string file;
};

} // namespace phys

struct phys_registry {
    std::vector<phys::PluginStepper> plugins; ///< in the order in which they were loaded
};

namespace phys {

/// The stepper with this id, or nullptr. registry may be nullptr.
const phys_stepper_api *findStepper(const phys_registry *registry, const char *id);

} // namespace phys
