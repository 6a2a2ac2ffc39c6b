// SPDX-License-Identifier: MIT
#include "generator/levels.h"

#include <iterator>

namespace mazes {

namespace {

struct LevelRow {
    std::uint64_t seed;
    int width;
    int height;
    Algorithm algorithm;
    std::int64_t loopMillionths;
};

// The seeds were chosen so that the way out grows from level to level: the table in mazes/README.md has its lengths.
constexpr LevelRow kLevelRows[] = {
    {7, 4, 4, Algorithm::Backtracker, 0},
    {2, 5, 4, Algorithm::Wilson, 0},
    {13, 5, 5, Algorithm::Backtracker, 0},
    {15, 6, 6, Algorithm::Kruskal, 0},
    {23, 7, 6, Algorithm::Wilson, 0},
    {37, 8, 7, Algorithm::Backtracker, 80'000},
    {11, 9, 8, Algorithm::Wilson, 0},
    {19, 10, 9, Algorithm::Kruskal, 0},
    {13, 12, 10, Algorithm::Backtracker, 50'000},
    {2, 14, 12, Algorithm::Wilson, 0},
};

std::string numbered(std::size_t level) { return (level < 10 ? "0" : "") + std::to_string(level); }

} // namespace

std::vector<Recipe> levelRecipes() {
    std::vector<Recipe> recipes;
    recipes.reserve(std::size(kLevelRows));
    for (const LevelRow &row : kLevelRows)
        recipes.push_back({row.seed, row.width, row.height, row.algorithm, row.loopMillionths, {}});
    return recipes;
}

std::vector<OutputFile> levelFiles(const std::filesystem::path &folder) {
    std::vector<OutputFile> files;
    for (const Recipe &recipe : levelRecipes()) {
        const std::string name = numbered(files.size() / 4 + 1);
        for (OutputFile &file : mazeFiles(recipe, makeMaze(recipe), folder / name)) files.push_back(std::move(file));
    }
    return files;
}

} // namespace mazes
