// SPDX-License-Identifier: MIT
// The steppers that can be made: the built-in ones and those that plugins brought.
#pragma once

#include <physics/plugin.h>

#include <memory>
#include <string>
#include <vector>

namespace phys {

struct PluginStepper {
    const phys_stepper_api *api;
    std::shared_ptr<const std::string> file; ///< its text stays where it is: phys_stepper_info points at it
};

} // namespace phys

struct phys_registry {
    std::vector<phys::PluginStepper> plugins; ///< in the order in which they were loaded
};

namespace phys {

struct FoundStepper {
    const phys_stepper_api *api; ///< nullptr if there is none
    bool isPlugin;
};

/// The stepper with this id. registry may be nullptr.
FoundStepper findStepper(const phys_registry *registry, const char *id);

} // namespace phys
