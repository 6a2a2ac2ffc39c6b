// SPDX-License-Identifier: MIT
// Writes files as a whole or not at all.
#pragma once

#include "generator/recipe.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace mazes {

struct OutputFile {
    std::filesystem::path path;
    std::string content;
};

// PREFIX.obj .mtl .scad .txt
std::vector<OutputFile> mazeFiles(const Recipe &recipe, const Maze &maze, const std::filesystem::path &prefix);

// FOLDER/ball.obj .mtl
std::vector<OutputFile> ballFiles(const std::filesystem::path &folder);

// One line: the file, what was tried, the system's reason.
class FileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Writes all under temporary names in the same folder, then renames all. Throws FileError, with the temporaries
// removed.
void writeFiles(const std::vector<OutputFile> &files);

} // namespace mazes
