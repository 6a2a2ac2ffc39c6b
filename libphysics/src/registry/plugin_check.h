// SPDX-License-Identifier: MIT
// The requirements on a plugin's table, checked before any of its functions is called.
#pragma once

#include "registry/registry.h"

#include <string>

namespace phys {

/// Checks the whole table of the plugin in `file` against the ABI and against the steppers in the registry. The message
/// names the file, the member, the expected and the found value. Throws std::bad_alloc only.
phys_status checkPlugin(const phys_plugin &plugin, const std::string &file, const phys_registry &registry,
                        phys_error *err);

} // namespace phys
