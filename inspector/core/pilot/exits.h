// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ball can leave the maze.
#pragma once

#include <physics/physics.h>

#include <vector>

namespace inspector {

// A thin box on the floor at each place where the ball, from its start, can roll out of the maze; none if it can't, or
// if there are so many boxes that looking for it takes long.
std::vector<phys_box> exitsOf(const phys_scene *scene);

} // namespace inspector
