// SPDX-License-Identifier: MIT
// Calls a plugin's table as a host does, and reports each breach of plugin.h.
#pragma once

#include <string>
#include <vector>

namespace plugin_check {

/// One line for each breach; empty if there is none. file: path of the plugin.
std::vector<std::string> breaches(const std::string &file, const std::string &stepper);

} // namespace plugin_check
