// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ball can leave the maze.
#pragma once

#include <physics/physics.h>

#include <optional>
#include <vector>

namespace inspector {

/// A thin box on the floor at each place where the ball, from its start, can roll out of the maze. Nothing if that
/// can't be determined: the ball starts in a wall, or the maze is too large to search in half a second.
std::optional<std::vector<phys_box>> exitsOf(const phys_scene *scene);

} // namespace inspector
