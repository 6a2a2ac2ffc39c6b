// SPDX-License-Identifier: MIT
// The small scenes of the comparison, each for one question; the mazes are in maze_scenes.h.
#pragma once

#include "support/scene.h"

namespace bench {

// Rolls from rest down 5 degrees for 2 s: the order of the smooth motion.
Scene inclineScene();

// To and fro between two walls on a level board, restitution 0.8, 10 s.
Scene bounceScene();

// A room on a level board, restitution 1, 10 s: impacts alone.
Scene billiardScene();

// The ball hits a convex corner off centre; compared is its position 1 s later.
Scene edgeScene();

// 300 m/s into a wall 0.2 m thick, from one of `phases` distances that fill one step of 10 ms.
Scene fastScene(int phase, int phases);

// At rest in a corner of two walls, under a tilt that presses it there, 10 s.
Scene restScene();

} // namespace bench
