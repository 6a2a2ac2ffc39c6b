// SPDX-License-Identifier: MIT
// A board as the contents of files. Every writer keeps the order of the board's boxes.
#pragma once

#include "generator/board.h"

#include <string>
#include <string_view>

namespace mazes {

// The boxes for programs: the format of libphysics/docs/maze_format.md. `generator` is one line of free text.
std::string textFile(const Board &board, std::string_view generator);

// The boxes for display: one object per box, with bevelled edges inside the box's bounds. `materialFile` is the name of
// the .mtl file beside it, without white space.
std::string meshFile(const Board &board, std::string_view generator, std::string_view materialFile);
std::string meshMaterialFile();

// The boxes for a 3D printer, in millimetres: an OpenSCAD program.
std::string scadFile(const Board &board, std::string_view generator);

// A ball of radius 1 with three colours that show rotation about any axis.
std::string ballMeshFile(std::string_view materialFile);
std::string ballMaterialFile();

} // namespace mazes
