// SPDX-License-Identifier: MIT
// The arguments of mazegen.
#pragma once

#include "generator/recipe.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mazes {

struct Command {
    bool help = false;
    bool version = false;
    std::optional<Recipe> maze;
    std::filesystem::path prefix; // where the maze goes
    std::optional<std::filesystem::path> levelsFolder;
    std::optional<std::filesystem::path> ballFolder;
};

// One line: the option, the expected and the found value.
class OptionError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Arguments without the program's name. Throws OptionError.
Command parseCommandLine(const std::vector<std::string_view> &arguments);

std::string helpText();

} // namespace mazes
