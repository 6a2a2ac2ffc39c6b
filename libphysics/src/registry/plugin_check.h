// SPDX-License-Identifier: MIT
// What a plugin's table must be before any of its functions is called.
#pragma once

#include "registry/registry.h"

namespace phys {

/// Checks the whole table of the plugin in `file` against the ABI and against the steppers that the registry has.
/// The reason names the file, the member, what was expected and what was found. Throws std::bad_alloc only.
phys_status checkPlugin(const phys_plugin &plugin, const char *file, const phys_registry &registry, phys_error *err);

} // namespace phys
