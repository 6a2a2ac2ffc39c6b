// SPDX-License-Identifier: MIT
#pragma once

#include "generator/files.h"

#include <filesystem>
#include <vector>

namespace mazes {

// The levels of the game, from easy to hard.
std::vector<Recipe> levelRecipes();

// FOLDER/01.obj .mtl .scad .txt and so on
std::vector<OutputFile> levelFiles(const std::filesystem::path &folder);

} // namespace mazes
