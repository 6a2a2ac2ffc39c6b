// SPDX-License-Identifier: GPL-3.0-or-later
// When and where the ball leaves the maze, which ends a game.
#pragma once

#include "core/simulation/sample_ring.h"

#include <QString>

#include <optional>

namespace inspector {

enum class BoardSide {
    Within,
    Beside, ///< seen from above, the centre is outside the bounds of all boxes, as for PHYS_OUT
    Below,  ///< within these, below the lowest box: the ball has fallen through a hole
};
BoardSide boardSide(const phys_scene *scene, const phys_vec3 &centre);

/// What is wrong with this place of the centre as a start, in a few words; empty if nothing is.
QString startFault(const phys_scene *scene, const phys_vec3 &centre);

/// How long the ball keeps falling after it left the maze, s of simulated time.
constexpr double kFallTime = 0.4;

/// The first step that left the maze.
struct Departure {
    double time = 0.0; ///< s
    BoardSide side = BoardSide::Beside;
};

/// That of the run up to `time`, s; nothing if the ball isn't outside then. samples: of the run, in this scene.
std::optional<Departure> departure(const SampleRing &samples, const phys_scene *scene, double time);

} // namespace inspector
