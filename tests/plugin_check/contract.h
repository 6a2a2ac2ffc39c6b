// SPDX-License-Identifier: MIT
// Calls a plugin's table as a host would, and says each thing in which it breaks what plugin.h asks of it.
#pragma once

#include <string>
#include <vector>

namespace plugin_check {

/// One line for each breach; empty if there is none. file: path of the plugin.
std::vector<std::string> breaches(const std::string &file, const std::string &stepper);

} // namespace plugin_check
