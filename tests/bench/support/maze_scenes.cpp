// SPDX-License-Identifier: MIT
#include "support/maze_scenes.h"

#include "generator/board.h"
#include "generator/recipe.h"

#include <cmath>
#include <stdexcept>

namespace bench {

namespace {

double metresOf(mazes::Length length) { return static_cast<double>(length) / 1e9; }

mazes::Board closedBoard(int cells, unsigned seed) {
    constexpr std::int64_t kLoopMillionths = 50'000;
    const mazes::Dimensions dimensions{250 * mazes::kMillimetre, 1000 * mazes::kMillimetre, 200 * mazes::kMillimetre,
                                       500 * mazes::kMillimetre, 200 * mazes::kMillimetre};
    mazes::Random random(seed);
    mazes::CellMaze maze = mazes::carvePerfectMaze(cells, cells, mazes::Algorithm::Backtracker, random);
    mazes::openLoops(maze, kLoopMillionths, random);
    // The rim is closed, unless the exit is part of it.
    const mazes::CellSide nowhere{{-2, -2}, mazes::Side::West};
    return mazes::buildBoard(maze, {cells / 2, cells / 2}, nowhere, dimensions);
}

} // namespace

Scene mazeScene(const MazeSize &size, unsigned seed) {
    const mazes::Board board = closedBoard(size.cells, seed);
    Scene scene;
    scene.name = "maze " + std::to_string(size.cells) + " seed " + std::to_string(seed);
    for (const mazes::Box &box : board.boxes)
        if (box.material == mazes::Material::Rim || box.material == mazes::Material::Wall)
            scene.walls.push_back(
                {metresOf(box.min[0]), metresOf(box.min[1]), metresOf(box.max[0]), metresOf(box.max[1])});
    if (std::ssize(scene.walls) != size.walls)
        throw std::runtime_error(scene.name + ": expected " + std::to_string(size.walls) + " walls, found " +
                                 std::to_string(scene.walls.size()));
    scene.start.position = {metresOf(board.start[0]), metresOf(board.start[1])};
    scene.gravity = randomTilts(seed, static_cast<int>(std::lround(scene.duration / scene.tiltPeriod)));
    return scene;
}

} // namespace bench
