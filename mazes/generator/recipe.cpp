// SPDX-License-Identifier: MIT
#include "generator/recipe.h"

#include "generator/numbers.h"

namespace mazes {

Maze makeMaze(const Recipe &recipe) {
    Random random(recipe.seed);
    CellMaze cells = carvePerfectMaze(recipe.width, recipe.height, recipe.algorithm, random);
    openLoops(cells, recipe.loopMillionths, random);
    const Cell entrance{0, 0};
    const CellSide exit = farthestOuterSide(cells, entrance);
    Board board = buildBoard(cells, entrance, exit, recipe.dimensions);
    return {std::move(cells), entrance, exit, std::move(board)};
}

int wayLength(const Maze &maze) {
    return maze.cells.distancesFrom(maze.entrance)[maze.cells.indexOf(maze.exit.cell)] + 1;
}

std::string generatorLine(const Recipe &recipe) {
    std::string line = "mazegen " + std::to_string(kGeneratorVersion);
    const auto add = [&line](std::string_view option, const std::string &value) {
        line.append(" ").append(option).append(" ").append(value);
    };
    add("--seed", std::to_string(recipe.seed));
    add("--cells", std::to_string(recipe.width) + "x" + std::to_string(recipe.height));
    add("--algorithm", std::string(algorithmName(recipe.algorithm)));
    add("--loops", millionths(recipe.loopMillionths));
    add("--ball-radius", metres(recipe.dimensions.ballRadius));
    add("--pitch", metres(recipe.dimensions.pitch));
    add("--wall-thickness", metres(recipe.dimensions.wallThickness));
    add("--wall-height", metres(recipe.dimensions.wallHeight));
    add("--floor-thickness", metres(recipe.dimensions.floorThickness));
    return line;
}

} // namespace mazes
