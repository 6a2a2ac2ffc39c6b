// SPDX-License-Identifier: MIT
// The available steppers: the built-in ones and those of plugins.
#pragma once

#include <physics/plugin.h>

#include <memory>
#include <string>
#include <vector>

namespace phys {

struct PluginStepper {
    const phys_stepper_api *api;
    std::shared_ptr<const std::string> file; ///< shared, because phys_stepper_info points to its text
};

} // namespace phys

struct phys_registry {
    std::vector<phys::PluginStepper> plugins; ///< in the order in which they were loaded
};

namespace phys {

struct FoundStepper {
    const phys_stepper_api *api; ///< nullptr if there is no such stepper
    bool isPlugin;
};

/// The stepper with this id. registry may be nullptr.
FoundStepper findStepper(const phys_registry *registry, const char *id);

} // namespace phys
